// Triangles as a file holds them become the surface that is solved: welded by position, without what is no triangle any more or is
// there twice, and without vertices that no face uses.

import { boundsOf } from "../document/stage-transform";
import { count } from "./count";
import { ModelError } from "./named-file";
import { TupleTable } from "../util/tuple-table";
import { weld } from "./weld";

export interface Triangles {
  /** N x 3. */
  readonly positions: ArrayLike<number>;
  /** T x 3 over N. */
  readonly triangles: ArrayLike<number>;
}

/** The largest coordinate, as in a project. */
const FARTHEST = 1e12;

/** The box around all corners. Errors (ModelError): a coordinate that is not a number or beyond 1e12. */
export function checkedBounds(name: string, pieces: readonly Triangles[]): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const { positions, triangles } of pieces) {
    for (let c = 0; c < triangles.length; c++) {
      const vertex = triangles[c];
      for (let k = 0; k < 3; k++) {
        const x = positions[3 * vertex + k];
        if (!(Math.abs(x) <= FARTHEST)) {
          if (!Number.isFinite(Math.fround(x))) throw new ModelError(`${name}: the place of vertex ${vertex + 1} is not a number.`);
          throw new ModelError(`${name}: vertex ${vertex + 1} is too far away (${x.toPrecision(3)}).`);
        }
        if (x < min[k]) min[k] = x;
        if (x > max[k]) max[k] = x;
      }
    }
  }
  return { min, max };
}

export interface Corners {
  /** C x 3: each vertex of a piece that its triangles name, in the order in which they do. */
  readonly positions: Float32Array;
  /** T x 3 over C, of all pieces. */
  readonly index: Uint32Array;
  /** By piece: the corner of each of its vertices; -1 where no triangle uses it. */
  readonly ranks: readonly Int32Array[];
}

/** All pieces as one. `origin` is taken off in double. */
export function cornersOf(pieces: readonly Triangles[], origin: readonly number[] = [0, 0, 0]): Corners {
  const index = new Uint32Array(pieces.reduce((sum, { triangles }) => sum + triangles.length, 0));
  const most = pieces.reduce((sum, { positions, triangles }) => sum + Math.min(triangles.length, positions.length / 3), 0);
  const places = new Float32Array(3 * most);
  let at = 0;
  let used = 0;
  const ranks = pieces.map(({ positions, triangles }) => {
    const rank = new Int32Array(positions.length / 3).fill(-1);
    for (let c = 0; c < triangles.length; c++) {
      const vertex = triangles[c];
      if (rank[vertex] < 0) {
        for (let k = 0; k < 3; k++) places[3 * used + k] = positions[3 * vertex + k] - origin[k];
        rank[vertex] = used++;
      }
      index[at++] = rank[vertex];
    }
    return rank;
  });
  return { positions: places.slice(0, 3 * used), index, ranks };
}

export interface WeldedSurface {
  /** V x 3; every vertex is used by a face. */
  readonly positions: Float32Array;
  /** F x 3 over V; no face names a vertex twice, no two faces are the same. */
  readonly faces: Uint32Array;
  /** F: which triangle each face was. */
  readonly kept: Uint32Array;
  /** C: the vertex of each corner; -1 where no face uses it. */
  readonly vertexOf: Int32Array;
}

/** Errors (ModelError): all corners on one spot; no triangle with an area. */
export function weldCorners(name: string, { positions, index }: Corners, notes: string[]): WeldedSurface {
  const { min, max } = boundsOf(positions);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  if (!(diagonal > 0)) throw new ModelError(`${name} has all its corners on one spot.`);

  const welded = weld(positions, diagonal);
  const kept = keptTriangles(index, welded.vertexOf);
  if (kept.length === 0) throw new ModelError(`${name} has no triangle with an area.`);
  const dropped = index.length / 3 - kept.length;
  if (dropped > 0) notes.push(`Left out ${count(dropped, "triangle")} without area or there twice.`);

  const rank = new Int32Array(welded.positions.length / 3).fill(-1);
  for (const triangle of kept) for (let k = 0; k < 3; k++) rank[welded.vertexOf[index[3 * triangle + k]]] = 0;
  const used: number[] = [];
  rank.forEach((is, vertex) => {
    if (is === 0) rank[vertex] = used.push(vertex) - 1;
  });
  const vertexOf = Int32Array.from(welded.vertexOf, (vertex) => rank[vertex]);
  const places = new Float32Array(3 * used.length);
  used.forEach((vertex, v) => places.set(welded.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * v));
  const faces = new Uint32Array(3 * kept.length);
  for (let f = 0; f < kept.length; f++) for (let k = 0; k < 3; k++) faces[3 * f + k] = vertexOf[index[3 * kept[f] + k]];
  return { positions: places, faces, kept, vertexOf };
}

/**
 * The surface of one set of triangles, and which of its vertices each of theirs became: -1 where no face uses it. Errors
 * (ModelError): no triangles; a coordinate that is not a number or beyond 1e12; a corner without its vertex; what weldCorners says.
 */
export function buildSurface(name: string, piece: Triangles, notes: string[]): Omit<WeldedSurface, "kept"> {
  const { positions, triangles } = piece;
  if (triangles.length === 0) throw new ModelError(`${name} has no triangles.`);
  const n = positions.length / 3;
  for (let c = 0; c < triangles.length; c++) {
    if (triangles[c] >= 0 && triangles[c] < n) continue;
    throw new ModelError(`${name}: a face names vertex ${triangles[c] + 1}, but there are ${count(n, "vertex", "vertices")}.`);
  }
  checkedBounds(name, [piece]);
  const corners = cornersOf([piece]);
  const { vertexOf, ...surface } = weldCorners(name, corners, notes);
  return { ...surface, vertexOf: corners.ranks[0].map((corner) => (corner < 0 ? -1 : vertexOf[corner])) };
}

/** Triangles with three different vertices that no earlier one has in the same turn. */
function keptTriangles(index: Uint32Array, vertexOf: Uint32Array): Uint32Array {
  const kept = new Uint32Array(index.length / 3);
  let found = 0;
  const triples = new TupleTable(index.length / 3, 3);
  const triple = new Int32Array(3);
  for (let f = 0; f < index.length / 3; f++) {
    let [a, b, c] = [vertexOf[index[3 * f]], vertexOf[index[3 * f + 1]], vertexOf[index[3 * f + 2]]];
    if (a === b || b === c || c === a) continue;
    while (a > b || a > c) [a, b, c] = [b, c, a];
    triple[0] = a;
    triple[1] = b;
    triple[2] = c;
    const known = triples.size;
    if (triples.put(triple) === known) kept[found++] = f;
  }
  return kept.slice(0, found);
}
