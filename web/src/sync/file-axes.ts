// Which way up files of a kind hold what stands in them. Pure.

import type { FileAxes } from "../util/constants";

/** glTF and what builds on it say so by specification; of the others what most programs write, as far as they agree. */
const AXES: Record<string, FileAxes> = {
  glb: "y_up_by_rule",
  gltf: "y_up_by_rule",
  vrm: "y_up_by_rule",
  obj: "y_up",
  off: "y_up",
  fbx: "y_up",
  dae: "y_up",
  usdz: "y_up",
  stl: "z_up",
  "3mf": "z_up",
};

export function fileAxes(name = ""): FileAxes {
  const kind = name.slice(name.lastIndexOf(".") + 1).toLowerCase();
  return Object.hasOwn(AXES, kind) ? AXES[kind] : "unknown";
}
