// The dinosaur's colours, by place: lavender, a cream belly, coral plates.
import { hex, inEllipse, over, smile, toPath } from "../../kit/brush.js";
import { dot, mix, normalize, scale, smoothstep, sub } from "../../kit/vec3.js";
import { EYE, plateField, toeField, toHead } from "./shape.js";

const SKIN = hex("#bba4ee");
const LIGHT = hex("#d9c6fb");
const SHADE = hex("#8268c4");
const BELLY = hex("#fff3dc");
const CORAL = hex("#ff9676");
const CORAL_DEEP = hex("#f0705c");
const SPOT = hex("#9c83d9");
const INK = hex("#17212b");
const CHEEK = hex("#ff9fb0");
const WHITE = [255, 255, 255];

const IRIS = hex("#5a478f");

const SMILE = smile([-0.16, 1.1], [0.16, 1.1], 0.055, 16);

// Places on the back and the thigh, and their radius.
const SPOTS = [[0.2, 0.98, -0.07, 0.035], [0.2, 0.84, -0.12, 0.045], [0.27, 0.66, -0.14, 0.05], [0.2, 0.55, -0.27, 0.04], [0.14, 0.42, -0.42, 0.04],
  [0.09, 0.36, -0.62, 0.03], [0.34, 0.45, 0.0, 0.045], [0.32, 0.36, -0.09, 0.03], [0.2, 1.32, -0.1, 0.04], [0.25, 1.2, -0.02, 0.03]];

export function paint([px, y, z]) {
  const x = Math.abs(px);
  let c = mix(SKIN, LIGHT, smoothstep(0.9, 1.45, y));
  c = over(c, SHADE, 0.55 * smoothstep(0.3, 0, y) + 0.3 * smoothstep(-0.7, -1.05, z));
  for (const [sx, sy, sz, r] of SPOTS) if (Math.hypot(x - sx, y - sy, z - sz) < r) c = SPOT;
  // The belly's bib: throat to between the legs, and on under the tail.
  const wide = 0.17 * smoothstep(0.18, 0.5, y) * (1 - 0.35 * smoothstep(0.6, 0.95, y));
  if (z > 0.02 && y < 1.0 && x < wide + 0.012) c = x < wide ? BELLY : mix(c, BELLY, 0.5);
  if (z > 0.02 && y < 0.95 && x < wide && [0.4, 0.52, 0.64, 0.76].some((h) => Math.abs(y - h - 0.25 * x * x) < 0.006)) c = mix(BELLY, hex("#e9c6a4"), 0.8);
  if (toeField(x, y, z) < 0.006 && z > 0.2) c = BELLY;
  if (plateField(x, y, z) < 0.008) c = mix(CORAL_DEEP, CORAL, smoothstep(0, 0.1, plateField(x, y, z) + 0.06));
  return face(c, x, y, z);
}

const LOOK = normalize(EYE.towards);
const ASIDE = normalize([LOOK[2], 0, -LOOK[0]]);
const UP = normalize(sub([0, 1, 0], scale(LOOK, LOOK[1])));

function face(colour, ...p) {
  const [x, y, z] = toHead(p);
  if (z < 0.1 || y < 0.97) return colour;
  let c = colour;
  // The jaw is lighter than the face, up to the smile.
  const lip = 1.1 - 0.055 * (1 - (x / 0.16) ** 2);
  if (z > 0.2 && y < lip && x < 0.2) c = over(c, BELLY, 0.9 * smoothstep(0.19, 0.165, x));
  if (Math.hypot(x - 0.178, y - 1.135, z - 0.32) < 0.045) c = over(c, CHEEK, 0.9);
  if (z > 0.2 && toPath([x, y], SMILE) < 0.0085) c = INK;
  if (Math.hypot(x - 0.068, y - 1.197, z - 0.472) < 0.012) c = SHADE;
  const from = sub([x, y, z], EYE.at);
  if (dot(from, LOOK) < 0) return c;
  const at = [dot(from, ASIDE), dot(from, UP)];
  if (inEllipse(...at, [0, 0], [0.058, 0.075])) c = WHITE;
  if (inEllipse(...at, [-0.004, 0], [0.052, 0.069])) {
    c = INK;
    if (inEllipse(...at, [-0.004, -0.037], [0.035, 0.021])) c = IRIS;
    if (inEllipse(...at, [-0.02, 0.026], [0.02, 0.024])) c = WHITE;
    if (inEllipse(...at, [0.014, -0.026], [0.01, 0.011])) c = WHITE;
  }
  return c;
}

/** The face has twice the texels. */
export const zone = (p) => (p[2] > 0.16 && toHead(p)[1] > 0.98 ? { name: "face", density: 1.8 } : null);
