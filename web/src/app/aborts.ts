import { EngineError } from "../engine/types";

/** Whether work ended because somebody called it off, which is no failure. */
export function isAbort(error: unknown): boolean {
  return error instanceof EngineError ? error.code === "cancelled" : error instanceof Error && error.name === "AbortError";
}
