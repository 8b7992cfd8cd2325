// Normals of a surface with creases, as whole numbers, for vertices that are in their final order already: one that lies on a
// crease is split, its copies come last, and no triangle moves.
const CREASE = Math.cos((50 * Math.PI) / 180);

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/**
 * points: [x, y, z] each; indices: corners over drawn vertices; pointOf: each drawn vertex's point. half: the other side is the
 * mirror image across x = 0. Returns the new indices, which drawn vertex each one is a copy of, and N x 4 bytes.
 */
export function creasedNormals({ points, indices, pointOf, half }) {
  const at = (c) => pointOf[indices[c]];
  const faces = Array.from({ length: indices.length / 3 }, (_, f) => {
    const [a, b, d] = [0, 1, 2].map((k) => points[at(3 * f + k)]);
    return cross(
      b.map((x, k) => x - a[k]),
      d.map((x, k) => x - a[k]),
    );
  });
  const parent = Array.from(indices, (_, c) => c);
  const find = (c) => (parent[c] === c ? c : (parent[c] = find(parent[c])));
  const seen = new Map();
  for (let c = 0; c < indices.length; c++) {
    const next = c % 3 === 2 ? c - 2 : c + 1;
    const key = [Math.min(at(c), at(next)), Math.max(at(c), at(next))].join();
    const other = seen.get(key);
    seen.set(key, c);
    if (other === undefined) continue;
    const [f, g] = [faces[Math.floor(c / 3)], faces[Math.floor(other / 3)]];
    if (dot(f, g) < CREASE * Math.sqrt(dot(f, f) * dot(g, g))) continue;
    const otherNext = other % 3 === 2 ? other - 2 : other + 1;
    const same = at(other) === at(c);
    parent[find(c)] = find(same ? other : otherNext);
    parent[find(next)] = find(same ? otherNext : other);
  }
  const sums = new Map();
  for (let c = 0; c < indices.length; c++) {
    const sum = sums.get(find(c)) ?? [0, 0, 0];
    faces[Math.floor(c / 3)].forEach((x, k) => (sum[k] += x));
    if (half && points[at(c)][0] === 0) sum[0] = 0;
    sums.set(find(c), sum);
  }
  const normalOf = (c) => {
    const sum = sums.get(find(c));
    const length = Math.hypot(...sum) || 1;
    return sum.map((x) => Math.round((127 * x) / length));
  };

  const source = Array.from(pointOf, (_, i) => i);
  const normals = new Array(source.length);
  const copies = new Map();
  const out = Array.from(indices, (i, c) => {
    const normal = normalOf(c);
    normals[i] ??= normal;
    if (normals[i].join() === normal.join()) return i;
    const key = [i, ...normal].join();
    if (!copies.has(key)) {
      copies.set(key, source.push(i) - 1);
      normals.push(normal);
    }
    return copies.get(key);
  });
  return { indices: out, source, normals: Int8Array.from(normals.flatMap((n) => [...n, 0])) };
}
