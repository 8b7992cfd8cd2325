// The egg's colours, by place: a cream shell, striped trousers with a cracked edge, yolk-yellow shoes and gloves.
import { hex, inEllipse, over, smile, toPath } from "../../kit/brush.js";
import { mix, smoothstep } from "../../kit/vec3.js";
import { shoe } from "./shape.js";

const SHELL = hex("#fffdf6");
const SHELL_SHADE = hex("#fbe2c4");
const TROUSERS = hex("#9adcf6");
const STRIPE = hex("#7cc7ec");
const YOLK = hex("#ffdf63");
const YOLK_DEEP = hex("#ffbc3f");
const INK = hex("#17212b");
const CHEEK = hex("#ff9d8c");
const TONGUE = hex("#ff8a86");
const WHITE = [255, 255, 255];
const FRECKLES = [[0.25, 0.62, 0.28], [0.31, 0.72, 0.16], [0.2, 1.02, 0.13], [0.32, 0.6, -0.2], [0.18, 0.95, -0.2], [0.06, 0.75, -0.36], [0.1, 1.1, 0.05], [0.27, 0.8, -0.16]];
const MOUTH_TOP = 0.772;
const SMILE = smile([-0.095, MOUTH_TOP], [0.095, MOUTH_TOP], 0.055, 16);

export function paint([px, y, z]) {
  const x = Math.abs(px);
  let c = mix(SHELL, SHELL_SHADE, 0.5 * smoothstep(0.75, 0.35, y));
  for (const [fx, fy, fz] of FRECKLES) if (Math.hypot(x - fx, y - fy, z - fz) < 0.017) c = SHELL_SHADE;
  const turn = (Math.atan2(px, z) / Math.PI) * 9;
  const edge = 0.5 + 0.035 * (Math.abs((((turn % 2) + 2) % 2) - 1) - 0.5) * 2;
  const body = Math.hypot(x, z) < 0.43;
  if (body && y < edge) c = y > edge - 0.024 ? WHITE : mix(Math.abs((((turn * 2) % 2) + 2) % 2 - 1) < 0.4 ? STRIPE : TROUSERS, INK, 0.12 * smoothstep(0.35, 0.2, y));
  if (!body && y < 0.64) c = y > 0.555 ? WHITE : mix(YOLK, YOLK_DEEP, 0.6 * smoothstep(0.5, 0.4, y));
  if (shoe(x, y, z) < 0.004) c = y < 0.022 ? YOLK_DEEP : mix(YOLK_DEEP, YOLK, smoothstep(0.02, 0.09, y));
  if (y > 1.225) c = mix(YOLK_DEEP, YOLK, smoothstep(1.22, 1.3, y));
  return z > 0.1 && y > 0.6 && y < 1.1 && x < 0.3 ? face(c, x, px, y) : c;
}

function face(colour, x, px, y) {
  let c = colour;
  if (inEllipse(x, y, [0.178, 0.79], [0.042, 0.029])) c = over(c, CHEEK, 0.85);
  const lip = MOUTH_TOP - 0.055 * (1 - (x / 0.095) ** 2);
  if (x < 0.095 && y < MOUTH_TOP && y > lip) c = inEllipse(x, y, [0, 0.722], [0.045, 0.022]) ? TONGUE : INK;
  if (toPath([x, y], SMILE) < 0.0085) c = INK;
  if (toPath([x, y], [[0.075, 0.985], [0.105, 1.0], [0.135, 0.99]]) < 0.008) c = INK;
  if (inEllipse(x, y, [0.102, 0.885], [0.043, 0.062])) {
    c = INK;
    const ex = Math.sign(px) * (x - 0.102);
    if (inEllipse(ex, y, [-0.013, 0.91], [0.016, 0.019])) c = WHITE;
    if (inEllipse(ex, y, [0.014, 0.862], [0.008, 0.009])) c = WHITE;
  }
  return c;
}

/** The face has twice the texels. */
export const zone = ([x, y, z]) => (z > 0.12 && y > 0.66 && y < 1.05 && Math.abs(x) < 0.26 ? { name: "face", density: 1.9 } : null);
