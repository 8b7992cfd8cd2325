// How stiff a model is where parts of it were said to keep their shape. Not part of the first load: few projects say so.

import type { ProjectDocument } from "../document/types";
import { STAGE_HEIGHT } from "../util/constants";
import { type SolverModel, stageFor } from "./placement";
import { pointVertices } from "./point-controls";

/** Of a stiff part, where the rest is 1: keeps the shape of a head, and does not yet break its neck. */
const STIFF = 10;
/** So much of its radius a part needs to become as soft as the rest. */
const BORDER = 0.2;

/** V, for the engine. */
export function rigidityOf(model: SolverModel, { mesh, stiff = [] }: Pick<ProjectDocument, "mesh" | "stiff">): Float32Array {
  const rigidity = new Float32Array(model.positions.length / 3).fill(1);
  const rings = ringsOf(model);
  const unit = stageFor(model, mesh).scale / STAGE_HEIGHT;
  for (const { position, radius = Infinity } of stiff) {
    const [from] = pointVertices(model, [{ position }]);
    for (const [vertex, distance] of reached(model.positions, rings, from, radius / unit)) {
      const rim = (1 - (distance * unit) / radius) / BORDER;
      const share = radius === Infinity ? 1 : Math.max(0, Math.min(1, rim));
      rigidity[vertex] = Math.max(rigidity[vertex], 1 + share * (STIFF - 1));
    }
  }
  return rigidity;
}

/** V + 1 into the neighbours of each vertex, which are there once per face. */
interface Rings {
  readonly first: Uint32Array;
  readonly neighbors: Uint32Array;
}

function ringsOf({ positions, faces }: SolverModel): Rings {
  const first = new Uint32Array(positions.length / 3 + 1);
  for (const v of faces) first[v + 1] += 2;
  for (let v = 1; v < first.length; v++) first[v] += first[v - 1];
  const next = first.slice();
  const neighbors = new Uint32Array(2 * faces.length);
  for (let f = 0; f + 2 < faces.length; f += 3) {
    for (let k = 0; k < 3; k++) {
      const v = faces[f + k];
      neighbors[next[v]++] = faces[f + ((k + 1) % 3)];
      neighbors[next[v]++] = faces[f + ((k + 2) % 3)];
    }
  }
  return { first, neighbors };
}

/** Vertices no farther than `most` along edges, with their distance; and the pieces that lie wholly inside: eyes are of the head. */
function reached(positions: Float32Array, rings: Rings, from: number, most: number): Map<number, number> {
  const found = walk(positions, rings, from, most);
  if (most === Infinity) return found;
  const seen = new Set(found.keys());
  for (let v = 0; v < positions.length / 3; v++) {
    if (seen.has(v) || length(positions, from, v) > most) continue;
    const piece = [...walk(positions, rings, v, Infinity).keys()];
    for (const one of piece) seen.add(one);
    if (piece.every((one) => !found.has(one) && length(positions, from, one) <= most)) for (const one of piece) found.set(one, 0);
  }
  return found;
}

/** Each step from a vertex that was reached on a shorter way than before. */
function walk(positions: Float32Array, { first, neighbors }: Rings, from: number, most: number): Map<number, number> {
  const distance = new Map([[from, 0]]);
  const queue = [from];
  for (const v of queue) {
    for (let e = first[v]; e < first[v + 1]; e++) {
      const to = neighbors[e];
      const way = most === Infinity ? 0 : (distance.get(v) ?? 0) + length(positions, v, to);
      if (way > most || way >= (distance.get(to) ?? Infinity)) continue;
      distance.set(to, way);
      queue.push(to);
    }
  }
  return distance;
}

function length(positions: Float32Array, a: number, b: number): number {
  return Math.hypot(...[0, 1, 2].map((k) => positions[3 * a + k] - positions[3 * b + k]));
}
