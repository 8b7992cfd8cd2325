// Where a motion is best cut to begin again as it ends. Pure.

import { FPS, type Motion } from "../engine/types";
import type { BodyPart } from "../skeleton/body-parts";

/** Frames. */
const SHORTEST = 20;
/** How far from where the user cut it a better place is looked for. */
const AROUND = 20;
/** Frames that are compared with each other at first. */
const MOST = 400;
/** Pairs that are looked at closely. */
const CLOSELY = 32;
/** Seconds: how much speeds count beside places. */
const AHEAD = 0.12;
/** Metres that a seam may be worse if the dance is longer by all of it; or if another foot stands. */
const LONGER = 0.02;
const OTHER_FOOT = 0.03;

export interface Loop {
  /** The first frame and the last, which are nearly the same. */
  readonly cut: readonly [number, number];
  /** How far joints are apart there, speeds counted: metres, root mean square. */
  readonly gap: number;
}

/** The best pair of frames of a whole motion, or the best near a cut; null where it is too short. */
export function bestLoop(motion: Motion, near?: readonly [number, number]): Loop | null {
  const last = motion.frames - 1;
  if (last < SHORTEST) return null;
  const gap = comparer(motion);
  const cost = (a: number, b: number): number => gap(a, b) + LONGER * (1 - (b - a) / last);
  const firsts = near ? range(near[0] - AROUND, near[0] + AROUND, 0, last) : [0, last];
  const lasts = near ? range(near[1] - AROUND, near[1] + AROUND, 0, last) : [0, last];
  const step = Math.ceil(Math.max(firsts[1] - firsts[0], lasts[1] - lasts[0]) / MOST) || 1;
  let found: { a: number; b: number; cost: number }[] = [];
  for (let a = firsts[0]; a <= firsts[1]; a += step) {
    let best = { a, b: -1, cost: Infinity };
    for (let b = Math.max(lasts[0], a + SHORTEST); b <= lasts[1]; b += step) {
      const here = cost(a, b);
      if (here < best.cost) best = { a, b, cost: here };
    }
    if (best.b >= 0) found.push(best);
  }
  found = found.sort((p, q) => p.cost - q.cost).slice(0, step > 1 ? CLOSELY : 1);
  let [best] = found;
  if (!best) return null;
  for (const { a: nearA, b: nearB } of step > 1 ? found : []) {
    const [[a0, a1], [b0, b1]] = [range(nearA - step, nearA + step, 0, last), range(nearB - step, nearB + step, 0, last)];
    for (let a = a0; a <= a1; a++)
      for (let b = Math.max(b0, a + SHORTEST); b <= b1; b++) {
        const here = cost(a, b);
        if (here < best.cost) best = { a, b, cost: here };
      }
  }
  return { cut: [best.a, best.b], gap: gap(best.a, best.b) };
}

const range = (from: number, to: number, low: number, high: number): [number, number] => [Math.max(from, low), Math.min(to, high)];

/** What of a body is looked at; of a body whose parts cannot be told, some joints. */
const PARTS: readonly (BodyPart | null)[] = ["head", "chest", "lower_arm", "hand", "lower_leg", "foot"];
const SOME = 16;

/** How unlike two frames are: poses, their speeds, how the body moves, and which feet stand. */
function comparer({ joints, frames, local, positions, yaw, stands }: Motion): (a: number, b: number) => number {
  const known = joints.flatMap(({ part }, j) => (PARTS.includes(part) ? [j] : []));
  const every = Math.ceil(joints.length / SOME);
  const used = known.length >= 5 ? known : joints.flatMap((_, j) => (j % every === 0 ? [j] : []));
  const width = 6 * used.length + 4;
  const share = 1 / Math.sqrt(used.length);
  const features = new Float32Array(frames * width);
  const made = new Uint8Array(frames);
  const make = (f: number): void => {
    made[f] = 1;
    const [before, after] = [Math.max(f - 1, 0), Math.min(f + 1, frames - 1)];
    const speed = (FPS * AHEAD) / (after - before);
    let at = f * width;
    for (const j of used) {
      const [here, then, next] = [f, before, after].map((frame) => 3 * (frame * joints.length + j));
      for (let k = 0; k < 3; k++) {
        features[at++] = share * local[here + k];
        features[at++] = share * speed * (local[next + k] - local[then + k]);
      }
    }
    const root = (frame: number, k: number): number => positions[3 * frame * joints.length + k];
    const [dx, dz] = [0, 2].map((k) => speed * (root(after, k) - root(before, k)));
    const [c, s] = [Math.cos(yaw[f]), Math.sin(yaw[f])];
    features.set([root(f, 1), c * dx - s * dz, s * dx + c * dz, 0.5 * speed * (yaw[after] - yaw[before])], at);
  };
  const foot = (a: number, b: number): number => Number(stands.left[a] !== stands.left[b]) + Number(stands.right[a] !== stands.right[b]);
  return (a, b) => {
    if (!made[a]) make(a);
    if (!made[b]) make(b);
    let sum = 0;
    for (let i = a * width, k = b * width, end = i + width; i < end; i++, k++) sum += (features[i] - features[k]) ** 2;
    return Math.sqrt(sum) + OTHER_FOOT * foot(a, b);
  };
}
