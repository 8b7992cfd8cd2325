// What a bare mesh says of itself. Its module is made for one call and dropped, and its memory with it.

import { engineError, outOfMemory } from "./messages";
import type { ShapeAnalysisInput } from "./protocol";
import { EngineError } from "./types";
import type { AxisName, BodyPoint, BodyRole, ShapeAnalysis } from "./types";
import { instantiateShapeAnalysis } from "./wasm";

/** In the order of rigless::BodyRole. */
const ROLES: readonly BodyRole[] = ["tip", "head", "hand", "foot", "foreleg", "tail", "hips", "chest"];

const MOST_POINTS = 32;
const HEAD = 15;
const ROW = 6;

export function analyseShape({ mesh: { positions, faces }, wasm }: ShapeAnalysisInput): ShapeAnalysis {
  if (positions.length % 3 !== 0 || faces.length % 3 !== 0) {
    throw new EngineError("bad_mesh", "The model's points and triangles do not come in threes.");
  }
  const module = instantiateShapeAnalysis(wasm);
  const lend = (array: Float32Array | Uint32Array): number => {
    const at = module.alloc(Math.max(array.byteLength, 1));
    if (at === 0) throw outOfMemory();
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    new Uint8Array(module.memory.buffer, at, array.byteLength).set(bytes);
    return at;
  };
  const out = module.alloc(8 * (HEAD + ROW * MOST_POINTS));
  const status = module.analyse_shape(lend(positions), positions.length / 3, lend(faces), faces.length / 3, out);
  if (status !== 0) throw engineError(status, { kind: "mesh" });
  return described(new Float64Array(module.memory.buffer, out, HEAD + ROW * MOST_POINTS));
}

function described(numbers: Float64Array): ShapeAnalysis {
  const three = (at: number): [number, number, number] => [numbers[at] ?? 0, numbers[at + 1] ?? 0, numbers[at + 2] ?? 0];
  const [misfit = 0, symmetric = 0, count = 0] = numbers.subarray(12, HEAD);
  return {
    up: axisName(three(0)),
    facing: axisName(three(3)),
    symmetry: symmetric ? { point: three(6), normal: three(9), misfit } : null,
    points: Array.from({ length: count }, (_, n) => point(numbers.subarray(HEAD + ROW * n, HEAD + ROW * (n + 1)))),
  };
}

function point([vertex = 0, role = 0, side = 0, partner = -1, radius = 0, wanted = 0]: Float64Array): BodyPoint {
  return {
    vertex,
    partner,
    radius,
    role: ROLES[role] ?? "tip",
    side: side === 0 ? null : side > 0 ? "left" : "right",
    wanted: wanted !== 0,
  };
}

function axisName([x, y, z]: [number, number, number]): AxisName {
  const sign = x + y + z < 0 ? "-" : "+";
  return `${sign}${x !== 0 ? "x" : y !== 0 ? "y" : "z"}`;
}
