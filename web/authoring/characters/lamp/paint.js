// The lamp's colours, by place: a coral shade, steel-blue arms, yellow joints, and a warm face of light.
import { hex, inEllipse, over, smile, toPath } from "../../kit/brush.js";
import { dot, mix, smoothstep, sub } from "../../kit/vec3.js";
import { AXIS, elbow, FACE, foot, lower, RADIUS, UP, upper } from "./shape.js";

const SHADE = hex("#ff9a82");
const SHADE_DEEP = hex("#ec6b5c");
const RIM = hex("#fff6ea");
const LIGHT = hex("#fffdf0");
const GLOW = hex("#fff0b0");
const STEEL = hex("#7fa6bd");
const STEEL_DEEP = hex("#527d99");
const JOINT = hex("#ffd45c");
const INK = hex("#17212b");
const CHEEK = hex("#ff9d8c");
const WHITE = [255, 255, 255];
const SMILE = smile([-0.085, -0.045], [0.085, -0.045], 0.062, 16);

export function paint(p) {
  const [x, y, z] = p;
  if (elbow(x, y, z) < 0.012) return JOINT;
  if (y < 0.35 && foot(x, y, z) < 0.02) return y < 0.035 ? STEEL_DEEP : Math.hypot(x, z + 0.02) < 0.14 && y > 0.15 ? JOINT : mix(STEEL_DEEP, STEEL, smoothstep(0.02, 0.14, y));
  if (Math.min(lower(x, y, z), upper(x, y, z)) < 0.012 && y < 0.95) return mix(STEEL_DEEP, STEEL, smoothstep(0.2, 0.8, y));
  const from = sub(p, FACE);
  const depth = dot(from, AXIS);
  const [u, v] = [x, dot(from, UP)];
  const r = Math.hypot(u, v);
  if (depth > -0.03 && r < RADIUS + 0.02) return r > RADIUS - 0.045 ? RIM : face(mix(LIGHT, GLOW, smoothstep(0.12, 0.25, r)), Math.abs(u), u, v);
  const c = mix(SHADE_DEEP, SHADE, smoothstep(-0.45, -0.1, depth));
  return Math.abs(depth + 0.16) < 0.014 ? RIM : c;
}

function face(colour, x, px, y) {
  let c = colour;
  if (inEllipse(x, y, [0.165, -0.03], [0.036, 0.025])) c = over(c, CHEEK, 0.8);
  if (toPath([x, y], SMILE) < 0.0095) c = INK;
  if (inEllipse(x, y, [0.09, 0.062], [0.036, 0.052])) {
    c = INK;
    const ex = Math.sign(px) * (x - 0.09);
    if (inEllipse(ex, y, [-0.011, 0.083], [0.0135, 0.016])) c = WHITE;
    if (inEllipse(ex, y, [0.012, 0.044], [0.007, 0.008])) c = WHITE;
  }
  return c;
}

/** The face has twice the texels. */
export const zone = (p) => (dot(sub(p, FACE), AXIS) > -0.03 ? { name: "face", density: 2 } : null);
