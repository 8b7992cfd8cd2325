// import "rigless" in Node.

import { createNodeEngine } from "../engine/node";
import { type Rigless, RiglessWithEngine } from "./rigless";

export * from "./public";

/** Loads the engine. Keeps the process alive until close(). */
export function createRigless(): Promise<Rigless> {
  return RiglessWithEngine.create(createNodeEngine);
}
