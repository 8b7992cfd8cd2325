// The cactus's skin: an atlas of charts, and the colour of every place on it.
import { add, clamp, mix, scale, smoothstep } from "../kit/vec3.js";

const SIZE = 768;
const SAMPLES = 3; // per texel and axis
const BLEED = 4; // texels painted beyond a chart's edge

// The light of the stage takes a fifth off and is warm; so the tones are that much lighter and cooler than they shall look.
const hex = (text) => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
const BODY = hex("#a6e0aa");
const SHADE = hex("#3a7f72");
const LIGHT = hex("#e6f8bc");
const SPINE = hex("#fffff2");
const INK = hex("#17212b");
const CHEEK = hex("#ff9d8c");
const WHITE = [255, 255, 255];
const POT = hex("#ffb497");
const RIM = hex("#ffc2a8");
const POT_SHADE = hex("#a84a4e");
const POT_LIGHT = hex("#fff0e2");
const ZIGZAG = hex("#fffaf0");
const SOIL = hex("#5c4038");
const PETAL = hex("#ff94b0");
const PETAL_DEEP = hex("#ff6a90");
const HEART = hex("#ffe89a");

// The body's columns near the face get more of the width than those at the back. Whole texels: every rib is then the same, and packs well.
const columnWidth = (u) => (u >= 6 && u < 14 ? 55 : 26);
const BODY_WIDTH = 8 * 55 + 12 * 26;
function warpColumns(u) {
  let x = 0;
  for (let k = 0; k < Math.floor(u); k++) x += columnWidth(k);
  return x + (u - Math.floor(u)) * columnWidth(Math.floor(u));
}

/** Chart rectangles in texels, and how a part's own (u, v) lies in them. */
function layout(cactus) {
  const strip = (x, y, w, h, us, length, warp = (u) => u) => ([u, v]) => [x + (w * warp(u)) / warp(us), y + h * (1 - v / length)];
  const disc = (x, y, size, radius) => ([u, v]) => [x + size * (0.5 + u / (2 * radius)), y + size * (0.5 - v / (2 * radius))];
  return {
    body: strip(8, 5, BODY_WIDTH, 410, cactus.segments, cactus.lengths.body, warpColumns),
    pot: strip(4, 427, 760, 156, cactus.segments, cactus.lengths.pot),
    rightArm: strip(5, 595, 224, 168, 8, cactus.lengths.rightArm),
    leftArm: strip(241, 595, 224, 168, 8, cactus.lengths.leftArm),
    crown: disc(490, 618, 96, 0.21),
    flower: disc(621, 596, 142, 0.125),
    flowerBack: disc(600, 746, 12, 0.125),
    bottom: disc(624, 746, 16, 0.21),
  };
}

// --- Colours -----------------------------------------------------------------------------------------------------------

const over = (under, colour, alpha) => mix(under, colour, clamp(alpha, 0, 1));
const inEllipse = (x, y, cx, cy, rx, ry) => ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2 < 1;

