// Isotropic remeshing (Botsch and Kobbelt 2004): split, collapse, flip, relax, and back onto the field.
import { gradient } from "./sdf.js";
import { add, clamp, cross, distance, dot, length, normalize, scale, sub } from "./vec3.js";

/**
 * mesh: { vertices, triangles }, closed, or one half whose open border lies on x = 0. size(p) is the wished edge length at a
 * place, up to a factor that is found so that about `target` vertices remain. Returns a new { vertices, triangles }.
 */
export function remesh(mesh, field, { target, size = () => 1, rounds = 14 }) {
  const m = new Working(mesh, field);
  for (let round = 0; round < rounds; round++) {
    const unit = unitLength(m, size, target);
    const wish = (p) => unit * size(p);
    const last = round >= rounds - 4;
    splitLong(m, wish, last ? 1.6 : 4 / 3);
    if (!last) collapseShort(m, wish, 0.8);
    for (let k = 0; k < 2; k++) flip(m, last ? widerAngle : closerToSix);
    for (let k = 0; k < (last ? 3 : 1); k++) relax(m, wish);
  }
  for (let k = 0; k < 8 && mend(m, 24); k++) {
    flip(m, widerAngle);
    relax(m, () => 1);
    flip(m, widerAngle);
  }
  return m.compact();
}

/** The half and its mirror image as one closed surface; vertices on x = 0 are shared. The half's vertices come first. */
export function mirrorMesh({ vertices, triangles }) {
  const all = [...vertices];
  const twin = vertices.map((p, v) => (p[0] === 0 ? v : all.push([-p[0], p[1], p[2]]) - 1));
  return { vertices: all, triangles: [...triangles, ...triangles.map(([a, b, c]) => [twin[a], twin[c], twin[b]])] };
}

class Working {
  constructor({ vertices, triangles }, field) {
    this.field = field;
    this.p = vertices.map((v) => [...v]);
    this.faces = triangles.map((t) => [...t]);
    this.around = vertices.map(() => []);
    this.faces.forEach((t, f) => t.forEach((v) => this.around[v].push(f)));
    this.border = vertices.map(() => false);
    for (const [a, b] of this.edges()) if (this.wings(a, b).length === 1) this.border[a] = this.border[b] = true;
    this.open = this.border.includes(true);
    this.normal = this.p.map((p) => normalize(gradient(field, p)));
  }
  edges() {
    const out = [];
    for (const t of this.faces) if (t) for (let k = 0; k < 3; k++) out.push([t[k], t[(k + 1) % 3]]);
    return out.filter(([a, b]) => a < b || this.wings(a, b).length === 1);
  }
  /** Faces at the edge. */
  wings(a, b) {
    return this.around[a].filter((f) => this.faces[f].includes(b));
  }
  neighbours(v) {
    return [...new Set(this.around[v].flatMap((f) => this.faces[f]))].filter((w) => w !== v);
  }
  isBorder(a, b) {
    return this.border[a] && this.border[b] && this.wings(a, b).length === 1;
  }
  setFace(f, t) {
    for (const v of this.faces[f] ?? []) this.around[v].splice(this.around[v].indexOf(f), 1);
    this.faces[f] = t;
    for (const v of t ?? []) this.around[v].push(f);
  }
  /** Onto the surface; a vertex of the border stays on x = 0. */
  place(v, p) {
    let g;
    for (let k = 0; k < 3; k++) {
      const d = this.field(p[0], p[1], p[2]);
      if (k > 0 && Math.abs(d) < 2e-5) break;
      g = gradient(this.field, p);
      this.normal[v] = normalize(g);
      if (this.border[v]) g[0] = 0;
      p = sub(p, scale(g, clamp(d / Math.max(dot(g, g), 0.1), -0.03, 0.03)));
    }
    if (this.border[v]) p[0] = 0;
    else if (this.open) p[0] = Math.max(p[0], 1e-4);
    this.p[v] = p;
  }
  compact() {
    const rank = new Map();
    const triangles = this.faces.filter(Boolean).map((t) => t.map((v) => rank.get(v) ?? (rank.set(v, rank.size), rank.size - 1)));
    return { vertices: [...rank.keys()].map((v) => this.p[v]), triangles };
  }
}

