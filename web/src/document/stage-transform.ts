// From a model file's own units and axes to the stage (metres, Y up, facing +Z, standing on y = 0 around x = z = 0) and
// back. The turn is one of the 24 axis-aligned rotations, so bounds stay exact.

import { STAGE_HEIGHT, WIDTH_SHARE } from "../util/constants";
import type { Axis, Vec3 } from "./types";

export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** stage = scale * (rotation * file) + offset. */
export interface StageTransform {
  /** Metres per file unit. */
  readonly scale: number;
  /** 3 x 3, row-major: a signed permutation with determinant +1. */
  readonly rotation: readonly number[];
  /** Metres. */
  readonly offset: Vec3;
}

/** Bounds of N x 3 positions. Zeros if there are none. */
export function boundsOf(positions: ArrayLike<number>): Bounds {
  if (positions.length < 3) return { min: [0, 0, 0], max: [0, 0, 0] };
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 2 < positions.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const x = positions[i + k];
      if (x < min[k]) min[k] = x;
      if (x > max[k]) max[k] = x;
    }
  }
  return { min, max };
}

/** The facing that is used: a model cannot look along its own up axis, so such a pair gets the usual front of that up axis. */
export function facingFor(facing: Axis, up: Axis): Axis {
  if (facing[1] !== up[1]) return facing;
  return up[1] === "z" ? "-y" : "+z";
}

/** The transform that puts a model of these bounds on the stage, STAGE_HEIGHT tall; a wide one is measured by its width. */
export function stageOf(bounds: Bounds, facing: Axis, up: Axis): StageTransform {
  const y = unit(up);
  const z = unit(facingFor(facing, up));
  const x = cross(y, z);
  const rotation = [...x, ...y, ...z];
  const a = rotate(rotation, bounds.min);
  const b = rotate(rotation, bounds.max);
  const extent = (k: number): number => Math.abs(a[k] - b[k]);
  const size = Math.max(extent(1), WIDTH_SHARE * Math.max(extent(0), extent(2)));
  const scale = size > 0 && Number.isFinite(size) ? STAGE_HEIGHT / size : 1;
  const offset: Vec3 = [(-scale * (a[0] + b[0])) / 2, -scale * Math.min(a[1], b[1]), (-scale * (a[2] + b[2])) / 2];
  return { scale, rotation, offset };
}

/** One point of the file, on the stage. */
export function pointToStage(stage: StageTransform, point: Vec3): Vec3 {
  const [x, y, z] = rotate(stage.rotation, point);
  const { scale, offset } = stage;
  return [scale * x + offset[0], scale * y + offset[1], scale * z + offset[2]];
}

/** One point of the stage, in the file's units and axes. */
export function pointFromStage(stage: StageTransform, point: Vec3): Vec3 {
  const { scale, offset, rotation: r } = stage;
  const x = (point[0] - offset[0]) / scale;
  const y = (point[1] - offset[1]) / scale;
  const z = (point[2] - offset[2]) / scale;
  return [r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z];
}

/** N x 3 positions of the file, on the stage; a new array. */
export function toStage({ scale, rotation, offset }: StageTransform, positions: ArrayLike<number>): Float32Array {
  return turned(rotation, positions, scale, offset);
}

/** N x 3 positions of the stage, in the file's units and axes; a new array. */
export function fromStage(stage: StageTransform, positions: ArrayLike<number>): Float32Array {
  return mapPoints(positions, (point) => pointFromStage(stage, point));
}

/** N x 3 directions of the file, in the stage's axes; a new array. */
export function turnToStage({ rotation }: StageTransform, directions: ArrayLike<number>): Float32Array {
  return turned(rotation, directions, 1, [-0, -0, -0]); // which change nothing
}

/** No point is an object: there may be a million. */
function turned([a, b, c, d, e, f, g, h, i]: readonly number[], points: ArrayLike<number>, scale: number, offset: Vec3): Float32Array {
  const out = new Float32Array(points.length);
  const [ox, oy, oz] = offset;
  for (let k = 0; k + 2 < points.length; k += 3) {
    const x = points[k];
    const y = points[k + 1];
    const z = points[k + 2];
    out[k] = scale * (a * x + b * y + c * z) + ox;
    out[k + 1] = scale * (d * x + e * y + f * z) + oy;
    out[k + 2] = scale * (g * x + h * y + i * z) + oz;
  }
  return out;
}

function mapPoints(positions: ArrayLike<number>, map: (point: Vec3) => Vec3): Float32Array {
  const out = new Float32Array(positions.length);
  for (let i = 0; i + 2 < positions.length; i += 3) {
    out.set(map([positions[i], positions[i + 1], positions[i + 2]]), i);
  }
  return out;
}

function unit(axis: Axis): Vec3 {
  const sign = axis[0] === "-" ? -1 : 1;
  return [axis[1] === "x" ? sign : 0, axis[1] === "y" ? sign : 0, axis[1] === "z" ? sign : 0];
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function rotate(r: readonly number[], [x, y, z]: Vec3): Vec3 {
  return [r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z];
}
