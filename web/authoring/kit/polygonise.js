// A field becomes a first triangle mesh, by surface nets: one vertex for each cell that the surface crosses.

/**
 * box: [[x, y, z], [x, y, z]]; step in metres. With `half`, only x >= 0 of a field that is symmetric in x: the column of cells
 * about x = 0 gives the vertices exactly on it. Returns { vertices, triangles }, triangles counter-clockwise seen from outside.
 */
export function polygonise(field, [low, high], step, half = false) {
  const origin = [half ? -step / 2 : low[0], low[1], low[2]];
  const n = high.map((h, k) => Math.ceil((h - origin[k]) / step) + 1);
  const value = sample(field, origin, n, step);
  const at = (i, j, k) => value[(i * n[1] + j) * n[2] + k];
  const vertices = [];
  const vertexOf = new Int32Array(n[0] * n[1] * n[2]).fill(-1);
  const cell = (i, j, k) => vertexOf[(i * n[1] + j) * n[2] + k];
  for (let i = 0; i + 1 < n[0]; i++)
    for (let j = 0; j + 1 < n[1]; j++)
      for (let k = 0; k + 1 < n[2]; k++) {
        const p = crossingsMean(at, i, j, k);
        if (!p) continue;
        vertexOf[(i * n[1] + j) * n[2] + k] = vertices.length;
        vertices.push(p.map((v, d) => (half && i === 0 && d === 0 ? 0 : origin[d] + v * step)));
      }
  const triangles = [];
  const quad = (a, b, c, d, flip) => {
    if (flip) [b, d] = [d, b];
    triangles.push([a, b, c], [a, c, d]);
  };
  for (let i = 0; i + 1 < n[0]; i++)
    for (let j = 1; j + 1 < n[1]; j++)
      for (let k = 1; k + 1 < n[2]; k++) {
        const inside = at(i, j, k) < 0;
        if (i > 0) {
          if (inside !== at(i, j + 1, k) < 0) quad(cell(i - 1, j, k - 1), cell(i - 1, j, k), cell(i, j, k), cell(i, j, k - 1), !inside);
          if (inside !== at(i, j, k + 1) < 0) quad(cell(i - 1, j - 1, k), cell(i, j - 1, k), cell(i, j, k), cell(i - 1, j, k), !inside);
        }
        if (inside !== at(i + 1, j, k) < 0) quad(cell(i, j - 1, k - 1), cell(i, j, k - 1), cell(i, j, k), cell(i, j - 1, k), !inside);
      }
  return largest({ vertices, triangles });
}

/** The largest connected piece: a field may hold bubbles. */
function largest({ vertices, triangles }) {
  const parent = vertices.map((_, v) => v);
  const root = (v) => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const [a, b, c] of triangles) parent[root(b)] = parent[root(c)] = root(a);
  const count = new Map();
  for (const [a] of triangles) count.set(root(a), (count.get(root(a)) ?? 0) + 1);
  const main = [...count].reduce((best, entry) => (entry[1] > best[1] ? entry : best))[0];
  const rank = new Map();
  const kept = triangles.filter(([a]) => root(a) === main).map((t) => t.map((v) => rank.get(v) ?? (rank.set(v, rank.size), rank.size - 1)));
  return { vertices: [...rank.keys()].map((v) => vertices[v]), triangles: kept };
}

/** Values at the grid's points; blocks that lie far from the surface get the value of their middle. */
function sample(field, origin, n, step) {
  const SIZE = 6;
  const value = new Float64Array(n[0] * n[1] * n[2]);
  const reach = 1.4 * SIZE * step; // well over the half diagonal: smooth joints bend the distances
  for (let bi = 0; bi < n[0]; bi += SIZE)
    for (let bj = 0; bj < n[1]; bj += SIZE)
      for (let bk = 0; bk < n[2]; bk += SIZE) {
        const middle = field(...[bi, bj, bk].map((b, d) => origin[d] + (b + (SIZE - 1) / 2) * step));
        for (let i = bi; i < Math.min(bi + SIZE, n[0]); i++)
          for (let j = bj; j < Math.min(bj + SIZE, n[1]); j++)
            for (let k = bk; k < Math.min(bk + SIZE, n[2]); k++)
              value[(i * n[1] + j) * n[2] + k] =
                Math.abs(middle) > reach ? middle : field(origin[0] + i * step, origin[1] + j * step, origin[2] + k * step);
      }
  return value;
}

/** Mean of the points where the surface crosses the cell's edges, in grid units; null if it does not. */
function crossingsMean(at, i, j, k) {
  let count = 0;
  const sum = [0, 0, 0];
  const edge = (a, b, c, axis) => {
    const v0 = at(i + a, j + b, k + c);
    const v1 = at(i + a + (axis === 0), j + b + (axis === 1), k + c + (axis === 2));
    if (v0 < 0 === v1 < 0) return;
    const t = v0 / (v0 - v1);
    sum[0] += i + a + (axis === 0 ? t : 0);
    sum[1] += j + b + (axis === 1 ? t : 0);
    sum[2] += k + c + (axis === 2 ? t : 0);
    count++;
  };
  for (const a of [0, 1])
    for (const b of [0, 1]) {
      edge(0, a, b, 0);
      edge(a, 0, b, 1);
      edge(a, b, 0, 2);
    }
  return count ? sum.map((v) => v / count) : null;
}
