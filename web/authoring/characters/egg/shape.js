// An egg that has pulled its trousers up, 1.3 m tall, front at +z: stubby arms and legs, and one curl on top.
import { ellipsoid, limb, mirrored, sphere, standing, union } from "../../kit/sdf.js";

const shell = union(0.3,
  ellipsoid([0, 0.57, 0], [0.4, 0.41, 0.38]),
  ellipsoid([0, 0.86, 0], [0.27, 0.36, 0.26]),
);
const curl = limb([[0, 1.19, 0, 0.045], [0, 1.28, -0.03, 0.036], [0, 1.335, 0.02, 0.03], [0, 1.32, 0.075, 0.024]]);
const leg = union(0.05,
  limb([[0.165, 0.27, 0, 0.1], [0.17, 0.15, 0, 0.082], [0.175, 0.08, 0.02, 0.082]]),
  ellipsoid([0.185, 0.065, 0.075], [0.108, 0.085, 0.165]),
);
const arm = union(0.04,
  limb([[0.34, 0.7, 0.02, 0.07], [0.46, 0.63, 0.05, 0.058], [0.53, 0.53, 0.09, 0.056]]),
  sphere([0.55, 0.475, 0.11], 0.085),
  sphere([0.49, 0.5, 0.165], 0.04),
);
export const shoe = mirrored(0.01, ellipsoid([0.185, 0.065, 0.075], [0.118, 0.1, 0.175]));
export const field = standing(0.03, 0, union(0.035, shell, curl, mirrored(0.03, union(0.05, leg, arm))));
export const BOX = [[-0.75, -0.05, -0.5], [0.75, 1.45, 0.5]];

/** Finer at the face, the hands, the feet and the curl. */
export function size([x, y, z]) {
  const near = (c, r) => Math.max(0, 1 - Math.hypot(Math.abs(x) - c[0], y - c[1], z - c[2]) / r);
  return 1 - 0.42 * Math.min(1, 1.6 * Math.max(near([0.1, 0.86, 0.28], 0.26), near([0.53, 0.5, 0.12], 0.2), near([0.18, 0.05, 0.1], 0.22), near([0, 1.3, 0.02], 0.16)));
}
