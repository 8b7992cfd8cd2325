// The file's own normals on a surface that moves. At rest they are the file's, to the bit it can be seen; each normal keeps its place
// in a frame that the faces around it carry: their summed normal, and an edge. Letters: V solver vertices, R render vertices.

import { TupleTable } from "../util/tuple-table";

export interface NormalSource {
  /** R x 3 at rest, in the axes of `rest`; zeros where faces are flat: nothing is written there. */
  readonly normals: Float32Array;
  /** F x 3 over R. */
  readonly index: Uint32Array;
  /** R. */
  readonly toVertex: Uint32Array;
}

export interface NormalBinding {
  /** R: which normal each render vertex shows; -1 for none. */
  readonly slot: Int32Array;
  /** Triangles with normals: the solver vertex of each corner, and the slot that it adds its face to. */
  readonly cornerVertex: Uint32Array;
  readonly cornerSlot: Int32Array;
  /** -1 for a face that is wound against its corner's normal, so that no pair cancels out. */
  readonly cornerSign: Int8Array;
  /** By slot: solver vertices of its edge. */
  readonly edge: Uint32Array;
  /** By slot: its normal along the faces' normal, along the edge and across both. */
  readonly place: Float32Array;
  /** By slot: 0 where the faces' own normal is the file's. */
  readonly tilted: Uint8Array;
  /** 3 per slot; scratch. */
  readonly sums: Float32Array;
}

/** Two normals of a vertex that differ by less than this, in each coordinate, are one. */
const STEP = 1 / 64;
/** Cosine beyond which the faces' normal serves: 1.5 degrees. */
const SAME = 0.99966;

/** `rest`: V x 3. */
export function bindNormals(rest: Float32Array, { normals, index, toVertex }: NormalSource): NormalBinding {
  const slot = new Int32Array(toVertex.length).fill(-1);
  const known = new TupleTable(slot.length, 4);
  const tuple = new Int32Array(4);
  const wanted = new Float32Array(normals.length);
  for (let r = 0; r < slot.length; r++) {
    tuple[0] = toVertex[r];
    for (let k = 0; k < 3; k++) tuple[k + 1] = Math.round(normals[3 * r + k] / STEP);
    if (tuple[1] === 0 && tuple[2] === 0 && tuple[3] === 0) continue;
    const before = known.size;
    slot[r] = known.put(tuple);
    if (slot[r] === before) wanted.set(normals.subarray(3 * r, 3 * r + 3), 3 * before);
  }
  const corners: number[] = [];
  for (let c = 0; c < index.length; c += 3)
    if (slot[index[c]] >= 0 && slot[index[c + 1]] >= 0 && slot[index[c + 2]] >= 0) corners.push(index[c], index[c + 1], index[c + 2]);
  const slots = known.size;
  const binding: NormalBinding = {
    slot,
    cornerVertex: Uint32Array.from(corners, (r) => toVertex[r]),
    cornerSlot: Int32Array.from(corners, (r) => slot[r]),
    cornerSign: new Int8Array(corners.length).fill(1),
    edge: new Uint32Array(2 * slots),
    place: new Float32Array(3 * slots),
    tilted: new Uint8Array(slots),
    sums: new Float32Array(3 * slots),
  };
  chooseEdges(rest, binding);
  sumFaces(binding, rest, (corner, nx, ny, nz) => {
    const s = 3 * binding.cornerSlot[corner];
    if (nx * wanted[s] + ny * wanted[s + 1] + nz * wanted[s + 2] < 0) binding.cornerSign[corner] = -1;
  });
  placeNormals(rest, binding, wanted);
  return binding;
}

/** R x 3 into `out`, for V x 3. Does not allocate. */
export function writeNormals(binding: NormalBinding, vertices: Float32Array, out: Float32Array): void {
  const { slot, sums, tilted } = binding;
  sumFaces(binding, vertices);
  for (let s = 0; s < tilted.length; s++) if (tilted[s]) tilt(binding, vertices, s);
  for (let r = 0; r < slot.length; r++) {
    const s = 3 * slot[r];
    if (s < 0) continue;
    out[3 * r] = sums[s];
    out[3 * r + 1] = sums[s + 1];
    out[3 * r + 2] = sums[s + 2];
  }
}

