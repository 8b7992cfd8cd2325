// A model as every reader returns it, and the one way that its parts become a surface.

import { boundsOf } from "../document/stage";
import type { Picture } from "../gltf/document";
import { count } from "./count";
import { ModelError } from "./named-file";
import { TupleTable } from "./tuple-table";
import { weld } from "./weld";

/** What is drawn: render vertices keep seams and colours, each knows its solver vertex. File units and axes. */
export interface DrawnSource {
  /** R x 3. */
  positions: Float32Array;
  /** F x 3 over render vertices: triangle f is face f. */
  index: Uint32Array;
  /** R: solver vertex of each render vertex. */
  toVertex: Uint32Array;
  /** R x 3 linear RGB, or null. */
  colors: Float32Array | null;
  /** R x 2, v down as in glTF (a texture drawn with flipY off), or null. */
  uvs: Float32Array | null;
  texture: Picture | null;
}

export interface Model {
  /** File name without folders. */
  name: string;
  /** V x 3, file units and axes; every vertex is used by a face. */
  positions: Float32Array;
  /** F x 3 over V; no face names a vertex twice, no two faces are the same. */
  faces: Uint32Array;
  drawn: DrawnSource;
  /** What was worked around, in plain words. */
  notes: string[];
}

/** Triangles as a file holds them. */
export interface Part {
  /** N x 3. */
  positions: ArrayLike<number>;
  /** Triangles over N. */
  index: ArrayLike<number>;
  /** N x 3 linear RGB, or null. */
  colors: ArrayLike<number> | null;
  /** N x 2, v down, or null. */
  uvs: ArrayLike<number> | null;
}

/**
 * Joins parts, welds them by position, drops what is no triangle any more or is there twice, and vertices that no face uses.
 * Errors (ModelError): no triangles; a coordinate that is not a number or beyond 1e12; a corner that does not exist; all on one spot.
 */
export function buildModel(name: string, parts: readonly Part[], texture: Picture | null, notes: string[]): Model {
  const corners = joinParts(name, parts);
  const { positions, index, vertexOf } = weldCorners(name, corners, notes);
  const drawn = drawnOf(corners, index, vertexOf, texture);
  const faces = Uint32Array.from(drawn.index, (r) => drawn.toVertex[r]);
  return { name, positions, faces, drawn, notes };
}

/** A model's surface alone, and which of its vertices each corner of the part became: -1 where no face uses it. Errors: as buildModel. */
export function buildSurface(
  name: string,
  part: Pick<Part, "positions" | "index">,
  notes: string[],
): { positions: Float32Array; faces: Uint32Array; vertexOf: Int32Array } {
  const corners = joinParts(name, [{ ...part, colors: null, uvs: null }]);
  const { positions, index, vertexOf } = weldCorners(name, corners, notes);
  const faces = Uint32Array.from(index, (corner) => vertexOf[corner]);
  return { positions, faces, vertexOf: corners.ranks[0].map((corner) => (corner < 0 ? -1 : vertexOf[corner])) };
}

interface Welding {
  /** V x 3. */
  positions: Float32Array;
  /** F x 3 over corners: the triangles that are kept. */
  index: Uint32Array;
  /** The vertex of each corner; -1 where no kept triangle uses it. */
  vertexOf: Int32Array;
}

function weldCorners(name: string, corners: Corners, notes: string[]): Welding {
  const { min, max } = boundsOf(corners.positions);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  if (!(diagonal > 0)) throw new ModelError(`${name} has all its corners on one spot.`);

  const welded = weld(corners.positions, diagonal);
  const kept = keptTriangles(corners.index, welded.vertexOf);
  if (kept.length === 0) throw new ModelError(`${name} has no triangle with an area.`);
  const dropped = corners.index.length / 3 - kept.length;
  if (dropped > 0) notes.push(`Left out ${count(dropped, "triangle")} without area or there twice.`);

  const index = new Uint32Array(3 * kept.length);
  for (let i = 0; i < kept.length; i++) index.set(corners.index.subarray(3 * kept[i], 3 * kept[i] + 3), 3 * i);
  const rank = new Int32Array(welded.positions.length / 3).fill(-1);
  for (const corner of index) rank[welded.vertexOf[corner]] = 0;
  const used: number[] = [];
  rank.forEach((is, vertex) => {
    if (is === 0) rank[vertex] = used.push(vertex) - 1;
  });
  return { positions: gather(welded.positions, used, 3), index, vertexOf: Int32Array.from(welded.vertexOf, (vertex) => rank[vertex]) };
}

/** The largest coordinate, as in a project. */
const FARTHEST = 1e12;

