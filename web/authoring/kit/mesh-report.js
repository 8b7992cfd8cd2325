// What a solver cares about in a triangle mesh.
import { cross, distance, dot, length, sub } from "./vec3.js";

/** Vertices, faces, manifoldness, Euler characteristic, angles, aspect (circumradius over twice the inradius; 1 is best), volume. */
export function reportMesh(vertices, triangles) {
  const halfEdges = new Map();
  let repeated = 0;
  for (const [a, b, c] of triangles)
    for (const key of [`${a},${b}`, `${b},${c}`, `${c},${a}`]) {
      if (halfEdges.has(key)) repeated++;
      halfEdges.set(key, true);
    }
  const open = [...halfEdges.keys()].filter((key) => !halfEdges.has(key.split(",").reverse().join(","))).length;
  const angles = [];
  const aspects = [];
  let volume = 0;
  const valence = new Array(vertices.length).fill(0);
  for (const t of triangles) {
    const [a, b, c] = t.map((v) => vertices[v]);
    volume += dot(a, cross(b, c)) / 6;
    const [la, lb, lc] = [distance(b, c), distance(c, a), distance(a, b)];
    const corner = (p, q, o) => Math.acos((p * p + q * q - o * o) / (2 * p * q));
    angles.push(Math.min(corner(lb, lc, la), corner(lc, la, lb), corner(la, lb, lc)));
    const s = (la + lb + lc) / 2;
    const area = length(cross(sub(b, a), sub(c, a))) / 2;
    aspects.push((la * lb * lc * s) / (8 * area * area));
    for (const v of t) valence[v]++;
  }
  const sorted = [...angles].sort((x, y) => x - y);
  const degrees = (x) => +((x * 180) / Math.PI).toFixed(1);
  return {
    vertices: vertices.length,
    faces: triangles.length,
    euler: vertices.length - halfEdges.size / 2 + triangles.length,
    openEdges: open,
    repeatedEdges: repeated,
    minAngle: degrees(sorted[0]),
    angleFifthPercentile: degrees(sorted[Math.floor(sorted.length * 0.05)]),
    worstAspect: +aspects.reduce((x, y) => Math.max(x, y)).toFixed(2),
    meanAspect: +(aspects.reduce((x, y) => x + y, 0) / aspects.length).toFixed(3),
    valence: [valence.reduce((x, y) => Math.min(x, y)), valence.reduce((x, y) => Math.max(x, y))],
    selfIntersections: countIntersections(vertices, triangles),
    volume: +volume.toFixed(4),
  };
}

/** Pairs of triangles without a common vertex of which one's edge passes through the other; candidates share a cell of a grid. */
function countIntersections(vertices, triangles) {
  const box = triangles.map((t) => [0, 1, 2].map((k) => t.map((v) => vertices[v][k])).map((x) => [Math.min(...x), Math.max(...x)]));
  const cell = (2 * box.reduce((sum, b) => sum + Math.max(...b.map(([low, high]) => high - low)), 0)) / triangles.length;
  const grid = new Map();
  let count = 0;
  triangles.forEach((t, i) => {
    const p = t.map((v) => vertices[v]);
    const [xs, ys, zs] = box[i].map(([low, high]) => [Math.floor(low / cell), Math.floor(high / cell)]);
    const met = new Set();
    for (let x = xs[0]; x <= xs[1]; x++)
      for (let y = ys[0]; y <= ys[1]; y++)
        for (let z = zs[0]; z <= zs[1]; z++) {
          const key = `${x},${y},${z}`;
          if (!grid.has(key)) grid.set(key, []);
          for (const j of grid.get(key)) met.add(j);
          grid.get(key).push(i);
        }
    for (const j of met) {
      if (box[i].some(([low, high], k) => low > box[j][k][1] || high < box[j][k][0])) continue;
      if (t.some((v) => triangles[j].includes(v))) continue;
      const q = triangles[j].map((v) => vertices[v]);
      if (edgesPierce(p, q) || edgesPierce(q, p)) count++;
    }
  });
  return count;
}

function edgesPierce(edges, triangle) {
  const [a, b, c] = triangle;
  const side = (p, q, r, s) => {
    const d = dot(cross(sub(q, p), sub(r, p)), sub(s, p));
    return Math.abs(d) < 1e-12 ? 0 : Math.sign(d); // in one plane, as the facets of the pot's side are: no crossing
  };
  return [0, 1, 2].some((k) => {
    const [p, q] = [edges[k], edges[(k + 1) % 3]];
    if (side(a, b, c, p) * side(a, b, c, q) >= 0) return false;
    const turn = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
    return turn[0] === turn[1] && turn[1] === turn[2];
  });
}
