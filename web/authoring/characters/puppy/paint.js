// The puppy's colours, by place: caramel, a cream bib and socks, chocolate ears, a coral collar.
import { hex, inEllipse, over, smile, toPath } from "../../kit/brush.js";
import { mix, smoothstep } from "../../kit/vec3.js";
import { ear, NOSE } from "./shape.js";

const FUR = hex("#ffdca6");
const FUR_DEEP = hex("#fbbd74");
const CREAM = hex("#fffefa");
const EAR = hex("#b9774a");
const EAR_LIGHT = hex("#d89a6b");
const COLLAR = hex("#ff7f6b");
const TAG = hex("#ffd84f");
const INK = hex("#17212b");
const CHEEK = hex("#ff9d8c");
const TONGUE = hex("#ff8a94");
const WHITE = [255, 255, 255];
const LIP = smile([-0.09, 0.868], [0, 0.85], 0.028, 8).concat(smile([0, 0.85], [0.09, 0.868], 0.028, 8));

export function paint([px, y, z]) {
  const x = Math.abs(px);
  let c = mix(FUR_DEEP, FUR, smoothstep(0.15, 0.75, y));
  if (y > 0.7 && z < -0.35 && y > 0.86) c = CREAM; // the tail's tip
  if (y < 0.17) c = mix(c, CREAM, smoothstep(0.18, 0.16, y));
  if (z > 0.1 && y < 0.68 && x < 0.15 - 0.4 * Math.max(0, 0.42 - y)) c = CREAM;
  // The collar lies around the neck, across its way up and forward.
  const along = (y - 0.7) * 0.86 + (z - 0.2) * 0.5;
  if (Math.abs(along) < 0.028 && y < 0.85 && z > -0.1) c = COLLAR;
  if (Math.hypot(x, y - 0.585, z - 0.4) < 0.05) c = Math.hypot(x, y - 0.585, z - 0.4) < 0.042 ? TAG : COLLAR;
  if (ear(x, y, z) < 0.012 && x > 0.2) c = mix(EAR, EAR_LIGHT, smoothstep(0.82, 1.12, y));
  return z > 0.4 && y > 0.74 ? face(c, x, px, y, z) : c;
}

function face(colour, x, px, y, z) {
  let c = colour;
  // The muzzle and a blaze between the eyes are cream.
  if (Math.hypot(x / 0.165, (y - 0.86) / 0.105) < 1 || (y > 0.9 && x < 0.055 - 0.12 * (y - 0.95) && y < 1.16)) c = CREAM;
  if (inEllipse(x, y, [0.205, 0.9], [0.042, 0.03])) c = over(c, CHEEK, 0.8);
  if (z > 0.6 && inEllipse(x, y, [0, 0.803], [0.034, 0.032]) && y < 0.83) c = TONGUE;
  if (z > 0.55 && toPath([x, y], LIP) < 0.0075) c = INK;
  if (z > 0.6 && x < 0.007 && y < 0.9 && y > 0.85) c = INK;
  if (Math.hypot(x / 0.064, (y - NOSE[1]) / 0.046) < 1 && z > 0.66) c = inEllipse(px, y, [-0.018, 0.94], [0.016, 0.009]) ? WHITE : INK;
  if (toPath([x, y], [[0.09, 1.1], [0.12, 1.115], [0.15, 1.105]]) < 0.009) c = EAR;
  if (inEllipse(x, y, [0.122, 1.0], [0.043, 0.058])) {
    c = INK;
    const ex = Math.sign(px) * (x - 0.122);
    if (inEllipse(ex, y, [-0.013, 1.022], [0.016, 0.019])) c = WHITE;
    if (inEllipse(ex, y, [0.014, 0.98], [0.008, 0.009])) c = WHITE;
  }
  return c;
}

/** The face has twice the texels. */
export const zone = ([x, y, z]) => (z > 0.42 && y > 0.76 && y < 1.16 && Math.abs(x) < 0.27 ? { name: "face", density: 1.9 } : null);
