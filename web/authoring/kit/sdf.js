// Signed distance fields: functions of (x, y, z), negative inside. Close to a true distance near their surface, which is all
// that polygonising and remeshing ask for.

/** Smooth minimum of two distances, round over about `k` metres (polynomial, Quilez 2013). */
function softMin(a, b, k) {
  const h = Math.max(k - Math.abs(a - b), 0) / k;
  return Math.min(a, b) - (h * h * k) / 4;
}

export const sphere = ([cx, cy, cz], r) => (x, y, z) => Math.hypot(x - cx, y - cy, z - cz) - r;

/** Axis-aligned, or turned by `pitch` degrees about x (the front end goes down). The first-order distance f |p| / |grad f|. */
export function ellipsoid([cx, cy, cz], [rx, ry, rz], pitch = 0) {
  const [c, s] = [Math.cos((pitch * Math.PI) / 180), Math.sin((pitch * Math.PI) / 180)];
  return (x, y, z) => {
    const [dy, dz] = [y - cy, z - cz];
    const [u, v, w] = [(x - cx) / rx, (c * dy + s * dz) / ry, (c * dz - s * dy) / rz];
    const k0 = Math.hypot(u, v, w);
    const k1 = Math.hypot(u / rx, v / ry, w / rz);
    return k1 === 0 ? -Math.min(rx, ry, rz) : (k0 * (k0 - 1)) / k1;
  };
}

/** Catmull-Rom through rows of numbers; `per` samples between two rows. */
function spline(rows, per) {
  const at = (i) => rows[Math.min(rows.length - 1, Math.max(0, i))];
  const out = [];
  for (let i = 0; i + 1 < rows.length; i++)
    for (let s = 0; s < per; s++) {
      const t = s / per;
      const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
      out.push(b.map((_, k) => b[k] + (t * (c[k] - a[k] + t * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] + t * (3 * (b[k] - c[k]) + d[k] - a[k])))) / 2));
    }
  return [...out, rows.at(-1)];
}

/** A tube along the spline through [x, y, z, radius] with round ends. */
export function limb(rows, per = 5) {
  const p = spline(rows, per);
  const parts = p.slice(1).map((b, i) => {
    const a = p[i];
    const d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    return { a, d, inverse: 1 / Math.max(d[0] ** 2 + d[1] ** 2 + d[2] ** 2, 1e-12), grow: b[3] - a[3] };
  });
  return (x, y, z) => {
    let best = Infinity;
    for (const { a, d, inverse, grow } of parts) {
      const [px, py, pz] = [x - a[0], y - a[1], z - a[2]];
      const t = Math.min(1, Math.max(0, (px * d[0] + py * d[1] + pz * d[2]) * inverse));
      best = Math.min(best, Math.hypot(px - t * d[0], py - t * d[1], pz - t * d[2]) - a[3] - t * grow);
    }
    return best;
  };
}

/** Joined with a fillet of about `k` metres. */
export const union = (k, ...fields) => (x, y, z) => fields.reduce((d, f) => softMin(d, f(x, y, z), k), 1e3);
/** `field` without `cutter`, the rim rounded over `k`. */
export const carve = (k, field, cutter) => (x, y, z) => -softMin(-field(x, y, z), cutter(x, y, z), k);
/** What both have. */
export const intersect = (k, a, b) => (x, y, z) => -softMin(-a(x, y, z), -b(x, y, z), k);
/** The field and its mirror image in x = 0, joined with a fillet of `k`. */
export const mirrored = (k, field) => (x, y, z) => softMin(field(x, y, z), field(-x, y, z), k);
/** Nothing below y = height; the rim is rounded over `k`. */
export const standing = (k, height, field) => (x, y, z) => -softMin(-field(x, y, z), y - height, k);
/** Squeezed about `centre` by `factors`. */
export const squeezed = (centre, factors, field) => {
  const least = Math.min(...factors);
  return (x, y, z) => least * field(...[x, y, z].map((v, k) => centre[k] + (v - centre[k]) / factors[k]));
};

/** Unit gradient by central differences over a tetrahedron. */
export function gradient(field, [x, y, z], e = 1e-4) {
  const a = field(x + e, y - e, z - e);
  const b = field(x - e, y - e, z + e);
  const c = field(x - e, y + e, z - e);
  const d = field(x + e, y + e, z + e);
  return [a - b - c + d, -a - b + c + d, -a + b - c + d].map((v) => v / (4 * e));
}
