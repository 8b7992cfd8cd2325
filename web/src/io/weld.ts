// Gives corners that lie on one spot one vertex: triangle soups (STL, OBJ by its loader) and seams become a surface.

/** Corners closer than this part of the bounding box's diagonal are one vertex. */
const TOLERANCE = 1e-6;

export interface Welded {
  /** V x 3. */
  positions: Float32Array;
  /** N: vertex of each corner. */
  vertexOf: Uint32Array;
}

/**
 * Welds N x 3 finite positions of a box with this diagonal. Vertices keep the order of their first corner. Allocates about 40
 * bytes a corner.
 */
export function weld(corners: Float32Array, diagonal: number): Welded {
  const count = corners.length / 3;
  const tolerance = TOLERANCE * diagonal;
  const perCell = tolerance > 0 ? 1 / (4 * tolerance) : 1;
  const vertexOf = new Uint32Array(count);
  const positions = new Float32Array(corners.length);
  const table = new CellTable(count);
  let vertices = 0;
  for (let i = 0; i < count; i++) {
    const x = corners[3 * i],
      y = corners[3 * i + 1],
      z = corners[3 * i + 2];
    let found = -1;
    // The neighbourhood of a corner touches one cell, rarely two, at most eight.
    const x1 = Math.floor((x + tolerance) * perCell);
    const y1 = Math.floor((y + tolerance) * perCell);
    const z1 = Math.floor((z + tolerance) * perCell);
    for (let a = Math.floor((x - tolerance) * perCell); a <= x1 && found < 0; a++) {
      for (let b = Math.floor((y - tolerance) * perCell); b <= y1 && found < 0; b++) {
        for (let c = Math.floor((z - tolerance) * perCell); c <= z1 && found < 0; c++) {
          found = table.find(
            a,
            b,
            c,
            (v) =>
              Math.abs(positions[3 * v] - x) <= tolerance &&
              Math.abs(positions[3 * v + 1] - y) <= tolerance &&
              Math.abs(positions[3 * v + 2] - z) <= tolerance,
          );
        }
      }
    }
    if (found < 0) {
      found = vertices++;
      positions.set([x, y, z], 3 * found);
      table.add(Math.floor(x * perCell), Math.floor(y * perCell), Math.floor(z * perCell), found);
    }
    vertexOf[i] = found;
  }
  return { positions: positions.slice(0, 3 * vertices), vertexOf };
}

/** A hash of grid cells to chains of vertices; vertices of colliding cells share a chain and are told apart by position. */
class CellTable {
  private readonly head: Int32Array;
  private readonly next: Int32Array;
  private readonly mask: number;

  constructor(count: number) {
    let size = 16;
    while (size < 2 * count) size *= 2;
    this.mask = size - 1;
    this.head = new Int32Array(size).fill(-1);
    this.next = new Int32Array(count);
  }

  find(x: number, y: number, z: number, matches: (vertex: number) => boolean): number {
    for (let v = this.head[this.slot(x, y, z)]; v >= 0; v = this.next[v]) {
      if (matches(v)) return v;
    }
    return -1;
  }

  add(x: number, y: number, z: number, vertex: number): void {
    const slot = this.slot(x, y, z);
    this.next[vertex] = this.head[slot];
    this.head[slot] = vertex;
  }

  private slot(x: number, y: number, z: number): number {
    const hash = Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791);
    return (hash ^ (hash >>> 15)) & this.mask;
  }
}
