// A desk lamp that looks at you, 1.3 m tall, front at +z: a heavy foot, an arm with an elbow, and a shade whose light is its face.
import { carve, ellipsoid, limb, sphere, standing, union } from "../../kit/sdf.js";
import { add, scale } from "../../kit/vec3.js";

/** From the back of the shade to where it shines, and what is up for the face. */
export const AXIS = [0, -0.0995, 0.995];
export const UP = [0, 0.995, 0.0995];
const BACK = [0, 1.06, 0.02];
const on = (t) => add(BACK, scale(AXIS, t));
export const RADIUS = 0.29;
const FRONT = 0.35;
/** Middle of the face. */
export const FACE = on(FRONT);

const beyond = Object.assign((x, y, z) => FRONT - ((x - BACK[0]) * AXIS[0] + (y - BACK[1]) * AXIS[1] + (z - BACK[2]) * AXIS[2]), { low: [-1, 0, 0], high: [1, 2, 2] });
const row = (t, r) => [...on(t), r];
const shade = carve(0.05, union(0.05, limb([row(0, 0.1), row(0.12, 0.17), row(0.24, 0.25), row(0.36, RADIUS)], 6), sphere(on(-0.1), 0.06)), beyond);
export const lower = limb([[0, 0.1, -0.02, 0.055], [0, 0.52, -0.24, 0.045]]);
export const upper = limb([[0, 0.54, -0.24, 0.045], [0, 0.98, -0.02, 0.045]]);
export const elbow = sphere([0, 0.53, -0.245], 0.078);
export const foot = union(0.05, ellipsoid([0, 0.05, 0], [0.36, 0.1, 0.34]), ellipsoid([0, 0.12, -0.02], [0.13, 0.09, 0.13]));

export const field = standing(0.03, 0, union(0.03, foot, lower, elbow, upper, shade));
export const BOX = [[-0.5, -0.05, -0.5], [0.5, 1.5, 0.85]];

/** Finer at the arm, the elbow and the face. */
export function size([x, y, z]) {
  const arm = Math.min(lower(x, y, z), upper(x, y, z), elbow(x, y, z)) < 0.02 ? 1 : 0;
  const face = Math.max(0, 1 - Math.hypot(x, y - FACE[1], z - FACE[2]) / 0.4);
  return 1 - 0.45 * Math.max(arm, Math.min(1, 1.4 * face));
}
