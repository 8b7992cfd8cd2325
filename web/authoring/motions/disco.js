// Side steps with a finger in the air, 4 s at 120 beats a minute: out, close and point at 0.75; out again, close at 1.75; then the other side.
import { alternate, perform, swap } from "../kit/score.js";

const HALF = 2;
const pointing = {
  forward: [[0, 20], [0.22, -20], [0.72, 18], [1.0, 14], [1.25, 34], [1.75, 40]],
  out: [[0, 22], [0.22, 18], [0.68, 150], [0.95, 142], [1.25, 30], [1.7, 18]],
  elbow: [[0, 70], [0.25, 96], [0.7, 4], [0.95, 8], [1.25, 60], [1.72, 92]],
};
const hipHand = {
  forward: [[0, -16], [0.5, -24], [1.0, -18], [1.3, 24], [1.75, 4]],
  out: [[0, 38], [0.5, 44], [1.0, 40], [1.3, 26], [1.75, 34]],
  elbow: [[0, 88], [0.5, 96], [1.0, 90], [1.3, 74], [1.75, 84]],
};
const arm = (a, b) => Object.fromEntries(["forward", "out", "elbow"].map((key) => [key, swap(HALF, a[key], b[key])]));
// To the left and back to the middle; the other foot follows.
const lead = [[0.02, 0.3, { x: 38, lift: 8, heel: 20 }], [1.02, 1.3, { x: 12, lift: 8, heel: 24 }]];
const close = [[0.52, 0.76, { x: -16, lift: 8, heel: 30, toes: 20 }], [1.52, 1.78, { x: 12, lift: 6, heel: 30, toes: 20 }]];
const later = (steps) => steps.map(([a, b, place]) => [a + HALF, b + HALF, place]);

export const makeDisco = () => perform({
  period: 2 * HALF,
  mass: {
    y: alternate(HALF, [[0, -3], [0.2, -9], [0.5, -3.5], [0.72, -2], [0.95, -8], [1.22, -9], [1.5, -3.5], [1.75, -7]], 1),
    x: alternate(HALF, [[0.05, 2], [0.3, 17], [0.6, 29], [0.9, 27], [1.25, 12], [1.6, 0]]),
    z: [[0, 0]],
  },
  body: {
    pitch: [[0, 4]],
    roll: alternate(HALF, [[0.1, 3], [0.35, -5], [0.72, 9], [1.0, 7], [1.35, -6], [1.75, -3]]),
    yaw: alternate(HALF, [[0.1, 8], [0.7, -18], [1.1, -10], [1.7, 12]]),
    curl: alternate(HALF, [[0.15, 8], [0.7, -6], [1.0, 2], [1.25, 9], [1.7, 6]], 1),
    bend: alternate(HALF, [[0.15, -8], [0.7, -10], [1.05, -2], [1.5, 8], [1.8, 4]]),
    twist: alternate(HALF, [[0.1, 10], [0.7, -22], [1.1, -8], [1.7, 14]]),
    nod: alternate(HALF, [[0.2, 10], [0.45, -2], [0.7, -14], [0.98, -2], [1.25, 10], [1.5, 0], [1.75, 8]], 1),
    tilt: alternate(HALF, [[0.2, -4], [0.7, 10], [1.2, 2], [1.7, -6]]),
    look: alternate(HALF, [[0.1, 10], [0.7, 22], [1.1, 14], [1.7, -4]]),
  },
  arms: { Left: arm(hipHand, pointing), Right: arm(pointing, hipHand) },
  feet: { Left: { steps: [...lead, ...later(close)] }, Right: { steps: [...close, ...later(lead)] } },
});
