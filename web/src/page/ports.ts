// The app's ports in a page.

import type { Ports } from "../app/ports";
import { createBrowserEngine } from "../engine/browser";
import { readModelInWorker } from "../io/read-model-in-worker";
import { assets } from "./assets";
import { clock } from "./clock";
import { files } from "./files";

export const ports: Ports = {
  assets,
  clock,
  files,
  createEngine: createBrowserEngine,
  readModel: readModelInWorker,
  calm: matchMedia("(prefers-reduced-motion: reduce)").matches,
};