const areaOf = (a, b, c) => length(cross(sub(b, a), sub(c, a))) / 2;

/** An isotropic mesh of edge length L has 2 / (sqrt 3 L^2) vertices for each square metre. */
function unitLength(m, size, target) {
  let weight = 0;
  for (const t of m.faces) {
    if (!t) continue;
    const [a, b, c] = t.map((v) => m.p[v]);
    weight += areaOf(a, b, c) / size(scale(add(a, add(b, c)), 1 / 3)) ** 2;
  }
  return Math.sqrt((2 * weight) / (Math.sqrt(3) * target)) * 0.98;
}

const middle = (m, a, b) => scale(add(m.p[a], m.p[b]), 0.5);

function split(m, a, b) {
  const wings = m.wings(a, b);
  const v = m.p.push(middle(m, a, b)) - 1;
  m.around.push([]);
  m.border.push(wings.length === 1);
  m.normal.push([0, 0, 0]);
  for (const f of wings) {
    const t = m.faces[f];
    m.setFace(
      f,
      t.map((w) => (w === b ? v : w)),
    );
    m.setFace(
      m.faces.length,
      t.map((w) => (w === a ? v : w)),
    );
  }
  m.place(v, m.p[v]);
}

function splitLong(m, wish, factor) {
  const ratio = ([a, b]) => distance(m.p[a], m.p[b]) / wish(middle(m, a, b));
  // An inner edge between two vertices of the border would be there twice once the half is mirrored.
  const isBridge = ([a, b]) => m.border[a] && m.border[b] && m.wings(a, b).length === 2;
  const long = m
    .edges()
    .map((e) => [ratio(e), e])
    .filter(([r, e]) => r > factor || isBridge(e));
  long.sort((x, y) => y[0] - x[0]);
  for (const [, [a, b]] of long) if (m.wings(a, b).length) split(m, a, b);
}

/** b goes into a, if the surface stays a surface and no triangle turns over. */
function collapse(m, a, b, isFine = () => true) {
  const wings = m.wings(a, b);
  if (m.border[b] && !(m.border[a] && wings.length === 1)) return false;
  const [na, nb] = [m.neighbours(a), m.neighbours(b)];
  const common = na.filter((v) => nb.includes(v));
  if (common.length !== wings.length) return false;
  if (common.some((v) => m.around[v].length <= (m.border[v] ? 3 : 4))) return false;
  if (m.border[a] && nb.some((v) => v !== a && m.border[v] && !na.includes(v) && !m.isBorder(b, v))) return false;
  const p = m.border[a] === m.border[b] ? middle(m, a, b) : m.p[a];
  const kept = [...m.around[a], ...m.around[b]].filter((f) => !wings.includes(f));
  for (const f of kept) {
    const q = m.faces[f].map((v) => (v === a || v === b ? p : m.p[v]));
    const r = m.faces[f].map((v) => m.p[v]);
    const turned = cross(sub(q[1], q[0]), sub(q[2], q[0]));
    const before = cross(sub(r[1], r[0]), sub(r[2], r[0]));
    if (dot(turned, before) < 0.6 * length(turned) * length(before) || !isFine(q)) return false;
  }
  for (const f of wings) m.setFace(f, null);
  for (const f of [...m.around[b]])
    m.setFace(
      f,
      m.faces[f].map((v) => (v === b ? a : v)),
    );
  m.place(a, p);
  return true;
}

function collapseShort(m, wish, factor) {
  const short = m
    .edges()
    .map(([a, b]) => [distance(m.p[a], m.p[b]) / wish(middle(m, a, b)), a, b])
    .filter(([r]) => r < factor);
  short.sort((x, y) => x[0] - y[0]);
  for (const [, a, b] of short) {
    const wings = m.wings(a, b);
    if (!wings.length || distance(m.p[a], m.p[b]) > factor * wish(middle(m, a, b))) continue;
    const isFine = (q) => [0, 1, 2].every((k) => distance(q[k], q[(k + 1) % 3]) < 1.4 * wish(q[k]));
    if (!collapse(m, a, b, isFine)) collapse(m, b, a, isFine);
  }
}

