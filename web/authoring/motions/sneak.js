// On tiptoe past the sleeping dog: two long, low, careful steps in 2.8 s, twice. Each foot hangs in the air before it is put down.
import { alternate, perform, swap } from "../kit/score.js";

const HALF = 1.4;
const STEP = 46;
const step = (leave, to) => [leave, leave + 0.95, { x: 8, z: to, heel: 30, toes: 26, path: [[leave + 0.35, 9, 30, to - STEP - 22], [leave + 0.68, 8, 30, to - 8]] }];
const paw = (t) => ({
  forward: swap(HALF, [[t, 58], [t + 0.5, 74]], [[t, 58], [t + 0.5, 66]]),
  out: [[0, 12], [0.7, 18], [1.4, 12], [2.1, 18]],
  elbow: [[0, 112], [0.7, 96], [1.4, 112], [2.1, 96]],
  wrist: [[0, -46], [0.7, -30], [1.4, -46], [2.1, -30]],
});

export const TRAVELS = [0, 0, 4 * STEP];
export const makeSneak = () => perform({
  period: 2 * HALF,
  cycles: 2,
  travel: 2 * STEP,
  mass: {
    y: swap(HALF, [[0.05, -17], [0.55, -9], [1.1, -15]], [[0.05, -17], [0.55, -9], [1.1, -15]]),
    x: alternate(HALF, [[0.15, -7.5], [0.6, -8.5], [0.98, -5]]),
    z: swap(HALF, [[0.1, 2], [0.6, -1], [1.1, 1]], [[0.1, 2], [0.6, -1], [1.1, 1]]),
  },
  body: {
    pitch: swap(HALF, [[0.1, 20], [0.6, 13], [1.1, 21]], [[0.1, 20], [0.6, 13], [1.1, 21]]),
    roll: alternate(HALF, [[0.2, -4], [0.7, -6], [1.1, -1]]),
    yaw: alternate(HALF, [[0.2, 2], [0.9, -8]]),
    curl: swap(HALF, [[0.1, 22], [0.6, 28], [1.1, 18]], [[0.1, 22], [0.6, 28], [1.1, 18]]),
    bend: alternate(HALF, [[0.2, 4], [0.7, 8]]),
    twist: alternate(HALF, [[0.2, -4], [0.9, 12]]),
    nod: swap(HALF, [[0.15, 4], [0.6, -8], [1.1, 8]], [[0.15, 4], [0.6, -8], [1.1, 8]]),
    look: [[0.2, 0], [0.7, 34], [1.15, 30], [1.6, 0], [2.1, -36], [2.55, -30]],
  },
  arms: { Left: paw(0.15), Right: paw(0.4) },
  feet: { Left: { steps: [step(0.1, STEP)], heel: [[0, 24]], stand: { splay: 12 } }, Right: { steps: [step(HALF + 0.1, 2 * STEP)], heel: [[0, 24]], stand: { splay: 12 } } },
});
