// A small two-legged dinosaur, 1.5 m tall, front at +z: a big head, a pear of a body, drumstick legs, a tail to balance it.
import { ellipsoid, limb, mirrored, sphere, standing, union } from "../../kit/sdf.js";

export const EYE = [0.168, 1.235, 0.235];
export const SNOUT = [0, 1.1, 0.33];

const trunk = union(0.16,
  ellipsoid([0, 0.56, 0], [0.285, 0.31, 0.27]),
  limb([[0, 0.62, 0, 0.2], [0, 0.85, 0.0, 0.17], [0, 1.05, 0.05, 0.16]]),
);
const tail = limb([[0, 0.5, -0.1, 0.2], [0, 0.37, -0.38, 0.15], [0, 0.27, -0.63, 0.1], [0, 0.29, -0.86, 0.06], [0, 0.39, -1.02, 0.03]]);
const head = union(0.1,
  ellipsoid([0, 1.2, 0.09], [0.25, 0.225, 0.25]),
  ellipsoid(SNOUT, [0.185, 0.125, 0.2], 4),
);

// One side of what comes in pairs.
const brow = sphere([0.155, 1.3, 0.2], 0.1);
const nostril = ellipsoid([0.07, 1.195, 0.46], [0.035, 0.025, 0.035]);
const leg = union(0.06,
  ellipsoid([0.215, 0.4, 0.02], [0.125, 0.185, 0.165]),
  limb([[0.225, 0.3, 0.02, 0.11], [0.23, 0.17, -0.03, 0.085], [0.23, 0.09, 0.0, 0.085]]),
  ellipsoid([0.235, 0.06, 0.09], [0.115, 0.085, 0.165]),
);
const toes = union(0.01, ...[[0.155, 0.2], [0.24, 0.235], [0.32, 0.195]].map(([x, z]) => ellipsoid([x, 0.045, z], [0.046, 0.055, 0.06])));
const arm = union(0.03,
  limb([[0.19, 0.84, 0.1, 0.075], [0.29, 0.76, 0.17, 0.062], [0.33, 0.7, 0.26, 0.055], [0.32, 0.72, 0.33, 0.055]]),
  sphere([0.295, 0.755, 0.372], 0.03),
  sphere([0.35, 0.745, 0.372], 0.03),
);

/** Base and tip of each plate of the back, and the radius at its base. */
export const PLATES = [
  [[0, 1.39, 0.06], [0, 1.5, 0.02], 0.05],
  [[0, 1.31, -0.12], [0, 1.41, -0.2], 0.06],
  [[0, 1.1, -0.11], [0, 1.15, -0.24], 0.062],
  [[0, 0.88, -0.17], [0, 0.93, -0.32], 0.066],
  [[0, 0.66, -0.25], [0, 0.71, -0.41], 0.068],
  [[0, 0.49, -0.42], [0, 0.58, -0.53], 0.06],
  [[0, 0.36, -0.64], [0, 0.45, -0.71], 0.048],
];
const plates = union(0.001, ...PLATES.map(([a, b, r]) => limb([[...a, r], [...b, 0.022]], 4)));

export const field = standing(0.03, 0,
  union(0.025,
    union(0.05,
      mirrored(0.05, union(0.05, brow, leg, arm)),
      union(0.12, trunk, tail, head),
    ),
    mirrored(0.01, toes),
    mirrored(0.02, nostril),
    plates,
  ),
);
export const plateField = plates;
export const toeField = mirrored(0.01, toes);

export const BOX = [[-0.5, -0.05, -1.15], [0.5, 1.6, 0.65]];

/** Finer at the face, the hands and toes, the plates' tips and the tail's end. */
export function size([x, y, z]) {
  const near = (c, r) => Math.max(0, 1 - Math.hypot(Math.abs(x) - c[0], y - c[1], z - c[2]) / r);
  const fine = Math.max(near([0.1, 1.2, 0.35], 0.4), near([0.32, 0.73, 0.35], 0.2), near([0.24, 0.03, 0.22], 0.22), near([0, 0.39, -1.02], 0.25));
  return 1 - 0.42 * Math.min(1, 1.6 * fine) - (plates(x, y, z) < 0.03 ? 0.15 : 0);
}
