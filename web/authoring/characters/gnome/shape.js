// A garden gnome of weathered plaster, 1.6 m tall, as a scanner would have seen it: one surface, fine detail, not quite symmetric.
import { box, carve, ellipsoid, limb, mirrored, ring, sphere, squeezed, standing, union } from "../../kit/sdf.js";
import { noise } from "../../kit/noise.js";
import { smoothstep } from "../../kit/vec3.js";

// What comes in pairs.
const boot = union(0.03,
  limb([[0.15, 0.3, -0.01, 0.11], [0.155, 0.16, -0.01, 0.095], [0.16, 0.1, 0.0, 0.095]]),
  squeezed([0.165, 0.06, 0.07], [1, 0.85, 1], limb([[0.16, 0.07, -0.03, 0.095], [0.17, 0.07, 0.1, 0.1], [0.18, 0.075, 0.17, 0.085]])),
);
const cuffs = ring([0.152, 0.235, -0.01], [0.104, 0.108], 0.032);
const arm = limb([[0.2, 0.83, -0.01, 0.12], [0.33, 0.75, 0.0, 0.105], [0.43, 0.63, 0.03, 0.09], [0.49, 0.52, 0.07, 0.08]]);
const wrist = limb([[0.475, 0.55, 0.06, 0.1], [0.492, 0.515, 0.072, 0.1]]);
const hand = union(0.02,
  ellipsoid([0.525, 0.44, 0.1], [0.072, 0.085, 0.085]),
  limb([[0.5, 0.47, 0.14, 0.035], [0.482, 0.44, 0.185, 0.034]]),
);
const ear = ellipsoid([0.215, 1.06, 0.01], [0.05, 0.075, 0.04]);
const cheek = ellipsoid([0.115, 1.035, 0.175], [0.062, 0.05, 0.05]);
const brow = limb([[0.06, 1.2, 0.2, 0.02], [0.105, 1.226, 0.2, 0.028], [0.16, 1.208, 0.165, 0.024]]);
const socket = ellipsoid([0.09, 1.115, 0.235], [0.058, 0.048, 0.04]);
const eyeball = sphere([0.09, 1.12, 0.165], 0.06);
const moustache = limb([[0.015, 0.995, 0.25, 0.04], [0.09, 0.97, 0.235, 0.042], [0.16, 0.965, 0.195, 0.032], [0.215, 1.02, 0.15, 0.022]]);
export const PUPIL = [0.094, 1.12, 0.223];

const coat = union(0.05,
  ellipsoid([0, 0.62, 0], [0.29, 0.34, 0.255]),
  ellipsoid([0, 0.38, -0.01], [0.285, 0.14, 0.24]),
  ellipsoid([0, 0.92, 0.0], [0.225, 0.12, 0.15]), // the collar: no crevice under the beard
);
const hem = ring([0, 0.325, -0.01], [0.255, 0.215], 0.034);
const belt = squeezed([0, 0.535, 0], [1, 1.7, 1], ring([0, 0.535, 0], [0.291, 0.257], 0.024));
const buckle = carve(0.018, box([0, 0.535, 0.26], [0.085, 0.07, 0.042], 0.024), box([0, 0.535, 0.3], [0.045, 0.032, 0.03], 0.014));
const buttons = sphere([0, 0.41, 0.245], 0.032);
const pouch = union(0.016, box([-0.235, 0.455, 0.145], [0.07, 0.065, 0.05], 0.035), sphere([-0.262, 0.465, 0.196], 0.022));

const skull = ellipsoid([0, 1.06, 0.01], [0.215, 0.2, 0.2]);
const nose = ellipsoid([0.003, 1.055, 0.25], [0.068, 0.062, 0.07]);
const lip = limb([[-0.045, 0.945, 0.232, 0.02], [0, 0.934, 0.245, 0.024], [0.045, 0.945, 0.232, 0.02]]);
const beard = union(0.05,
  ellipsoid([0, 0.93, 0.09], [0.215, 0.12, 0.14]),
  limb([[0, 0.92, 0.16, 0.13], [0, 0.8, 0.2, 0.125], [0.005, 0.68, 0.24, 0.085], [0.02, 0.6, 0.275, 0.04], [0.045, 0.575, 0.295, 0.028]]),
);
const hat = limb([[0, 1.26, -0.02, 0.225], [0, 1.34, -0.035, 0.185], [0.01, 1.46, -0.045, 0.13], [0.05, 1.58, -0.04, 0.085], [0.13, 1.63, -0.02, 0.058], [0.195, 1.58, 0.0, 0.05]], 8);
const brim = ring([0, 1.235, -0.02], [0.215, 0.205], 0.044);
const pompom = sphere([0.21, 1.52, 0.01], 0.062);

