// A clip's frames: where its joints are and how they are turned, at the pace of its own keys.

import { type AnimationClip, AnimationMixer, LoopOnce, type Object3D, Quaternion, Vector3 } from "three";

import type { Joint } from "./joints-of-tree";

export interface Sampled {
  readonly fps: number;
  /** By frame and joint, in the world. */
  readonly positions: readonly (readonly Vector3[])[];
  readonly turns: readonly (readonly Quaternion[])[];
}

export type Pose = readonly [positions: Vector3[], turns: Quaternion[]];

const SLOWEST = 24;
const FASTEST = 120;
/** More than two hours at 60 frames a second. */
const MOST_FRAMES = 500_000;

/** Positions in units of the tree. A clip of one frame gives one. */
export function sampleClip(tree: Object3D, joints: readonly Joint[], clip: AnimationClip): Sampled {
  const fps = paceOf(clip);
  const [from, to] = spanOf(clip);
  const frames = Math.min(MOST_FRAMES, Math.round((to - from) * fps) + 1);
  const mixer = new AnimationMixer(tree);
  const action = mixer.clipAction(clip).setLoop(LoopOnce, 1).play();
  const positions: Vector3[][] = [];
  const turns: Quaternion[][] = [];
  for (let f = 0; f < frames; f++) {
    action.time = Math.min(from + f / fps, to);
    mixer.update(0);
    const [at, turned] = poseOf(tree, joints);
    positions.push(at);
    turns.push(turned);
  }
  mixer.stopAllAction(); // as it was at rest
  mixer.uncacheRoot(tree);
  return { fps, positions, turns };
}

/** From its first key to its last, in seconds. */
export function spanOf({ tracks }: AnimationClip): [from: number, to: number] {
  const all = tracks.flatMap(({ times }) => [times[0], times[times.length - 1]]);
  return [Math.min(...all), Math.max(...all)];
}

/** How the joints stand now. */
export function poseOf(tree: Object3D, joints: readonly Joint[]): Pose {
  tree.updateMatrixWorld(true);
  const positions: Vector3[] = [];
  const turns: Quaternion[] = [];
  for (const { object } of joints) {
    const [position, turn] = [new Vector3(), new Quaternion()];
    object.matrixWorld.decompose(position, turn, scale);
    positions.push(position);
    turns.push(turn);
  }
  return [positions, turns];
}

const scale = new Vector3();

/** Frames a second: the commonest spacing of its keys, or a whole part or multiple of it that is a usual pace. */
export function paceOf({ tracks }: AnimationClip): number {
  const seen = new Map<number, number>();
  for (const { times } of tracks) {
    for (let k = 1; k < times.length; k++) {
      const pace = Math.round(100 / (times[k] - times[k - 1])) / 100;
      if (Number.isFinite(pace) && pace > 0) seen.set(pace, (seen.get(pace) ?? 0) + 1);
    }
  }
  const [commonest = 30] = [...seen].reduce<[number?, number?]>((best, each) => (each[1] > (best[1] ?? 0) ? each : best), []);
  // Times are single precision: 29.99 and 30.01 are 30.
  const near = [24, 25, 30, 48, 50, 60, 100, 120].find((usual) => Math.abs(usual - commonest) < 0.01 * usual);
  const pace = near ?? commonest;
  if (pace < SLOWEST) return pace * Math.ceil(SLOWEST / pace);
  return pace > FASTEST ? pace / Math.ceil(pace / FASTEST) : pace;
}