interface Corners {
  /** By part: the corner that each of its own became; -1 where no triangle uses it. */
  ranks: Int32Array[];
  positions: Float32Array;
  index: Uint32Array;
  colors: Float32Array | null;
  uvs: Float32Array | null;
}

/** All parts as one; only corners that a triangle uses. */
function joinParts(name: string, parts: readonly Part[]): Corners {
  const triangles = parts.reduce((sum, part) => sum + part.index.length / 3, 0);
  if (triangles === 0) throw new ModelError(`${name} has no triangles.`);
  const index = new Uint32Array(3 * triangles);
  const colored = parts.some((part) => part.colors);
  const mapped = parts.some((part) => part.uvs);
  const positions: number[] = [];
  const colors: number[] = [];
  const uvs: number[] = [];
  const ranks: Int32Array[] = [];
  let at = 0;
  for (const part of parts) {
    const n = part.positions.length / 3;
    const rank = new Int32Array(n).fill(-1);
    ranks.push(rank);
    for (let k = 0; k < part.index.length; k++) {
      const corner = part.index[k];
      if (!(corner >= 0 && corner < n)) {
        throw new ModelError(`${name}: a face names vertex ${corner + 1}, but there are ${count(n, "vertex", "vertices")}.`);
      }
      if (rank[corner] < 0) {
        rank[corner] = positions.length / 3;
        for (let d = 0; d < 3; d++) {
          const x = Math.fround(part.positions[3 * corner + d]);
          if (!Number.isFinite(x)) throw new ModelError(`${name}: the place of vertex ${corner + 1} is not a number.`);
          if (Math.abs(x) > FARTHEST) throw new ModelError(`${name}: vertex ${corner + 1} is too far away (${x.toPrecision(3)}).`);
          positions.push(x);
          if (colored) colors.push(part.colors ? part.colors[3 * corner + d] : 1);
        }
        if (mapped) uvs.push(part.uvs ? part.uvs[2 * corner] : 0, part.uvs ? part.uvs[2 * corner + 1] : 0);
      }
      index[at++] = rank[corner];
    }
  }
  return {
    ranks,
    positions: Float32Array.from(positions),
    index,
    colors: colored && colors.every(Number.isFinite) ? Float32Array.from(colors) : null,
    uvs: mapped && uvs.every(Number.isFinite) ? Float32Array.from(uvs) : null,
  };
}

/** Triangles with three different vertices that no earlier one has in the same turn. */
function keptTriangles(index: Uint32Array, vertexOf: Uint32Array): number[] {
  const kept: number[] = [];
  const triples = new TupleTable(index.length / 3, 3);
  for (let f = 0; f < index.length / 3; f++) {
    let [a, b, c] = [vertexOf[index[3 * f]], vertexOf[index[3 * f + 1]], vertexOf[index[3 * f + 2]]];
    if (a === b || b === c || c === a) continue;
    while (a > b || a > c) [a, b, c] = [b, c, a];
    const known = triples.size;
    if (triples.put([a, b, c]) === known) kept.push(f);
  }
  return kept;
}

/** Render vertices: corners that agree in vertex, colour and uv are one. */
function drawnOf(corners: Corners, index: Uint32Array, vertexOf: Int32Array, texture: Picture | null): DrawnSource {
  const colorBits = corners.colors && new Int32Array(corners.colors.buffer);
  const uvBits = corners.uvs && new Int32Array(corners.uvs.buffer);
  const width = 1 + (colorBits ? 3 : 0) + (uvBits ? 2 : 0);
  const tuples = new TupleTable(corners.positions.length / 3, width);
  const source: number[] = [];
  const tuple = new Int32Array(width);
  const drawnIndex = index.map((corner) => {
    tuple[0] = vertexOf[corner];
    if (colorBits) tuple.set(colorBits.subarray(3 * corner, 3 * corner + 3), 1);
    if (uvBits) tuple.set(uvBits.subarray(2 * corner, 2 * corner + 2), width - 2);
    const r = tuples.put(tuple);
    if (r === source.length) source.push(corner);
    return r;
  });
  return {
    positions: gather(corners.positions, source, 3),
    index: drawnIndex,
    toVertex: Uint32Array.from(source, (corner) => vertexOf[corner]),
    colors: corners.colors && gather(corners.colors, source, 3),
    uvs: corners.uvs && gather(corners.uvs, source, 2),
    texture: corners.uvs && texture,
  };
}

function gather(values: Float32Array, rows: ArrayLike<number>, width: number): Float32Array {
  const out = new Float32Array(rows.length * width);
  for (let i = 0; i < rows.length; i++) out.set(values.subarray(rows[i] * width, (rows[i] + 1) * width), i * width);
  return out;
}
