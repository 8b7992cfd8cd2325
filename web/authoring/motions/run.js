// A run: two steps in 0.72 s at 3 m/s, four times. Each foot stands for 0.22 s; both are in the air in between.
import { alternate, perform, swap } from "../kit/score.js";

const HALF = 0.36;
const STRIDE = 216;
const AIR = 0.14;
// The left foot leaves at 0 and lands ahead at 0.5; the right one half a cycle later.
const swing = (leave, from) => {
  const to = from + STRIDE;
  return [leave, leave + HALF + AIR, { x: 6, yaw: 3, z: to, heel: 74, toes: 6, path: [[leave + 0.12, 6, 34, from + 26], [leave + 0.28, 6, 30, from + 128], [leave + 0.42, 6, 9, to - 12]] }];
};
const forward = [[0.06, 46], [0.42, -46]];
const opposite = [[0.06, -46], [0.42, 46]];
const elbow = [[0.06, 104], [0.42, 84]];
const bounce = (a, b) => swap(HALF, [[0.05, a], [0.24, b]], [[0.05, a], [0.24, b]]);

export const TRAVELS = [0, 0, 4 * STRIDE];
export const makeRun = () => perform({
  period: 2 * HALF,
  cycles: 4,
  travel: STRIDE,
  flights: [0, HALF].map((start) => ({ start, end: start + AIR, rise: 0, fall: 0, x: [0, 0], z: [0, 0] })),
  mass: { y: [[0.25, -6], [0.61, -6]], x: [[0.25, -1.5], [0.61, 1.5]], z: [[0.25, -1], [0.61, -1]] },
  body: {
    pitch: [[0, 9]],
    roll: alternate(HALF, [[0.05, 0], [0.24, 4]]),
    yaw: alternate(HALF, [[0.02, -9], [0.2, 0]]),
    curl: bounce(4, 8),
    bend: alternate(HALF, [[0.05, 0], [0.24, -5]]),
    twist: alternate(HALF, [[0.02, 16], [0.2, 2]]),
    nod: bounce(-3, 3),
  },
  arms: { Left: { forward, elbow, out: [[0, 14]] }, Right: { forward: opposite, elbow: [[0.06, 84], [0.42, 104]], out: [[0, 14]] } },
  feet: { Left: { steps: [swing(0, -46)] }, Right: { steps: [swing(HALF, -46 + STRIDE / 2)] } },
});
