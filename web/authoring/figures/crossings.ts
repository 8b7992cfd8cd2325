// How often a body goes through itself.

/** Pairs of triangles that cross, as one number each; corners that lie in one place at rest are one, and neighbours do not cross. */
export class Crossings {
  private readonly weld: Uint32Array;
  private readonly known: Set<number>;

  constructor(
    rest: Float32Array,
    private readonly faces: Uint32Array,
  ) {
    const seen = new Map<string, number>();
    this.weld = Uint32Array.from({ length: rest.length / 3 }, (_, v) => {
      const key = `${rest[3 * v]},${rest[3 * v + 1]},${rest[3 * v + 2]}`;
      if (!seen.has(key)) seen.set(key, v);
      return seen.get(key)!;
    });
    this.known = new Set(this.pairs(rest));
  }

  /** So many that do not cross at rest. */
  since(places: Float32Array): number {
    return this.pairs(places).filter((pair) => !this.known.has(pair)).length;
  }

  private pairs(p: Float32Array): number[] {
    const count = this.faces.length / 3;
    const boxes = boxesOf(p, this.faces);
    let edge = 0;
    for (let f = 0; f < count; f++) for (let k = 0; k < 3; k++) edge += (boxes[6 * f + 3 + k]! - boxes[6 * f + k]!) / count;
    const cell = Math.max((2 * edge) / 3, 1e-6);
    const at = (x: number): number => Math.floor(x / cell) + 1024;
    const cells = new Map<number, number[]>();
    for (let f = 0; f < count; f++) {
      const box = 6 * f;
      const [xs, ys, zs] = [at(boxes[box + 3]!), at(boxes[box + 4]!), at(boxes[box + 5]!)];
      for (let x = at(boxes[box]!); x <= xs; x++)
        for (let y = at(boxes[box + 1]!); y <= ys; y++)
          for (let z = at(boxes[box + 2]!); z <= zs; z++) {
            const key = (x * 2048 + y) * 2048 + z;
            const list = cells.get(key);
            if (list) list.push(f);
            else cells.set(key, [f]);
          }
    }
    const found: number[] = [];
    for (const [key, list] of cells)
      for (let i = 0; i < list.length; i++)
        for (let j = i + 1; j < list.length; j++) {
          const [f, g] = [6 * list[i]!, 6 * list[j]!];
          let [apart, home] = [false, 0];
          for (let k = 0; k < 3 && !apart; k++) {
            const low = Math.max(boxes[f + k]!, boxes[g + k]!);
            apart = low > Math.min(boxes[f + 3 + k]!, boxes[g + 3 + k]!);
            home = home * 2048 + at(low);
          }
          // Once only: where their boxes' common corner lies.
          if (!apart && home === key && this.cross(p, list[i]!, list[j]!)) found.push(list[i]! * count + list[j]!);
        }
    return found;
  }

  private cross(p: Float32Array, f: number, g: number): boolean {
    const corner = (t: number, k: number): number => this.weld[this.faces[3 * t + k]!]!;
    for (let k = 0; k < 9; k++) if (corner(f, k % 3) === corner(g, Math.floor(k / 3))) return false;
    const [a, b] = [f, g].map((t) => [corner(t, 0), corner(t, 1), corner(t, 2)]);
    for (let k = 0; k < 3; k++) {
      if (pierces(p, a![k]!, a![(k + 1) % 3]!, b!) || pierces(p, b![k]!, b![(k + 1) % 3]!, a!)) return true;
    }
    return false;
  }
}

function boxesOf(p: Float32Array, faces: Uint32Array): Float32Array {
  const boxes = new Float32Array(2 * faces.length);
  for (let f = 0; f < faces.length / 3; f++)
    for (let k = 0; k < 3; k++) {
      const [a, b, c] = [p[3 * faces[3 * f]! + k]!, p[3 * faces[3 * f + 1]! + k]!, p[3 * faces[3 * f + 2]! + k]!];
      boxes[6 * f + k] = Math.min(a, b, c);
      boxes[6 * f + 3 + k] = Math.max(a, b, c);
    }
  return boxes;
}

/** Whether the edge from vertex `from` to vertex `to` goes through a triangle: five signed volumes. */
function pierces(p: Float32Array, from: number, to: number, [a, b, c]: readonly number[]): boolean {
  if (volume(p, from, a!, b!, c!) > 0 === volume(p, to, a!, b!, c!) > 0) return false;
  const side = volume(p, from, to, a!, b!) > 0;
  return volume(p, from, to, b!, c!) > 0 === side && volume(p, from, to, c!, a!) > 0 === side;
}

function volume(p: Float32Array, a: number, b: number, c: number, d: number): number {
  const [x, y, z] = [p[3 * a]!, p[3 * a + 1]!, p[3 * a + 2]!];
  const [ux, uy, uz] = [p[3 * b]! - x, p[3 * b + 1]! - y, p[3 * b + 2]! - z];
  const [vx, vy, vz] = [p[3 * c]! - x, p[3 * c + 1]! - y, p[3 * c + 2]! - z];
  const [wx, wy, wz] = [p[3 * d]! - x, p[3 * d + 1]! - y, p[3 * d + 2]! - z];
  return ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
}
