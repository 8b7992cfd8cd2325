// What figures say of a dance that a picture hides: how far the trunk swings, what volume is kept, what is torn.

/** Uniform in 0 .. 1, the same each time. */
export function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export interface Bounds {
  low: [number, number, number];
  high: [number, number, number];
}

export function boundsOf(places: Float32Array): Bounds {
  const low: Bounds["low"] = [Infinity, Infinity, Infinity];
  const high: Bounds["high"] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i++) {
    const k = i % 3;
    if (places[i] < low[k]) low[k] = places[i];
    if (places[i] > high[k]) high[k] = places[i];
  }
  return { low, high };
}

/** Points spread evenly over a surface. */
export class Samples {
  private readonly corners: Uint32Array;
  private readonly weights: Float32Array;

  constructor(places: Float32Array, faces: Uint32Array, count: number) {
    const areas = new Float64Array(faces.length / 3);
    let total = 0;
    for (let f = 0; f < areas.length; f++) areas[f] = total += areaOf(places, faces, f);
    const next = random(7);
    this.corners = new Uint32Array(3 * count);
    this.weights = new Float32Array(3 * count);
    for (let s = 0; s < count; s++) {
      const wanted = next() * total;
      let [a, b] = [0, areas.length - 1];
      while (a < b) {
        const middle = (a + b) >> 1;
        if (areas[middle] < wanted) a = middle + 1;
        else b = middle;
      }
      const [u, v] = [Math.sqrt(next()), next()];
      for (let k = 0; k < 3; k++) this.corners[3 * s + k] = faces[3 * a + k];
      this.weights.set([1 - u, u * (1 - v), u * v], 3 * s);
    }
  }

  at(places: Float32Array): Float32Array {
    const out = new Float32Array(this.corners.length);
    for (let s = 0; s < out.length; s += 3)
      for (let c = 0; c < 3; c++) for (let k = 0; k < 3; k++) out[s + k] += this.weights[s + c] * places[3 * this.corners[s + c] + k];
    return out;
  }
}

function areaOf(p: Float32Array, faces: Uint32Array, f: number): number {
  const [a, b, c] = [3 * faces[3 * f], 3 * faces[3 * f + 1], 3 * faces[3 * f + 2]];
  const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

/** The places nearest the middle: limbs wave, the trunk is what must not spin. */
export function trunkOf(rest: Float32Array): number[] {
  const middle = meanOf(rest, null);
  const far = Array.from({ length: rest.length / 3 }, (_, i) =>
    Math.hypot(rest[3 * i] - middle[0], rest[3 * i + 1] - middle[1], rest[3 * i + 2] - middle[2]),
  );
  return far
    .map((_, i) => i)
    .sort((a, b) => far[a] - far[b])
    .slice(0, Math.ceil(0.3 * far.length));
}

function meanOf(places: Float32Array, which: readonly number[] | null): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  const count = which?.length ?? places.length / 3;
  for (let n = 0; n < count; n++) for (let k = 0; k < 3; k++) sum[k] += places[3 * (which?.[n] ?? n) + k] / count;
  return sum;
}

/** Degrees that the chosen places have turned about the vertical since rest, by least squares. */
export function turnSince(rest: Float32Array, now: Float32Array, which: readonly number[]): number {
  const [a, b] = [meanOf(rest, which), meanOf(now, which)];
  let [sin, cos] = [0, 0];
  for (const i of which) {
    const [x, z, u, w] = [rest[3 * i] - a[0], rest[3 * i + 2] - a[2], now[3 * i] - b[0], now[3 * i + 2] - b[2]];
    sin += z * u - x * w;
    cos += x * u + z * w;
  }
  return (Math.atan2(sin, cos) * 180) / Math.PI;
}

/** Peak to peak of angles in degrees that may run over 180. */
export function swingOf(angles: readonly number[]): number {
  let [low, high, total] = [0, 0, 0];
  for (let n = 1; n < angles.length; n++) {
    const step = ((angles[n] - angles[n - 1] + 540) % 360) - 180;
    total += step;
    low = Math.min(low, total);
    high = Math.max(high, total);
  }
  return high - low;
}

export interface Topology {
  shells: number;
  /** Every edge has two faces that pass it in opposite ways. */
  closed: boolean;
  /** E x 2, one way. */
  edges: Uint32Array;
}

/** Vertices that lie in one place are one. */
export function topologyOf(rest: Float32Array, faces: Uint32Array): Topology {
  const weld = new Uint32Array(rest.length / 3);
  const seen = new Map<string, number>();
  for (let v = 0; v < weld.length; v++) {
    const key = `${rest[3 * v]},${rest[3 * v + 1]},${rest[3 * v + 2]}`;
    const known = seen.get(key);
    if (known === undefined) seen.set(key, v);
    weld[v] = known ?? v;
  }
  const parent = Uint32Array.from(weld, (_, v) => v);
  const root = (v: number): number => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const balance = new Map<number, number>();
  const edges: number[] = [];
  let even = true;
  for (let f = 0; f < faces.length; f += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [weld[faces[f + k]], weld[faces[f + ((k + 1) % 3)]]];
      if (a === b) continue;
      parent[root(a)] = root(b);
      const key = Math.min(a, b) * weld.length + Math.max(a, b);
      const old = balance.get(key);
      if (old === undefined) edges.push(a, b);
      // Two faces that pass it in opposite ways leave 0; a third, or the same way twice, leaves something else.
      const now = (old ?? 0) + (a < b ? 1 : -1);
      if (Math.abs(now) > 1) even = false;
      balance.set(key, now);
    }
  }
  const used = new Set<number>();
  for (const v of edges) used.add(root(v));
  return { shells: used.size, closed: even && [...balance.values()].every((n) => n === 0), edges: Uint32Array.from(edges) };
}

export function volumeOf(p: Float32Array, faces: Uint32Array): number {
  let sum = 0;
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
    sum +=
      p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
      p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
      p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum / 6;
}

/** The length that 999 of 1,000 edges stay below, rest is 1; edges under 1/200 of the height do not show. */
export function stretchOf(rest: Float32Array, now: Float32Array, edges: Uint32Array, height: number): number {
  const step = 2 * Math.max(1, Math.floor(edges.length / 2 / 30_000));
  const ratios: number[] = [];
  for (let e = 0; e < edges.length; e += step) {
    const [a, b] = [3 * edges[e], 3 * edges[e + 1]];
    const before = Math.hypot(rest[a] - rest[b], rest[a + 1] - rest[b + 1], rest[a + 2] - rest[b + 2]);
    if (before < 0.005 * height) continue;
    ratios.push(Math.hypot(now[a] - now[b], now[a + 1] - now[b + 1], now[a + 2] - now[b + 2]) / before);
  }
  return ratios.sort((x, y) => x - y)[Math.floor(0.999 * (ratios.length - 1))] ?? 1;
}
