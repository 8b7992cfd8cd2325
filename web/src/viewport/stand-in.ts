// What rays are cast against: a model's own surface, or, where that is large, a coarse one that nodes carry as they carry it.

import type { SolidCells } from "../util/solid-cells";

export interface StandIn {
  /** Solver vertices. */
  readonly vertices: Uint32Array;
  /** Three each, indices into the vertices. */
  readonly faces: Uint32Array;
  /** Some vertices of the surface are left out. */
  readonly coarse: boolean;
}

/** Triangles for which a tree is made while nobody notices. */
const FEW = 40_000;
/** Triangles looked at in one go: a few milliseconds. */
const PORTION = 100_000;

/** Large work is done in portions; `pause` lets others have a turn. */
export async function standInFor(
  rest: Float32Array,
  faces: Uint32Array,
  solid: SolidCells | null,
  pause: () => Promise<unknown>,
): Promise<StandIn> {
  if (!solid || faces.length <= 3 * FEW)
    return { vertices: Uint32Array.from({ length: rest.length / 3 }, (_, v) => v), faces, coarse: false };
  const { cell, nodes, elements, elementOf } = solid;
  // One vertex for each eighth of an element: what lies in two sheets is never one, however near they are.
  const first = new Int32Array(elements.length).fill(-1);
  const vertices: number[] = [];
  const rank = new Int32Array(elementOf.length).fill(-1);
  for (let v = 0; v < elementOf.length; v++) {
    if (v % PORTION === 0) await pause();
    const e = elementOf[v]!;
    if (e < 0) continue;
    const low = 3 * elements[8 * e]!;
    let eighth = 8 * e;
    for (let axis = 0; axis < 3; axis++) if (2 * (rest[3 * v + axis]! - nodes[low + axis]!) > cell) eighth += 1 << axis;
    if (first[eighth]! < 0) first[eighth] = vertices.push(v) - 1;
    rank[v] = first[eighth]!;
  }
  const coarse: number[] = [];
  const known = new Set<number>();
  const count = vertices.length;
  for (let f = 0; f < faces.length; f += 3) {
    if (f % PORTION === 0) await pause();
    const a = rank[faces[f]!]!;
    const b = rank[faces[f + 1]!]!;
    const c = rank[faces[f + 2]!]!;
    if (a === b || b === c || c === a || a < 0 || b < 0 || c < 0) continue;
    const least = Math.min(a, b, c);
    const most = Math.max(a, b, c);
    const key = (least * count + (a + b + c - least - most)) * count + most;
    if (known.has(key)) continue;
    known.add(key);
    coarse.push(a, b, c);
  }
  return { vertices: Uint32Array.from(vertices), faces: Uint32Array.from(coarse), coarse: true };
}

/** The vertices of the elements that carry these, for a closer look. */
export function around({ elementOf }: SolidCells, vertices: readonly number[]): Uint32Array {
  const near = new Set(vertices.map((v) => elementOf[v]!));
  const found: number[] = [];
  for (let v = 0; v < elementOf.length; v++) if (near.has(elementOf[v]!)) found.push(v);
  return Uint32Array.from(found);
}
