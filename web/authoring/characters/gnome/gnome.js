import { makeScan } from "../../kit/field-character.js";
import { hex } from "../../kit/brush.js";
import { mix, smoothstep } from "../../kit/vec3.js";
import { BOX, field, PUPIL, size } from "./shape.js";

const PLASTER = hex("#f6e6d0");
const HOLLOW = hex("#94806f");
const DARK = hex("#2f2a2a");

// Dark pupils, which read from afar, then dust in the hollows, then plaster.
const ramp = (t) => (t < 0.2 ? mix(DARK, HOLLOW, smoothstep(0.1, 0.2, t)) : mix(HOLLOW, PLASTER, smoothstep(0.2, 1, t)));

function shade([x, y, z], [, ny], openness) {
  const from = [Math.abs(x) - PUPIL[0], y - PUPIL[1], z - PUPIL[2]];
  const shine = Math.hypot(x - Math.sign(x) * PUPIL[0] + 0.009, from[1] - 0.011, from[2]) < 0.011;
  if (Math.hypot(...from) < 0.033) return shine ? 1 : 0;
  return 0.2 + 0.8 * smoothstep(0.2, 0.8, openness) * (0.9 + 0.1 * smoothstep(-0.6, 0.4, ny)) * smoothstep(-0.25, 0.2, y);
}

export const make = () => makeScan({ name: "Gnome", field, box: BOX, step: 0.0098, target: 40000, size, shade, ramp });

export { POINTS, POSES, SETTINGS } from "./project.js";
