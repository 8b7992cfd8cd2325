// Normals for what comes without: faces that meet at a small angle are one smooth surface, at a crease each keeps its own.

import { TupleTable } from "../../util/tuple-table";

const CREASE_DEGREES = 50;

interface Part {
  /** N x 3. */
  readonly positions: ArrayLike<number>;
  /** Triangles over N. */
  readonly index: ArrayLike<number>;
  readonly normals?: ArrayLike<number> | null;
}

/**
 * By part: 3 x its index, a unit normal for each corner, the area-weighted mean of the faces that meet there smoothly, across the
 * borders of parts too; null for parts that have normals.
 */
export function creasedNormals(parts: readonly Part[]): (Float32Array | null)[] {
  const bare = parts.filter(({ normals }) => !normals);
  const corners = bare.reduce((sum, { index }) => sum + index.length, 0);
  if (corners === 0) return parts.map(() => null);
  const positions = new Float64Array(3 * corners);
  const vertexOf = new Uint32Array(corners);
  const table = new TupleTable(corners, 6);
  const place = new Float64Array(3);
  const bits = new Int32Array(place.buffer);
  let c = 0;
  for (const part of bare) {
    for (let i = 0; i < part.index.length; i++, c++) {
      for (let k = 0; k < 3; k++) place[k] = part.positions[3 * part.index[i] + k] + 0; // -0 is 0
      positions.set(place, 3 * c);
      vertexOf[c] = table.put(bits);
    }
  }
  const faces = faceNormals(positions);
  const slots = smoothSlots(faces, vertexOf);
  const sums = new Float64Array(3 * corners);
  for (let k = 0; k < corners; k++) {
    const face = k - (k % 3);
    for (let d = 0; d < 3; d++) sums[3 * slots[k] + d] += faces[face + d];
  }
  let at = 0;
  return parts.map(({ normals, index }) => {
    if (normals) return null;
    const out = new Float32Array(3 * index.length);
    for (let i = 0; i < index.length; i++, at++) {
      const s = 3 * slots[at];
      const length = Math.hypot(sums[s], sums[s + 1], sums[s + 2]);
      if (length > 0) for (let d = 0; d < 3; d++) out[3 * i + d] = sums[s + d] / length;
      else out[3 * i + 1] = 1;
    }
    return out;
  });
}

/** F x 3, as long as twice the triangle's area; corners stand in threes. */
function faceNormals(positions: Float64Array): Float64Array {
  const normals = new Float64Array(positions.length / 3);
  for (let c = 0; c < normals.length; c += 3) {
    const p = (corner: number, k: number): number => positions[3 * (c + corner) + k] - positions[3 * c + k];
    const [ux, uy, uz] = [p(1, 0), p(1, 1), p(1, 2)];
    const [wx, wy, wz] = [p(2, 0), p(2, 1), p(2, 2)];
    normals[c] = uy * wz - uz * wy;
    normals[c + 1] = uz * wx - ux * wz;
    normals[c + 2] = ux * wy - uy * wx;
  }
  return normals;
}

/** 3F: one corner's number for all corners of one vertex that are joined through smooth edges. */
function smoothSlots(normals: Float64Array, vertexOf: Uint32Array): Uint32Array {
  const corners = vertexOf.length;
  const parent = Uint32Array.from({ length: corners }, (_, c) => c);
  const find = (c: number): number => {
    while (parent[c] !== c) c = parent[c] = parent[parent[c]];
    return c;
  };
  const join = (a: number, b: number): void => {
    parent[find(a)] = find(b);
  };
  const edges = new TupleTable(corners, 2);
  const latest = new Int32Array(corners).fill(-1); // by edge: the half-edge seen last; earlier ones follow through `before`
  const before = new Int32Array(corners);
  const edge = new Int32Array(2);
  for (let c = 0; c < corners; c++) {
    const face = c - (c % 3);
    const next = face + ((c + 1) % 3);
    edge[0] = Math.min(vertexOf[c], vertexOf[next]);
    edge[1] = Math.max(vertexOf[c], vertexOf[next]);
    const e = edges.put(edge);
    before[c] = latest[e];
    latest[e] = c;
    let fans = 0;
    // A fan of many faces on one edge is no surface: past a handful nothing is gained, and all pairs would take for ever.
    for (let other = before[c]; other >= 0 && fans < MOST_ON_EDGE; other = before[other], fans++) {
      const otherFace = other - (other % 3);
      if (!isSmooth(normals, face, otherFace)) continue;
      const otherNext = otherFace + ((other + 1) % 3);
      const same = vertexOf[other] === vertexOf[c];
      join(c, same ? other : otherNext);
      join(next, same ? otherNext : other);
    }
  }
  return Uint32Array.from({ length: corners }, (_, c) => find(c));
}

const MOST_ON_EDGE = 8;
const COSINE = Math.cos((CREASE_DEGREES * Math.PI) / 180);

/** A face without area has no say, so that slivers do not cut a smooth surface. */
function isSmooth(normals: Float64Array, f: number, g: number): boolean {
  const dot = (a: number, b: number): number => normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
  const [ff, gg] = [dot(f, f), dot(g, g)];
  return ff === 0 || gg === 0 || dot(f, g) >= COSINE * Math.sqrt(ff * gg);
}
