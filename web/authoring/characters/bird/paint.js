// The bird's colours, by place: blue, a cream mask and belly, orange beak and legs.
import { hex, inEllipse, over, toPath } from "../../kit/brush.js";
import { mix, smoothstep } from "../../kit/vec3.js";
import { beak, legs, tuft } from "./shape.js";

const BLUE = hex("#62b6f4");
const LIGHT = hex("#9ad6ff");
const DEEP = hex("#2f78c6");
const CREAM = hex("#fff3da");
const ORANGE = hex("#ffad52");
const ORANGE_DEEP = hex("#ee8030");
const INK = hex("#17212b");
const IRIS = hex("#2c4a7a");
const CHEEK = hex("#ff9d9d");
const WHITE = [255, 255, 255];

export function paint([px, y, z]) {
  const x = Math.abs(px);
  let c = mix(BLUE, LIGHT, smoothstep(0.8, 1.2, y));
  c = over(c, DEEP, 0.35 * smoothstep(0.5, 0.28, y));
  if (tuft(x, y, z) < 0.004) c = over(LIGHT, DEEP, smoothstep(1.24, 1.36, y));
  // Feather tips: scallops of the wing's lower ends, and of the tail.
  const tip = x * 0.8 - y * 0.45 - 0.235 - 0.018 * Math.cos((y - 0.62) * 46);
  if (x > 0.34 && tip > -0.02) c = mix(BLUE, DEEP, tip > 0 ? 0.9 : 0.45);
  if (z < -0.38 && Math.abs(y - 0.5) < 0.14) c = mix(BLUE, DEEP, z < -0.46 ? 0.9 : z < -0.43 ? 0.45 : 0);
  // Belly, with a few down marks.
  const belly = z > 0 && inEllipse(x, y, [0, 0.5], [0.215, 0.26]);
  if (belly) {
    c = CREAM;
    for (const [mx, my] of [[0.05, 0.6], [0.13, 0.52], [0.04, 0.46], [0.11, 0.38]])
      if (toPath([x, y], [[mx - 0.02, my + 0.012], [mx, my - 0.006], [mx + 0.02, my + 0.012]]) < 0.0055) c = hex("#eac9a2");
  }
  // The mask: two discs about the eyes.
  if (z > 0.05 && (inEllipse(x, y, [0.1, 0.985], [0.125, 0.135]) || inEllipse(x, y, [0, 0.9], [0.1, 0.09]))) c = CREAM;
  if (z > 0.05 && inEllipse(x, y, [0.175, 0.915], [0.04, 0.031])) c = CHEEK;
  if (z > 0.05 && inEllipse(x, y, [0.108, 1.0], [0.043, 0.059])) {
    c = INK;
    if (inEllipse(x, y, [0.108, 0.97], [0.029, 0.018])) c = IRIS;
    // The lights are on the same side of both eyes, as one lamp would make them; so near the middle of each.
    if (inEllipse(x, y, [0.102, 1.024], [0.017, 0.02])) c = WHITE;
    if (inEllipse(x, y, [0.12, 0.978], [0.0085, 0.0095])) c = WHITE;
  }
  if (beak(x, y, z) < 0.004) {
    c = mix(ORANGE, ORANGE_DEEP, smoothstep(0.95, 0.89, y) * 0.6);
    if (Math.abs(y - 0.915 + 0.35 * (z - 0.33) * (z - 0.33)) < 0.005) c = hex("#c65a1c");
  }
  if (legs(x, y, z) < 0.005 && y < 0.23) c = over(ORANGE, ORANGE_DEEP, 0.5 * smoothstep(0.05, 0.0, y));
  return c;
}

export const zone = ([, y, z]) => (z > 0.14 && y > 0.84 ? { name: "face", density: 1.7 } : null);
