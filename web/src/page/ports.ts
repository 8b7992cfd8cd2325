// The app's ports in a page.

import type { Ports } from "../app/ports";
import { createBrowserEngine } from "../engine/browser";
import { readClipsInWorker, readModelInWorker } from "../io/parse-in-worker";
import { assets } from "./assets";
import { clock } from "./clock";
import { files } from "./files";
import { memory } from "./memory";

export const ports: Ports = {
  address: { link: location.hash.slice(1), forget: () => history.replaceState(null, "", location.pathname) },
  assets,
  clock,
  files,
  memory,
  openShelf: () => import("./shelf").then(({ openShelf }) => openShelf()),
  openSound: (song) => import("./sound").then(({ openSound }) => openSound(song)),
  createEngine: createBrowserEngine,
  readModel: readModelInWorker,
  readClips: readClipsInWorker,
  buildSkin: async (...task) => (await import("../engine/skin-in-worker")).buildSkinInWorker(...task),
  buildMorphs: async (...task) => (await import("../engine/skin-in-worker")).buildMorphsInWorker(...task),
  calm: matchMedia("(prefers-reduced-motion: reduce)").matches,
};
