// The npm library.

export { createBrowserEngine } from "./browser";
export { EngineClient } from "./client";
export type { WorkerPort } from "./client";
export { serve } from "./serve";
export type { ServerPort } from "./serve";
export * from "./types";
