// Signed distance fields: functions of (x, y, z), negative inside. Close to a true distance near their surface, which is all
// that polygonising and remeshing ask for. Each knows a box about its solid, so that a union asks only who is near.

const boxed = (field, low, high) => Object.assign(field, { low, high });
// Not Math.hypot: that one is many times slower.
const norm = (x, y, z) => Math.sqrt(x * x + y * y + z * z);
const norm2 = (x, y) => Math.sqrt(x * x + y * y);

function toBox({ low, high }, x, y, z) {
  return norm(Math.max(low[0] - x, x - high[0], 0), Math.max(low[1] - y, y - high[1], 0), Math.max(low[2] - z, z - high[2], 0));
}

/** Smooth minimum of two distances, round over about `k` metres (polynomial, Quilez 2013). */
function softMin(a, b, k) {
  const h = Math.max(k - Math.abs(a - b), 0) / k;
  return Math.min(a, b) - (h * h * k) / 4;
}

export const sphere = ([cx, cy, cz], r) =>
  boxed((x, y, z) => norm(x - cx, y - cy, z - cz) - r, [cx - r, cy - r, cz - r], [cx + r, cy + r, cz + r]);

/** Axis-aligned, or turned by `pitch` degrees about x (the front end goes down). The first-order distance f |p| / |grad f|. */
export function ellipsoid([cx, cy, cz], [rx, ry, rz], pitch = 0) {
  const [c, s] = [Math.cos((pitch * Math.PI) / 180), Math.sin((pitch * Math.PI) / 180)];
  const [hy, hz] = [norm2(c * ry, s * rz), norm2(s * ry, c * rz)];
  return boxed(
    (x, y, z) => {
      const dy = y - cy;
      const dz = z - cz;
      const u = (x - cx) / rx;
      const v = (c * dy + s * dz) / ry;
      const w = (c * dz - s * dy) / rz;
      const k0 = norm(u, v, w);
      const k1 = norm(u / rx, v / ry, w / rz);
      return k1 === 0 ? -Math.min(rx, ry, rz) : (k0 * (k0 - 1)) / k1;
    },
    [cx - rx, cy - hy, cz - hz],
    [cx + rx, cy + hy, cz + hz],
  );
}

/** Catmull-Rom through rows of numbers; `per` samples between two rows. */
function spline(rows, per) {
  const at = (i) => rows[Math.min(rows.length - 1, Math.max(0, i))];
  const out = [];
  for (let i = 0; i + 1 < rows.length; i++)
    for (let s = 0; s < per; s++) {
      const t = s / per;
      const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
      out.push(
        b.map(
          (_, k) => b[k] + (t * (c[k] - a[k] + t * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] + t * (3 * (b[k] - c[k]) + d[k] - a[k])))) / 2,
        ),
      );
    }
  return [...out, rows.at(-1)];
}

/** A tube along the spline through [x, y, z, radius] with round ends. */
export function limb(rows, per = 5) {
  const p = spline(rows, per);
  const parts = p.slice(1).map((b, i) => {
    const a = p[i];
    const d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    return {
      x: a[0],
      y: a[1],
      z: a[2],
      r: a[3],
      dx: d[0],
      dy: d[1],
      dz: d[2],
      inverse: 1 / Math.max(d[0] ** 2 + d[1] ** 2 + d[2] ** 2, 1e-12),
      grow: b[3] - a[3],
    };
  });
  const bound = (pick, sign) => [0, 1, 2].map((k) => pick(...p.map((row) => row[k] + sign * row[3])));
  return boxed(
    (x, y, z) => {
      let best = Infinity;
      for (const q of parts) {
        const px = x - q.x;
        const py = y - q.y;
        const pz = z - q.z;
        const t = Math.min(1, Math.max(0, (px * q.dx + py * q.dy + pz * q.dz) * q.inverse));
        best = Math.min(best, norm(px - t * q.dx, py - t * q.dy, pz - t * q.dz) - q.r - t * q.grow);
      }
      return best;
    },
    bound(Math.min, -1),
    bound(Math.max, 1),
  );
}