/** Unit area-weighted normals by slot, into `sums`. */
function sumFaces(
  binding: NormalBinding,
  vertices: Float32Array,
  before?: (corner: number, x: number, y: number, z: number) => void,
): void {
  const { cornerVertex, cornerSlot, cornerSign, sums } = binding;
  sums.fill(0);
  for (let c = 0; c < cornerVertex.length; c += 3) {
    const a = 3 * cornerVertex[c],
      b = 3 * cornerVertex[c + 1],
      d = 3 * cornerVertex[c + 2];
    const ax = vertices[a],
      ay = vertices[a + 1],
      az = vertices[a + 2];
    const ux = vertices[b] - ax,
      uy = vertices[b + 1] - ay,
      uz = vertices[b + 2] - az;
    const wx = vertices[d] - ax,
      wy = vertices[d + 1] - ay,
      wz = vertices[d + 2] - az;
    const nx = uy * wz - uz * wy,
      ny = uz * wx - ux * wz,
      nz = ux * wy - uy * wx;
    for (let k = c; k < c + 3; k++) {
      before?.(k, nx, ny, nz);
      const s = 3 * cornerSlot[k];
      const sign = cornerSign[k];
      sums[s] += sign * nx;
      sums[s + 1] += sign * ny;
      sums[s + 2] += sign * nz;
    }
  }
  for (let s = 0; s < sums.length; s += 3) {
    const scale = 1 / (Math.sqrt(sums[s] ** 2 + sums[s + 1] ** 2 + sums[s + 2] ** 2) || 1);
    sums[s] *= scale;
    sums[s + 1] *= scale;
    sums[s + 2] *= scale;
  }
}

/** The longest edge of the faces around each slot's vertex: the one that noise turns least. */
function chooseEdges(rest: Float32Array, { cornerVertex, cornerSlot, edge }: NormalBinding): void {
  const longest = new Float32Array(edge.length / 2).fill(-1);
  for (let c = 0; c < cornerVertex.length; c++) {
    const face = c - (c % 3);
    const s = cornerSlot[c];
    for (const other of [face + ((c + 1) % 3), face + ((c + 2) % 3)]) {
      const [v, w] = [cornerVertex[c], cornerVertex[other]];
      const length = (rest[3 * w] - rest[3 * v]) ** 2 + (rest[3 * w + 1] - rest[3 * v + 1]) ** 2 + (rest[3 * w + 2] - rest[3 * v + 2]) ** 2;
      if (length <= longest[s]) continue;
      longest[s] = length;
      edge[2 * s] = v;
      edge[2 * s + 1] = w;
    }
  }
}

function placeNormals(rest: Float32Array, { edge, place, tilted, sums }: NormalBinding, wanted: Float32Array): void {
  for (let s = 0; s < tilted.length; s++) {
    const i = 3 * s;
    const [nx, ny, nz] = [sums[i], sums[i + 1], sums[i + 2]];
    const [wx, wy, wz] = [wanted[i], wanted[i + 1], wanted[i + 2]];
    const along = nx * wx + ny * wy + nz * wz;
    if (along > SAME || !frameOf(rest, edge, s, nx, ny, nz)) continue;
    place[i] = along;
    place[i + 1] = FRAME[0] * wx + FRAME[1] * wy + FRAME[2] * wz;
    place[i + 2] = FRAME[3] * wx + FRAME[4] * wy + FRAME[5] * wz;
    tilted[s] = 1;
  }
}

/** Along the edge and across, six numbers; scratch. */
const FRAME = new Float64Array(6);

/** False where edge and normal span no frame. */
function frameOf(vertices: Float32Array, edge: Uint32Array, s: number, nx: number, ny: number, nz: number): boolean {
  const a = 3 * edge[2 * s],
    b = 3 * edge[2 * s + 1];
  let tx = vertices[b] - vertices[a],
    ty = vertices[b + 1] - vertices[a + 1],
    tz = vertices[b + 2] - vertices[a + 2];
  const along = tx * nx + ty * ny + tz * nz;
  tx -= along * nx;
  ty -= along * ny;
  tz -= along * nz;
  const length = Math.sqrt(tx * tx + ty * ty + tz * tz);
  if (!(length > 0) || nx * nx + ny * ny + nz * nz < 0.5) return false;
  FRAME[0] = tx / length;
  FRAME[1] = ty / length;
  FRAME[2] = tz / length;
  FRAME[3] = ny * FRAME[2] - nz * FRAME[1];
  FRAME[4] = nz * FRAME[0] - nx * FRAME[2];
  FRAME[5] = nx * FRAME[1] - ny * FRAME[0];
  return true;
}

function tilt({ edge, place, sums }: NormalBinding, vertices: Float32Array, s: number): void {
  const i = 3 * s;
  const [nx, ny, nz] = [sums[i], sums[i + 1], sums[i + 2]];
  if (!frameOf(vertices, edge, s, nx, ny, nz)) return;
  for (let k = 0; k < 3; k++) sums[i + k] = place[i] * sums[i + k] + place[i + 1] * FRAME[k] + place[i + 2] * FRAME[3 + k];
}
