// import "rigless" in a page, through a bundler that knows new URL(..., import.meta.url).

import { createBrowserEngine } from "../engine/browser";
import { type Rigless, RiglessWithEngine } from "./rigless";

export * from "./public";

/** Starts the engine in a worker of its own. */
export function createRigless(): Promise<Rigless> {
  return RiglessWithEngine.create(() => Promise.resolve(createBrowserEngine()));
}
