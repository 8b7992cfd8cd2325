// The dinosaur's colours, by place: lavender, a cream belly, coral plates.
import { hex, inEllipse, over, smile, toPath } from "../../kit/brush.js";
import { mix, smoothstep } from "../../kit/vec3.js";
import { EYE, plateField, toeField } from "./shape.js";

const SKIN = hex("#bba4ee");
const LIGHT = hex("#d9c6fb");
const SHADE = hex("#8268c4");
const BELLY = hex("#fff0d9");
const CORAL = hex("#ff9676");
const CORAL_DEEP = hex("#f0705c");
const SPOT = hex("#9c83d9");
const INK = hex("#17212b");
const CHEEK = hex("#ff9fb0");
const WHITE = [255, 255, 255];

const SMILE = [...smile([-0.15, 1.095], [0.15, 1.095], 0.05, 16)];

// Places on the back and the thigh, and their radius.
const SPOTS = [[0.2, 0.98, -0.07, 0.035], [0.2, 0.84, -0.12, 0.045], [0.27, 0.66, -0.14, 0.05], [0.2, 0.55, -0.27, 0.04], [0.14, 0.42, -0.42, 0.04],
  [0.09, 0.36, -0.62, 0.03], [0.34, 0.45, 0.0, 0.045], [0.32, 0.36, -0.09, 0.03], [0.2, 1.2, -0.08, 0.035]];

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

function face(colour, x, y, z) {
  if (z < 0.1 || y < 0.95) return colour;
  let c = colour;
  // Jaw lighter than the face.
  const jaw = y - (1.095 - 0.05 * (1 - (x / 0.15) ** 2));
  if (z > 0.2 && jaw < 0 && y < 1.1 && x < 0.2) c = over(c, BELLY, 0.85 * smoothstep(0.2, 0.17, x));
  if (Math.hypot(x - 0.185, y - 1.12, z - 0.33) < 0.05) c = over(c, CHEEK, 0.85);
  if (z > 0.22 && toPath([x, y], SMILE) < 0.0085) c = INK;
  if (Math.hypot(x - 0.07, y - 1.2, z - 0.5) < 0.014) c = SHADE;
  // Eyes, seen from a little aside.
  const s = x * 0.85 - z * 0.5 - (EYE[0] * 0.85 - EYE[2] * 0.5);
  const t = y - 1.275;
  if (z > 0.15 && inEllipse(s, t, [0.0, 0], [0.058, 0.078])) c = WHITE;
  if (z > 0.15 && inEllipse(s, t, [-0.006, 0], [0.047, 0.066])) {
    c = INK;
    if (inEllipse(s, t, [-0.006, -0.035], [0.032, 0.02])) c = hex("#51407f");
    if (inEllipse(s, t, [-0.02, 0.027], [0.018, 0.021])) c = WHITE;
    if (inEllipse(s, t, [0.016, -0.024], [0.009, 0.01])) c = WHITE;
  }
  return c;
}

/** The face is one chart, looked at from the front, at twice the texels. */
export function zone([x, y, z]) {
  return z > 0.18 && y > 1.0 ? { name: "face", density: 1.7, axis: undefined } : null;
}