const socketPair = mirrored(0.01, socket);
const face = carve(0.03, union(0.03, skull, mirrored(0.02, union(0.03, cheek, ear))), socketPair);
const hair = union(0.02, beard, mirrored(0.012, moustache));
const smooth = standing(0.012, 0, union(0.016,
  union(0.03, coat, mirrored(0.02, union(0.02, boot, arm))), hem, belt, buckle, buttons, pouch,
  mirrored(0.012, union(0.016, cuffs, wrist, hand)),
  union(0.012, face, mirrored(0.01, eyeball)), nose, lip,
  union(0.02, hair, mirrored(0.014, brow)),
  hat, brim, pompom,
));

/** Locks that run down the beard and sideways along the moustache and brows, in metres of depth. */
function locks(x, y, z) {
  const lock = (s) => Math.cos(2 * s) - 0.25 * Math.cos(4 * s); // ridges round, grooves narrow
  const down = Math.atan2(x, 0.12 + Math.max(0, z + 0.1)) * (y > 0.9 ? 17 : 17 - 9 * (y - 0.9));
  const wave = 0.6 * Math.sin(17 * y + 2 * x);
  return 0.006 * lock(down + wave) + 0.0022 * lock(2.1 * down - 1.3 * wave);
}

/** 1 on a part's surface, 0 from `reach` metres off. */
const on = (part, reach, x, y, z) => (nearBox(part, reach, x, y, z) ? smoothstep(reach, 0.3 * reach, part(x, y, z)) : 0);
const nearBox = ({ low, high }, reach, ...p) => p.every((v, k) => v > low[k] - reach && v < high[k] + reach);

function detail(...p) {
  const [x, y, z] = p;
  let d = 0.0022 * noise(x * 21, y * 21, z * 21) + 0.0012 * noise(x * 40, y * 40, z * 40) + 0.004 * noise(x * 7, y * 7, z * 7);
  d -= 0.006 * smoothstep(0.45, 0.75, noise(x * 17 + 9, y * 17, z * 17 - 4)); // pits
  const bare = (1 - on(nose, 0.03, ...p)) * (1 - on(lip, 0.02, ...p));
  const hairy = on(hair, 0.016, ...p) * bare;
  if (hairy > 0) d += hairy * locks(...p);
  // Folds of the hat, knitted ribs of its brim, wrinkles of the sleeves.
  const folds = on(hat, 0.03, ...p) * smoothstep(1.28, 1.36, y);
  if (folds > 0) d += 0.007 * folds * Math.sin(44 * y + 2.5 * Math.sin(3 * Math.atan2(z, x)) + 12 * x) * smoothstep(1.65, 1.55, y);
  const ribs = on(brim, 0.02, ...p);
  if (ribs > 0) d += 0.0045 * ribs * Math.sin(40 * Math.atan2(z + 0.012, x));
  d += 0.006 * on(pompom, 0.02, ...p) * noise(x * 45, y * 45, z * 45);
  const sleeve = on(arm, 0.016, Math.abs(x), y, z) * smoothstep(0.25, 0.32, Math.abs(x));
  if (sleeve > 0) d += 0.004 * sleeve * Math.sin(70 * (y - 0.6 * Math.abs(x)) + 9 * z);
  d -= 0.006 * smoothstep(0.03, 0.012, Math.hypot(Math.abs(x) - PUPIL[0], y - PUPIL[1], z - PUPIL[2]));
  // A coat that opens down the middle.
  const open = smoothstep(0.52, 0.48, y) * smoothstep(0, 0.1, z) * (1 - on(buttons, 0.016, ...p));
  return d - 0.006 * open * smoothstep(0.022, 0.004, Math.abs(x - 0.028 * Math.sin(7 * y)));
}

export const field = (x, y, z) => {
  const d = smooth(x, y, z);
  if (Math.abs(d) > 0.04) return d;
  return d - detail(x, y, z);
};

export const BOX = [[-0.7, -0.06, -0.4], [0.7, 1.8, 0.5]];

export function size([x, y, z]) {
  const near = Math.max(0, 1 - Math.hypot(x, y - 1.05, z - 0.22) / 0.35);
  return (1 - 0.38 * Math.min(1, 1.8 * near)) * (z < -0.05 || y < 0.3 ? 1.1 : 1);
}