function toSegment(x, y, [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const t = clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0, 1);
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
const toPath = (x, y, path) => Math.min(...path.slice(1).map((p, i) => toSegment(x, y, path[i], p)));

const TICK = [
  [-0.0165, 0.0095],
  [0, -0.008],
  [0.0165, 0.0095],
];
const onTick = (x, y) => Math.abs(x) < 0.03 && Math.abs(y) < 0.03 && toPath(x, y, TICK) < 0.0048;

const RIB_WIDTH = 0.176; // metres from groove to groove at the widest place
const FACE = { y: 0.915, eye: 0.082 };
const SMILE = Array.from({ length: 13 }, (_, i) => {
  const t = i / 6 - 1;
  return [0.047 * t, FACE.y - 0.055 - 0.03 * (1 - t * t)];
});

/** Eyes, smile and cheeks, drawn in the plane seen from the front. */
function face(colour, [x, y, z]) {
  if (z < 0 || Math.abs(x) > 0.25 || Math.abs(y - FACE.y) > 0.2) return colour;
  const side = Math.sign(x) || 1;
  const ax = Math.abs(x);
  if (inEllipse(ax, y, 0.163, FACE.y - 0.065, 0.036, 0.025)) colour = over(colour, CHEEK, 0.75);
  if (toPath(x, y, SMILE) < 0.0078) colour = INK;
  if (inEllipse(ax, y, FACE.eye, FACE.y, 0.034, 0.049)) {
    colour = INK;
    const ex = side * (ax - FACE.eye); // both glints on the same side, as from one window
    if (inEllipse(ex, y, -0.01, FACE.y + 0.019, 0.0125, 0.0145)) colour = WHITE;
    if (inEllipse(ex, y, 0.011, FACE.y - 0.02, 0.006, 0.007)) colour = over(colour, WHITE, 0.75);
  }
  return colour;
}

/** Grooves: a dark line with a light one beside it, as in a drawing. `s` is the distance past the groove in metres. */
function groove(colour, s, fade) {
  colour = over(colour, SHADE, 0.16 * fade * (1 - smoothstep(0.006, 0.03, Math.abs(s))));
  if (Math.abs(s) < 0.0055) return over(colour, SHADE, 0.34 * fade);
  if (Math.abs(s + 0.011) < 0.0045) return over(colour, LIGHT, 0.42 * fade);
  return colour;
}

// Ribs at 18, 54, ... degrees from the front are crests; ticks sit on them.
const TICKS = [
  { rib: 0, ys: [0.5, 0.76, 1.13] },
  { rib: 1, ys: [0.62, 0.8, 1.03] },
  { rib: 2, ys: [0.52, 0.93, 1.15] },
  { rib: 3, ys: [0.6, 0.84, 1.05] },
  { rib: 4, ys: [0.5, 0.72, 0.95, 1.14] },
];

// In a few dozen steps that nobody sees, so that rows of the picture repeat and it packs well.
const stepped = (x) => Math.round(x * 14) / 14;

/** `turned`: columns of ribs from the front towards the cactus's left, whole numbers at the grooves. */
function green([x, y, z], turned, fadeGrooves) {
  const distance = Math.abs(turned);
  let colour = over(BODY, LIGHT, 0.3 * stepped(smoothstep(0.75, 1.35, y)));
  colour = over(colour, SHADE, 0.3 * stepped(1 - smoothstep(0.36, 0.52, y)));
  colour = over(colour, LIGHT, 0.16 * (0.5 - 0.5 * Math.cos(distance * 2 * Math.PI)));
  const nearFace = z > 0 ? 1 - stepped(smoothstep(0.8, 1.15, Math.hypot(x / 0.19, (y - FACE.y + 0.02) / 0.13))) : 0;
  colour = groove(colour, (turned - Math.round(turned)) * RIB_WIDTH, fadeGrooves * (1 - nearFace));
  const crest = clamp(Math.floor(distance), 0, 4);
  const r = Math.hypot(x, z);
  const across = (distance - crest - 0.5) * (Math.PI / 5) * r;
  const jitter = x > 0 ? 0 : 0.035 * (crest % 2 ? 1 : -1);
  for (const tick of TICKS[crest].ys) if (onTick(across, y - tick - jitter)) colour = SPINE;
  return colour;
}

function arm(colour, u, v) {
  const width = 0.068; // one column
  colour = over(colour, LIGHT, 0.3 * stepped(smoothstep(0.25, 0.55, v)));
  const line = (u - 0.5) / 2;
  colour = groove(colour, (line - Math.round(line)) * 2 * width, 1 - smoothstep(0.47, 0.53, v));
  for (const [tu, tv] of [[3.5, 0.24], [5.5, 0.33], [3.5, 0.44], [1.5, 0.38], [7.5, 0.25]]) if (onTick((u - tu) * width, v - tv)) colour = SPINE;
  return colour;
}

function zigzag(u, y) {
  const t = (u * 0.8) % 2; // eight waves around
  const height = 0.1 + 0.048 * (Math.abs(t - 1) - 0.5) * 2;
  return Math.abs(y - height) < 0.0135;
}

function terracotta([x, y, z], u, v) {
  const r = Math.hypot(x, z);
  if (v > 0.43) return over(SOIL, [30, 20, 18], 0.25); // inside the rim
  if (y > 0.277 || v > 0.29) {
    let colour = over(RIM, POT_LIGHT, 0.55 * smoothstep(0.35, 0.372, y));
    colour = over(colour, SOIL, r < 0.272 && y > 0.3 ? 0.9 : 0);
    return over(colour, POT_SHADE, 0.35 * (1 - smoothstep(0.28, 0.3, y)));
  }
  let colour = over(POT, POT_SHADE, 0.42 * smoothstep(0.19, 0.25, y));
  colour = over(colour, POT_SHADE, 0.16 * (1 - smoothstep(0, 0.06, y)));
  return zigzag(u, y) ? over(colour, ZIGZAG, 0.95) : colour;
}

function blossom(u, v) {
  const r = Math.hypot(u, v);
  if (r < 0.036) return over(HEART, [240, 170, 80], r < 0.018 ? 0 : 0.3);
  const turn = (((Math.atan2(v, u) * 180) / Math.PI - 54 + 720) % 72) / 72;
  let colour = over(PETAL, WHITE, 0.22 * smoothstep(0.06, 0.11, r));
  colour = over(colour, PETAL_DEEP, 0.75 * (1 - smoothstep(0.036, 0.065, r)));
  if (Math.min(turn, 1 - turn) * r * 1.26 < 0.0035) colour = over(colour, PETAL_DEEP, 0.7);
  return colour;
}

function colourAt(part, p, u, v) {
  switch (part) {
    case "body":
      return face(green(p, (10 - u) / 2, 1), p);
    case "crown":
      return green(p, Math.atan2(p[0], p[2]) / (Math.PI / 5), smoothstep(0.02, 0.08, Math.hypot(p[0], p[2])));
    case "rightArm":
    case "leftArm":
      return arm(BODY, u, v);
    case "pot":
      return terracotta(p, u, v);
    case "flower":
      return blossom(u, v);
    case "flowerBack":
      return over(PETAL, PETAL_DEEP, 0.35);
    default:
      return POT;
  }
}

// --- Rasteriser --------------------------------------------------------------------------------------------------------

const quantise = (x) => Math.min(255, 7 * Math.round(x / 7));

/** Paints one triangle: texels inside, and a few beyond its edges where no other triangle is nearer. */
function paintTriangle(image, owner, vertices, f, texel) {
  const [a, b, c] = texel;
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const weights = (x, y) => {
    const wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
    const wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
    return [1 - wb - wc, wb, wc];
  };
  const edge = [[b, c], [c, a], [a, b]].map(([p, q]) => Math.abs(area) / Math.hypot(q[0] - p[0], q[1] - p[1]));
  const position = (w) => [0, 1, 2].map((k) => w[0] * vertices[f.v[0]][k] + w[1] * vertices[f.v[1]][k] + w[2] * vertices[f.v[2]][k]);
  const range = (k) => [Math.max(0, Math.floor(Math.min(a[k], b[k], c[k]) - BLEED)), Math.min(SIZE - 1, Math.ceil(Math.max(a[k], b[k], c[k]) + BLEED))];
  const [x0, x1] = range(0);
  const [y0, y1] = range(1);
  for (let y = y0; y <= y1; y++)
    for (let x = x0; x <= x1; x++) {
      const w = weights(x + 0.5, y + 0.5);
      const inside = Math.min(w[0] * edge[0], w[1] * edge[1], w[2] * edge[2]);
      if (inside < -BLEED || inside <= owner[y * SIZE + x]) continue;
      owner[y * SIZE + x] = Math.min(inside, 0.25);
      let sum = [0, 0, 0];
      for (let s = 0; s < SAMPLES * SAMPLES; s++) {
        const ws = weights(x + ((s % SAMPLES) + 0.5) / SAMPLES, y + (Math.floor(s / SAMPLES) + 0.5) / SAMPLES);
        const uv = [0, 1].map((k) => ws[0] * f.uv[0][k] + ws[1] * f.uv[1][k] + ws[2] * f.uv[2][k]);
        sum = add(sum, colourAt(f.part, position(ws), uv[0], uv[1]));
      }
      image.set(scale(sum, 1 / (SAMPLES * SAMPLES)).map(quantise), 3 * (y * SIZE + x));
    }
}

/** Gives { size, rgb, uv }: the picture, and for each face three texture coordinates in 0..1 with v downwards. */
export function paintCactus(cactus) {
  const charts = layout(cactus);
  const rgb = new Uint8Array(SIZE * SIZE * 3);
  for (let i = 0; i < SIZE * SIZE; i++) rgb.set(BODY, 3 * i);
  const owner = new Float32Array(SIZE * SIZE).fill(-Infinity);
  const uv = cactus.faces.map((f) => f.uv.map(charts[f.part]));
  cactus.faces.forEach((f, i) => paintTriangle(rgb, owner, cactus.vertices, f, uv[i]));
  return { size: SIZE, rgb, uv: uv.map((corners) => corners.map(([x, y]) => [x / SIZE, y / SIZE])) };
}