/** A ring about a vertical axis: an ellipse of radii rx and rz, `r` thick. */
export const ring = ([cx, cy, cz], [rx, rz], r) =>
  boxed(
    (x, y, z) => {
      const u = (x - cx) / rx;
      const v = (z - cz) / rz;
      const k = norm2(u, v);
      const out = k === 0 ? -Math.min(rx, rz) : (k * (k - 1)) / norm2(u / rx, v / rz);
      return norm2(out, y - cy) - r;
    },
    [cx - rx - r, cy - r, cz - rz - r],
    [cx + rx + r, cy + r, cz + rz + r],
  );

/** A box with rounded edges; half sizes. */
export const box = ([cx, cy, cz], [hx, hy, hz], r) =>
  boxed(
    (x, y, z) => {
      const u = Math.abs(x - cx) - hx + r;
      const v = Math.abs(y - cy) - hy + r;
      const w = Math.abs(z - cz) - hz + r;
      return norm(Math.max(u, 0), Math.max(v, 0), Math.max(w, 0)) + Math.min(Math.max(u, v, w), 0) - r;
    },
    [cx - hx, cy - hy, cz - hz],
    [cx + hx, cy + hy, cz + hz],
  );

/** Joined with a fillet of about `k` metres. */
export function union(k, ...fields) {
  const bound = (pick, side) => [0, 1, 2].map((d) => pick(...fields.map((f) => f[side][d])));
  return boxed(
    (x, y, z) => {
      let d = Infinity;
      for (const f of fields) {
        // Farther off than the fillet, it changes nothing.
        if (d < 1e3 && toBox(f, x, y, z) > d + k) continue;
        const e = f(x, y, z);
        d = d < 1e3 ? softMin(d, e, k) : e;
      }
      return d;
    },
    bound(Math.min, "low").map((v) => v - k / 4),
    bound(Math.max, "high").map((v) => v + k / 4),
  );
}
/** The field and its mirror image in x = 0, joined with a fillet of `k`. */
export function mirrored(k, field) {
  const [[x0, ...low], [x1, ...high]] = [field.low, field.high];
  return union(
    k,
    field,
    boxed((x, y, z) => field(-x, y, z), [-x1, ...low], [-x0, ...high]),
  );
}
/** `field` without `cutter`, the rim rounded over `k`. */
export const carve = (k, field, cutter) => boxed((x, y, z) => -softMin(-field(x, y, z), cutter(x, y, z), k), field.low, field.high);
/** Nothing below y = height; the rim is rounded over `k`. */
export const standing = (k, height, field) => boxed((x, y, z) => -softMin(-field(x, y, z), y - height, k), field.low, field.high);
/** Stretched about `centre` by `factors`. */
export function squeezed(centre, factors, field) {
  const least = Math.min(...factors);
  const [[cx, cy, cz], [fx, fy, fz]] = [centre, factors];
  const move = (p) => p.map((v, k) => centre[k] + (v - centre[k]) * factors[k]);
  return boxed((x, y, z) => least * field(cx + (x - cx) / fx, cy + (y - cy) / fy, cz + (z - cz) / fz), move(field.low), move(field.high));
}
/** The field with everything `factor` times as large about `centre`. */
export const grown = (centre, factor, field) => squeezed(centre, [factor, factor, factor], field);

/** Gradient by differences over a tetrahedron. */
export function gradient(field, [x, y, z], e = 1e-4) {
  const a = field(x + e, y - e, z - e);
  const b = field(x - e, y - e, z + e);
  const c = field(x - e, y + e, z - e);
  const d = field(x + e, y + e, z + e);
  return [(a - b - c + d) / (4 * e), (-a - b + c + d) / (4 * e), (-a + b - c + d) / (4 * e)];
}