export function leastAngle(a, b, c) {
  const corner = (p, q, r) => Math.acos(clamp(dot(normalize(sub(q, p)), normalize(sub(r, p))), -1, 1));
  return Math.min(corner(a, b, c), corner(b, c, a), corner(c, a, b));
}

const widerAngle = (m, a, b, c, d) => {
  const [pa, pb, pc, pd] = [a, b, c, d].map((v) => m.p[v]);
  return Math.min(leastAngle(pa, pd, pc), leastAngle(pd, pb, pc)) > Math.min(leastAngle(pa, pb, pc), leastAngle(pb, pa, pd)) + 1e-6;
};
const closerToSix = (m, a, b, c, d) => {
  const off = (v, by) => Math.abs(m.around[v].length + by - (m.border[v] ? 3 : 6));
  return off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1) < off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
};

function flip(m, isBetter) {
  for (const [a, b] of m.edges()) {
    const wings = m.wings(a, b);
    if (wings.length !== 2) continue;
    const after = (f) => m.faces[f][(m.faces[f].indexOf(a) + 1) % 3] === b;
    const [f, g] = after(wings[0]) ? wings : [wings[1], wings[0]];
    const far = (h) => m.faces[h].find((v) => v !== a && v !== b);
    const [c, d] = [far(f), far(g)];
    if (c === d || (m.border[c] && m.border[d]) || m.wings(c, d).length) continue;
    if ([a, b].some((v) => m.around[v].length <= (m.border[v] ? 2 : 3)) || !isBetter(m, a, b, c, d)) continue;
    const facing = (x, y, z) => {
      const n = cross(sub(m.p[y], m.p[x]), sub(m.p[z], m.p[x]));
      return [x, y, z].every((v) => dot(n, m.normal[v]) > 0.3 * length(n));
    };
    if (!facing(a, d, c) || !facing(d, b, c)) continue;
    m.setFace(f, [a, d, c]);
    m.setFace(g, [d, b, c]);
  }
}

/** Each vertex goes along its tangent plane to the middle of its triangles, those weighing more that are too large. */
function relax(m, wish) {
  for (let v = 0; v < m.p.length; v++) {
    if (!m.around[v].length) continue;
    const p = m.p[v];
    let goal = [0, 0, 0];
    let total = 0;
    if (m.border[v]) {
      for (const w of m.neighbours(v).filter((u) => m.isBorder(u, v))) {
        const weight = 1 / wish(middle(m, v, w));
        goal = add(goal, scale(m.p[w], weight));
        total += weight;
      }
    } else {
      for (const f of m.around[v]) {
        const [a, b, c] = m.faces[f].map((w) => m.p[w]);
        const centre = scale(add(a, add(b, c)), 1 / 3);
        const weight = areaOf(a, b, c) / wish(centre) ** 2;
        goal = add(goal, scale(centre, weight));
        total += weight;
      }
    }
    const move = scale(sub(scale(goal, 1 / total), p), 0.7);
    const n = m.normal[v];
    m.place(v, add(p, sub(move, scale(n, dot(n, move)))));
  }
}

/** Collapses the shortest edge of each triangle with an angle below `degrees`; true if there was one. */
function mend(m, degrees) {
  let bad = false;
  const count = m.faces.length; // what is made on the way is seen to in the next round
  for (let f = 0; f < count; f++) {
    const t = m.faces[f];
    if (!t || leastAngle(...t.map((v) => m.p[v])) > (degrees * Math.PI) / 180) continue;
    bad = true;
    const edges = [0, 1, 2]
      .map((k) => [t[k], t[(k + 1) % 3]])
      .sort((x, y) => distance(m.p[x[0]], m.p[x[1]]) - distance(m.p[y[0]], m.p[y[1]]));
    if (!edges.slice(0, 1).some(([a, b]) => collapse(m, a, b) || collapse(m, b, a))) split(m, ...edges[2]);
  }
  return bad;
}
