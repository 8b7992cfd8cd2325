// A picture around a mesh: charts by direction, packed into one square, each texel painted by the place that it lies on.
import { cross, dot, normalize, scale, sub, add } from "./vec3.js";
import { encodePng } from "./png.js";

const PAD = 2; // texels painted beyond a chart's edge
const SAMPLES = 3; // per texel and axis

// A chart looks along `axis`; across and up are the picture's directions.
const VIEWS = [0, 1, 2].flatMap((axis) =>
  [1, -1].map((s) => ({
    axis: [0, 1, 2].map((k) => (k === axis ? s : 0)),
    across: axis === 0 ? [0, 0, -s] : [axis === 1 ? 1 : s, 0, 0],
    up: axis === 1 ? [0, 0, -s] : [0, 1, 0],
  })),
);

/**
 * paint(p) gives [r, g, b] of 0 to 255 at a place of the surface. zone(p), if given, names parts to be charted apart: { name, density,
 * axis }: texels a metre times `density`, and the direction to look along if it shall be one. Returns { uv, png }: three [u, v] a triangle.
 */
export function makeSkin({ vertices, triangles }, paint, { size, zone = () => null }) {
  const charts = makeCharts(vertices, triangles, zone);
  pack(charts, size);
  const uv = new Array(triangles.length);
  const texel = new Map();
  for (const chart of charts) for (const f of chart.faces) uv[f] = triangles[f].map((v) => chart.place(vertices[v]));
  const rgb = new Uint8Array(size * size * 3).fill(128);
  for (const grow of [0, PAD])
    uv.forEach((corners, f) =>
      paintTriangle(
        corners,
        triangles[f].map((v) => vertices[v]),
        grow,
      ),
    );
  return { uv: uv.map((t) => t.map((c) => c.map((x) => x / size))), png: encodePng(size, size, rgb) };

  function paintTriangle(st, p, grow) {
    const [a, b, c] = st;
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0) return;
    const shares = (x, y) => {
      const s = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
      const t = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
      return [1 - s - t, s, t];
    };
    const range = (k) => [Math.floor(Math.min(...st.map((q) => q[k])) - grow), Math.ceil(Math.max(...st.map((q) => q[k])) + grow)];
    const [[x0, x1], [y0, y1]] = [range(0), range(1)];
    for (let y = Math.max(0, y0); y < Math.min(size, y1); y++)
      for (let x = Math.max(0, x0); x < Math.min(size, x1); x++) {
        if (texel.get(y * size + x) === true) continue;
        const inside = shares(x + 0.5, y + 0.5).every((w) => w >= 0);
        if (grow === 0 ? !inside : texel.has(y * size + x)) continue;
        const sum = [0, 0, 0];
        for (let j = 0; j < SAMPLES; j++)
          for (let i = 0; i < SAMPLES; i++) {
            const w = shares(x + (i + 0.5) / SAMPLES, y + (j + 0.5) / SAMPLES);
            paint([0, 1, 2].map((k) => w[0] * p[0][k] + w[1] * p[1][k] + w[2] * p[2][k])).forEach((v, k) => (sum[k] += v));
          }
        for (let k = 0; k < 3; k++) rgb[3 * (y * size + x) + k] = Math.round(sum[k] / SAMPLES ** 2);
        texel.set(y * size + x, inside);
      }
  }
}

function makeCharts(vertices, triangles, zone) {
  const normals = triangles.map((t) => {
    const [a, b, c] = t.map((v) => vertices[v]);
    return normalize(cross(sub(b, a), sub(c, a)));
  });
  const zones = triangles.map((t) =>
    zone(
      scale(
        t.reduce((sum, v) => add(sum, vertices[v]), [0, 0, 0]),
        1 / 3,
      ),
    ),
  );
  const facing = (f, view) => dot(normals[f], VIEWS[view].axis);
  const label = triangles.map(
    (_, f) => zones[f]?.axis ?? VIEWS.reduce((best, _v, i) => (facing(f, i) > facing(f, best) + 0.05 ? i : best), 0),
  );
  const neighbours = facesBeside(triangles);
  const sameZone = (f, g) => zones[f]?.name === zones[g]?.name;
  // Ragged borders: a triangle joins the most common view beside it, if it does not turn away from that.
  for (let round = 0; round < 6; round++)
    triangles.forEach((_, f) => {
      if (zones[f]?.axis !== undefined) return;
      const near = neighbours[f].filter((g) => sameZone(f, g)).map((g) => label[g]);
      const common = near.find((l, i) => l !== label[f] && near.indexOf(l) !== i);
      if (common !== undefined && facing(f, common) > 0.35) label[f] = common;
    });
  const charts = [];
  const done = new Set();
  triangles.forEach((_, start) => {
    if (done.has(start)) return;
    const faces = [start];
    done.add(start);
    for (const f of faces)
      for (const g of neighbours[f])
        if (!done.has(g) && label[g] === label[f] && sameZone(f, g)) {
          done.add(g);
          faces.push(g);
        }
    const { across, up } = VIEWS[label[start]];
    const points = faces.flatMap((f) => triangles[f]).map((v) => [dot(vertices[v], across), -dot(vertices[v], up)]);
    const bound = (pick, k) => points.reduce((m, q) => pick(m, q[k]), points[0][k]);
    const [left, top] = [bound(Math.min, 0), bound(Math.min, 1)];
    const density = zones[start]?.density ?? 1;
    charts.push({
      faces,
      across,
      up,
      left,
      top,
      density,
      width: (bound(Math.max, 0) - left) * density,
      height: (bound(Math.max, 1) - top) * density,
    });
  });
  return charts;
}

function facesBeside(triangles) {
  const of = new Map();
  const key = (a, b) => (a < b ? `${a},${b}` : `${b},${a}`);
  triangles.forEach((t, f) =>
    t.forEach((v, k) => {
      const e = key(v, t[(k + 1) % 3]);
      if (!of.has(e)) of.set(e, []);
      of.get(e).push(f);
    }),
  );
  return triangles.map((t, f) => t.flatMap((v, k) => of.get(key(v, t[(k + 1) % 3])).filter((g) => g !== f)));
}

/** Shelves, the tallest first, at the largest scale that fits; sets each chart's place(p) in texels. */
function pack(charts, size) {
  const order = [...charts].sort((a, b) => b.height - a.height);
  const layOut = (perMetre) => {
    let [x, y, shelf] = [0, 0, 0];
    for (const c of order) {
      const [w, h] = [c.width, c.height].map((v) => Math.ceil(v * perMetre) + 2 * PAD + 1);
      if (x + w > size) [x, y, shelf] = [0, y + shelf, 0];
      if (x + w > size || y + h > size) return false;
      [c.x, c.y, x, shelf] = [x + PAD, y + PAD, x + w, Math.max(shelf, h)];
    }
    return true;
  };
  let [low, high] = [1, 8000];
  for (let k = 0; k < 30; k++) {
    const middle = (low + high) / 2;
    if (layOut(middle)) low = middle;
    else high = middle;
  }
  layOut(low);
  for (const c of charts) {
    const s = low * c.density;
    c.place = (p) => [c.x + (dot(p, c.across) - c.left) * s, c.y + (-dot(p, c.up) - c.top) * s];
  }
}
