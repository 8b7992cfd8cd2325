// The cells of a solid inside a model, and where its nodes carry single vertices: what a graphics card does for all of them
// (viewport/carry.ts) and the core where it is asked for vertices (mesh/solid.h), by the same formulas.

/** N nodes, E elements, V vertices. */
export interface SolidCells {
  /** Edge of an element, metres. */
  cell: number;
  /** N x 3, at rest, stage. */
  nodes: Float32Array;
  /** E x 8: the node at corner k, which lies (k & 1, k >> 1 & 1, k >> 2 & 1) cells from that at corner 0. */
  elements: Int32Array;
  /** V: the element that carries a vertex; -1: it stays. */
  elementOf: Int32Array;
}

/** `out`, 3 each: where these vertices of V x 3 at rest are. `maps`: N x 12, rows of (B | b). Does not allocate. */
export function carryVertices(
  { cell, nodes, elements, elementOf }: SolidCells,
  rest: Float32Array,
  maps: Float32Array,
  vertices: ArrayLike<number>,
  out: Float32Array,
): void {
  for (let i = 0; i < vertices.length; i++) {
    const v = 3 * vertices[i]!;
    const x = rest[v]!;
    const y = rest[v + 1]!;
    const z = rest[v + 2]!;
    const element = elementOf[vertices[i]!]!;
    if (element < 0) {
      out[3 * i] = x;
      out[3 * i + 1] = y;
      out[3 * i + 2] = z;
      continue;
    }
    const low = 3 * elements[8 * element]!;
    const a = hat((x - nodes[low]!) / cell);
    const b = hat((y - nodes[low + 1]!) / cell);
    const c = hat((z - nodes[low + 2]!) / cell);
    let px = 0;
    let py = 0;
    let pz = 0;
    for (let k = 0; k < 8; k++) {
      const weight = (k & 1 ? a : 1 - a) * (k & 2 ? b : 1 - b) * (k & 4 ? c : 1 - c);
      const m = 12 * elements[8 * element + k]!;
      px += weight * (maps[m]! * x + maps[m + 1]! * y + maps[m + 2]! * z + maps[m + 3]!);
      py += weight * (maps[m + 4]! * x + maps[m + 5]! * y + maps[m + 6]! * z + maps[m + 7]!);
      pz += weight * (maps[m + 8]! * x + maps[m + 9]! * y + maps[m + 10]! * z + maps[m + 11]!);
    }
    out[3 * i] = px;
    out[3 * i + 1] = py;
    out[3 * i + 2] = pz;
  }
}

function hat(t: number): number {
  const x = Math.min(Math.max(t, 0), 1);
  return x * x * (3 - 2 * x);
}

/** N x 12: every node where it rests. */
export function restMaps({ nodes }: SolidCells): Float32Array {
  const maps = new Float32Array(4 * nodes.length);
  for (let m = 0; m < maps.length; m += 12) maps[m] = maps[m + 5] = maps[m + 10] = 1;
  return maps;
}
