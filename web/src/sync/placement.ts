// Where a model stands: from its file to the stage, and from its own place there to the world.

import { type Bounds, boundsOf, type StageTransform, stageOf } from "../document/stage-transform";
import type { MeshRef } from "../document/types";
import type { ShapedFrame } from "../engine/types";
import type { NamedJoint } from "./named-body";

/** What of a model the solver knows; file units and axes. */
export interface SolverModel {
  /** V x 3. */
  readonly positions: Float32Array;
  /** F x 3. */
  readonly faces: Uint32Array;
  /** Of its file, if it has one. */
  readonly name?: string;
  /** Of the skeleton that its file brings, if it does. */
  readonly joints?: readonly NamedJoint[];
  /** V: which of its limbs a vertex is of, as in limbParts. */
  readonly parts?: Int32Array | null;
}

const BOUNDS = new WeakMap<SolverModel, Bounds>();

/** The transform between the model's file and the stage. */
export function stageFor(model: SolverModel, mesh: MeshRef): StageTransform {
  const bounds = BOUNDS.get(model) ?? boundsOf(model.positions);
  BOUNDS.set(model, bounds);
  return stageOf(bounds, mesh.facing, mesh.up);
}

/** World position and yaw of the model's origin. */
export type Root = ShapedFrame["root"];

/** N x 3 body-local to world; a new array. */
export function toWorld(positions: Float32Array, root: Root): Float32Array {
  const [x, y, z, yaw] = root;
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  const out = new Float32Array(positions.length);
  for (let i = 0; i + 2 < positions.length; i += 3) {
    const px = positions[i];
    const pz = positions[i + 2];
    out[i] = c * px + s * pz + x;
    out[i + 1] = positions[i + 1] + y;
    out[i + 2] = -s * px + c * pz + z;
  }
  return out;
}

/** N x 12 maps, rows of (B | b), body-local to world; a new array. */
export function mapsToWorld(maps: Float32Array, root: Root): Float32Array {
  const [x, y, z, yaw] = root;
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  const out = new Float32Array(maps);
  for (let m = 0; m + 11 < maps.length; m += 12) {
    for (let k = m; k < m + 4; k++) {
      out[k] = c * maps[k] + s * maps[k + 8];
      out[k + 8] = -s * maps[k] + c * maps[k + 8];
    }
    out[m + 3] += x;
    out[m + 7] += y;
    out[m + 11] += z;
  }
  return out;
}

/** N x 3 world to body-local; a new array. */
export function toLocalAll(positions: Float32Array, [x, y, z, yaw]: Root): Float32Array {
  const there = positions.map((value, i) => value - [x, y, z][i % 3]);
  return toWorld(there, [0, 0, 0, -yaw]);
}

/** One world point, body-local. */
export function toLocal(point: readonly [number, number, number], root: Root): [number, number, number] {
  const [x, y, z, yaw] = root;
  const c = Math.cos(yaw);
  const s = Math.sin(yaw);
  const px = point[0] - x;
  const pz = point[2] - z;
  return [c * px - s * pz, point[1] - y, s * px + c * pz];
}
