// A small two-legged dinosaur, 1.5 m tall, front at +z: a big head, a pear of a body, drumstick legs, a tail to balance it.
import { ellipsoid, grown, limb, mirrored, sphere, standing, union } from "../../kit/sdf.js";

// The head is drawn at one size and shown at another.
const NAPE = [0, 1.0, 0.04];
const GROWN = 1.2;
export const toHead = (p) => p.map((v, k) => NAPE[k] + (v - NAPE[k]) / GROWN);
const head = (k, ...fields) => grown(NAPE, GROWN, union(k, ...fields));

/** Middle of the left eyeball, its radius, and where it looks. */
export const EYE = { at: [0.135, 1.265, 0.185], radius: 0.105, towards: [0.5, 0.1, 0.86] };

const trunk = union(0.16,
  ellipsoid([0, 0.56, 0], [0.285, 0.31, 0.27]),
  limb([[0, 0.62, 0, 0.2], [0, 0.85, 0.0, 0.17], [0, 1.05, 0.05, 0.16]]),
);
const tail = limb([[0, 0.5, -0.1, 0.2], [0, 0.37, -0.38, 0.15], [0, 0.27, -0.63, 0.1], [0, 0.29, -0.86, 0.06], [0, 0.39, -1.02, 0.03]]);
const skull = head(0.1,
  ellipsoid([0, 1.2, 0.09], [0.25, 0.225, 0.25]),
  ellipsoid([0, 1.1, 0.31], [0.19, 0.125, 0.19], 4),
);

// One side of what comes in pairs.
const eye = head(0.05, sphere(EYE.at, EYE.radius));
const nostril = head(0.02, ellipsoid([0.065, 1.19, 0.44], [0.034, 0.024, 0.034]));
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
  [[0, 1.49, 0.06], [0, 1.62, 0.02], 0.06],
  [[0, 1.4, -0.15], [0, 1.52, -0.24], 0.072],
  [[0, 1.15, -0.18], [0, 1.23, -0.32], 0.074],
  [[0, 0.9, -0.18], [0, 0.96, -0.34], 0.072],
  [[0, 0.66, -0.25], [0, 0.72, -0.42], 0.072],
  [[0, 0.48, -0.43], [0, 0.58, -0.55], 0.064],
  [[0, 0.36, -0.65], [0, 0.46, -0.72], 0.05],
];
const plates = union(0.001, ...PLATES.map(([a, b, r]) => limb([[...a, r], [...b, 0.026]], 4)));

export const field = standing(0.03, 0,
  union(0.025,
    union(0.05,
      mirrored(0.05, union(0.05, eye, leg, arm)),
      union(0.12, trunk, tail, skull),
    ),
    mirrored(0.01, toes),
    mirrored(0.02, nostril),
    plates,
  ),
);
export const plateField = plates;
export const toeField = mirrored(0.01, toes);

export const BOX = [[-0.5, -0.05, -1.15], [0.5, 1.75, 0.75]];

/** Finer at the face, the hands and toes, the plates' tips and the tail's end. */
export function size([x, y, z]) {
  const near = (c, r) => Math.max(0, 1 - Math.hypot(Math.abs(x) - c[0], y - c[1], z - c[2]) / r);
  const fine = Math.max(near([0.1, 1.22, 0.38], 0.45), near([0.32, 0.73, 0.35], 0.2), near([0.24, 0.03, 0.22], 0.22), near([0, 0.39, -1.02], 0.25));
  return 1 - 0.42 * Math.min(1, 1.6 * fine) - (plates(x, y, z) < 0.03 ? 0.15 : 0);
}
