// Standing and breathing, 4 s: in until 1.2, out until 2.8; the weight goes from one leg to the other and the head looks around.
import { perform } from "../kit/score.js";

const hang = (phase) => ({
  forward: [[phase, 5], [2 + phase, 1]], out: [[0.2, 10], [1.35, 14], [2.9, 9]], elbow: [[0.3, 16], [1.5, 22], [3.0, 15]], shrug: [[0.1, 0], [1.25, 5], [2.8, -1]],
});

export const makeIdle = () => perform({
  period: 4,
  mass: { y: [[0, -1.6], [1.2, 0], [2.8, -2], [3.4, -2]], x: [[0.4, 4], [1.4, 3.4], [2.4, -3.6], [3.4, -3]], z: [[0, 0.3], [1.4, -0.5], [2.8, 0.5]] },
  body: {
    pitch: [[0, 2], [1.3, 0], [2.8, 3]],
    roll: [[0.4, -2.6], [1.4, -2], [2.4, 2.6], [3.4, 2]],
    yaw: [[0.5, 2], [2.5, -2]],
    curl: [[0, 4], [1.25, -3], [2.8, 6]],
    bend: [[0.4, 3], [1.4, 2], [2.4, -3], [3.4, -2]],
    twist: [[0.6, -2], [2.6, 2]],
    nod: [[0.1, 3], [1.3, -4], [2.8, 5]],
    tilt: [[0.5, 5], [1.5, 3], [2.5, -5], [3.5, -3]],
    look: [[0.3, 0], [0.8, 16], [1.5, 15], [2.1, 0], [2.7, -18], [3.4, -16]],
  },
  arms: { Left: hang(0), Right: hang(0.5) },
});
