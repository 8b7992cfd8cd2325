// Smooth normals with creases. Which corners share a normal is decided once, on the rest shape; each frame then only adds
// up face normals. Letters: V solver vertices, R render vertices of the file, N drawn vertices (R split along creases).

const CREASE_DEGREES = 50;

export interface Topology {
  /** N: the file's render vertex that each drawn vertex copies its colour and texture coordinate from. */
  source: Uint32Array;
  /** N: solver vertex. */
  vertex: Uint32Array;
  /** N: which summed normal it shows. */
  slot: Uint32Array;
  /** 3F over drawn vertices. */
  index: Uint32Array;
  /** 3F: solver vertex of each corner. */
  cornerVertex: Uint32Array;
  /** 3F: the sum that each corner adds its face normal to. */
  cornerSlot: Uint32Array;
  /** Sums, 3 per slot; scratch. */
  sums: Float32Array;
}

/** Finds the corners that meet smoothly (across edges bent by at most 50 degrees at rest) and splits vertices where they do not. */
export function buildTopology(rest: Float32Array, index: Uint32Array, toVertex: Uint32Array): Topology {
  const corners = index.length;
  const cornerVertex = Uint32Array.from(index, (r) => toVertex[r] ?? 0);
  const cornerSlot = smoothSlots(faceNormals(rest, index), cornerVertex);

  const drawn = new Map<number, number>();
  const source: number[] = [];
  const slot: number[] = [];
  const drawnIndex = new Uint32Array(corners);
  for (let c = 0; c < corners; c++) {
    const key = index[c]! * corners + cornerSlot[c]!;
    let vertex = drawn.get(key);
    if (vertex === undefined) {
      vertex = source.length;
      drawn.set(key, vertex);
      source.push(index[c]!);
      slot.push(cornerSlot[c]!);
    }
    drawnIndex[c] = vertex;
  }
  return {
    source: Uint32Array.from(source),
    vertex: Uint32Array.from(source, (r) => toVertex[r] ?? 0),
    slot: Uint32Array.from(slot),
    index: drawnIndex,
    cornerVertex,
    cornerSlot,
    sums: new Float32Array(3 * (cornerSlot.reduce((most, s) => Math.max(most, s), -1) + 1)),
  };
}

/** Area-weighted normals of the present shape, N x 3 into `out`. Does not allocate. */
export function writeNormals(topology: Topology, vertices: Float32Array, out: Float32Array): void {
  const { cornerVertex, cornerSlot, slot, sums } = topology;
  sums.fill(0);
  for (let c = 0; c < cornerVertex.length; c += 3) {
    const a = 3 * cornerVertex[c]!,
      b = 3 * cornerVertex[c + 1]!,
      d = 3 * cornerVertex[c + 2]!;
    const ax = vertices[a]!,
      ay = vertices[a + 1]!,
      az = vertices[a + 2]!;
    const ux = vertices[b]! - ax,
      uy = vertices[b + 1]! - ay,
      uz = vertices[b + 2]! - az;
    const wx = vertices[d]! - ax,
      wy = vertices[d + 1]! - ay,
      wz = vertices[d + 2]! - az;
    const nx = uy * wz - uz * wy,
      ny = uz * wx - ux * wz,
      nz = ux * wy - uy * wx;
    for (let k = c; k < c + 3; k++) {
      const s = 3 * cornerSlot[k]!;
      sums[s] = sums[s]! + nx;
      sums[s + 1] = sums[s + 1]! + ny;
      sums[s + 2] = sums[s + 2]! + nz;
    }
  }
  for (let i = 0; i < slot.length; i++) {
    const s = 3 * slot[i]!;
    const x = sums[s]!,
      y = sums[s + 1]!,
      z = sums[s + 2]!;
    const scale = 1 / (Math.sqrt(x * x + y * y + z * z) || 1);
    out[3 * i] = x * scale;
    out[3 * i + 1] = y * scale;
    out[3 * i + 2] = z * scale;
  }
}

function faceNormals(positions: Float32Array, index: Uint32Array): Float32Array {
  const normals = new Float32Array(index.length);
  for (let c = 0; c < index.length; c += 3) {
    const a = 3 * index[c]!,
      b = 3 * index[c + 1]!,
      d = 3 * index[c + 2]!;
    const u = [0, 1, 2].map((k) => positions[b + k]! - positions[a + k]!);
    const w = [0, 1, 2].map((k) => positions[d + k]! - positions[a + k]!);
    const n = [u[1]! * w[2]! - u[2]! * w[1]!, u[2]! * w[0]! - u[0]! * w[2]!, u[0]! * w[1]! - u[1]! * w[0]!];
    const length = Math.hypot(...n) || 1;
    for (let k = 0; k < 3; k++) normals[c + k] = n[k]! / length;
  }
  return normals;
}

/** 3F: equal numbers for corners of one vertex that are joined through smooth edges. */
function smoothSlots(normals: Float32Array, cornerVertex: Uint32Array): Uint32Array {
  const corners = cornerVertex.length;
  const cosine = Math.cos((CREASE_DEGREES * Math.PI) / 180);
  const parent = Uint32Array.from({ length: corners }, (_, c) => c);
  const find = (c: number): number => {
    while (parent[c] !== c) c = parent[c] = parent[parent[c]!]!;
    return c;
  };
  const join = (a: number, b: number): void => {
    parent[find(a)] = find(b);
  };

  const first = new Map<number, number>(); // edge -> the last half-edge seen on it; earlier ones follow through `before`
  const before = new Int32Array(corners).fill(-1);
  for (let c = 0; c < corners; c++) {
    const face = c - (c % 3);
    const next = face + ((c + 1) % 3);
    const v = cornerVertex[c]!,
      w = cornerVertex[next]!;
    const key = Math.min(v, w) * corners + Math.max(v, w);
    before[c] = first.get(key) ?? -1;
    for (let other = before[c]!; other >= 0; other = before[other]!) {
      const otherFace = other - (other % 3);
      if (!isSmooth(normals, face, otherFace, cosine)) continue;
      const otherNext = otherFace + ((other + 1) % 3);
      const same = cornerVertex[other] === v;
      join(c, same ? other : otherNext);
      join(next, same ? otherNext : other);
    }
    first.set(key, c);
  }

  const slots = new Map<number, number>();
  return Uint32Array.from({ length: corners }, (_, c) => {
    const root = find(c);
    const slot = slots.get(root) ?? slots.size;
    slots.set(root, slot);
    return slot;
  });
}

/** A face without area has no say, so that slivers do not cut a smooth surface. */
function isSmooth(normals: Float32Array, f: number, g: number, cosine: number): boolean {
  const dot = (a: number, b: number): number =>
    normals[a]! * normals[b]! + normals[a + 1]! * normals[b + 1]! + normals[a + 2]! * normals[b + 2]!;
  return dot(f, f) < 0.5 || dot(g, g) < 0.5 || dot(f, g) >= cosine;
}
