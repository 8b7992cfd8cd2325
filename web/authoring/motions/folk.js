// A barn dance: hops from foot to foot with the free one kicked out in front, arms akimbo. 0.8 s, three times.
import { alternate, perform, swap } from "../kit/score.js";

const HALF = 0.4;
const AIR = 0.14;
// One foot's round, counted from its landing at 0.14: it leaves at 0.4, kicks, and comes back.
const kick = (t) => [t, t + 2 * HALF - HALF + AIR, { heel: 46, toes: 22, path: [[t + 0.2, 12, 17, -8], [t + 0.36, 15, 30, 38], [t + 0.46, 13, 12, 12]] }];
const akimbo = { out: [[0, 52]], elbow: [[0, 112]], forward: [[0, -30]], turn: [[0, -50]], shrug: [[0.06, 5], [0.22, -3]], wrist: [[0, -20]] };
const beat = (a, b) => swap(HALF, [[0.07, a], [0.25, b]], [[0.07, a], [0.25, b]]);

export const makeFolk = () => perform({
  period: 2 * HALF,
  cycles: 3,
  flights: [0, HALF].map((start, k) => ({ start, end: start + AIR, rise: 3, fall: 2, x: k ? [3.4, -2] : [-3.4, 2], z: [0, 0] })),
  mass: { y: [[0.25, -8], [0.65, -8]], x: [[0.27, 5.4], [0.67, -5.4]], z: [[0.27, 0], [0.67, 0]] },
  body: {
    pitch: [[0, -3]],
    roll: alternate(HALF, [[0.05, -2], [0.26, 5]]),
    yaw: alternate(HALF, [[0.06, 6], [0.26, -7]]),
    curl: beat(-2, 7),
    bend: alternate(HALF, [[0.07, 3], [0.27, -8]]),
    twist: alternate(HALF, [[0.06, -6], [0.26, 8]]),
    nod: beat(-7, 6),
    tilt: alternate(HALF, [[0.08, -3], [0.28, 10]]),
    look: alternate(HALF, [[0.08, -4], [0.28, -10]]),
  },
  arms: { Left: { ...akimbo, shrug: beat(6, -3) }, Right: { ...akimbo, shrug: beat(6, -3) } },
  // The right foot leaves at 0, the left one at 0.4.
  feet: { Left: { steps: [kick(HALF)], stand: { x: 8 } }, Right: { steps: [kick(0)], stand: { x: 8 } } },
});
