// A puppy on four legs, 1.2 m tall, front at +z: a head too large for it, hanging ears, a tail in the air.
import { ellipsoid, limb, mirrored, standing, union } from "../../kit/sdf.js";

const trunk = union(0.16, ellipsoid([0, 0.5, -0.14], [0.26, 0.24, 0.34]), ellipsoid([0, 0.52, 0.13], [0.25, 0.25, 0.24]));
const neck = limb([[0, 0.62, 0.14, 0.19], [0, 0.8, 0.25, 0.18]]);
const skull = union(0.08, ellipsoid([0, 0.96, 0.33], [0.29, 0.255, 0.265]), ellipsoid([0, 0.87, 0.56], [0.16, 0.115, 0.15]));
export const NOSE = [0, 0.925, 0.69];
const nose = ellipsoid(NOSE, [0.06, 0.042, 0.04]);
const tail = limb([[0, 0.6, -0.44, 0.075], [0, 0.74, -0.58, 0.064], [0, 0.9, -0.62, 0.055], [0, 0.99, -0.56, 0.04]]);
export const ear = limb([[0.2, 1.13, 0.27, 0.06], [0.31, 1.08, 0.27, 0.075], [0.365, 0.94, 0.29, 0.08], [0.36, 0.82, 0.32, 0.06]]);
const fore = union(0.05, limb([[0.15, 0.44, 0.19, 0.115], [0.16, 0.22, 0.21, 0.088], [0.16, 0.08, 0.22, 0.086]]), ellipsoid([0.165, 0.055, 0.27], [0.1, 0.078, 0.13]));
const hind = union(0.06, ellipsoid([0.18, 0.37, -0.31], [0.13, 0.19, 0.17]), limb([[0.19, 0.28, -0.35, 0.105], [0.195, 0.15, -0.4, 0.082], [0.195, 0.08, -0.36, 0.082]]), ellipsoid([0.2, 0.055, -0.31], [0.1, 0.078, 0.13]));

export const field = standing(0.03, 0, union(0.02, union(0.1, trunk, neck, skull, tail, mirrored(0.04, union(0.05, fore, hind))), mirrored(0.02, ear), nose));
export const BOX = [[-0.55, -0.05, -0.8], [0.55, 1.35, 0.85]];

/** Finer at the face, the paws, the ears and the tail. */
export function size([x, y, z]) {
  const near = (c, r) => Math.max(0, 1 - Math.hypot(Math.abs(x) - c[0], y - c[1], z - c[2]) / r);
  return 1 - 0.42 * Math.min(1, 1.6 * Math.max(near([0.08, 0.93, 0.6], 0.34), near([0.16, 0.03, 0.3], 0.2), near([0.2, 0.03, -0.28], 0.2), near([0.36, 0.88, 0.3], 0.2), near([0, 0.97, -0.57], 0.2)));
}
