// How alive a dance is beside the human's, each in its own heights, measured on the mesh that is seen.

import type { Motion, Performance } from "../../src/engine/types";
import { STAGE_HEIGHT } from "../../src/util/constants";
import { Samples } from "./measures";

export interface Life {
  /** How far the body's middle rises and falls, over the middle of the human's joints. */
  rise: number;
  /** How far paired points move about where they are on average, body-locally, over their joints. */
  amplitude: number;
  /** Heights per second, the 95th percentile over vertices that touch the ground in two frames. */
  slide: number;
  /** The step from the end to the beginning over the 95th percentile of steps. */
  seam: number;
  /** The part of frames in which nothing stands and nothing flies. */
  floats: number;
  /** How far the surface moves on average, peak to peak, in heights; travel removed. */
  movement: number;
}

/** pairs: C, the joint of each point or -1; rest: V x 3; places: T of V x 3, world. */
export function lifeOf(
  motion: Motion,
  dance: Performance,
  pairs: ArrayLike<number>,
  rest: Float32Array,
  faces: Uint32Array,
  places: readonly Float32Array[],
): Life {
  const samples = new Samples(rest, faces, 500);
  const seen = places.map((frame) => samples.at(frame));
  const joints = motion.joints.length;
  const human = heightOf(motion.local.subarray(0, 3 * joints));
  const middle = seen.map((frame) => mean(frame.filter((_, i) => i % 3 === 1)));
  const theirs = Array.from({ length: motion.frames }, (_, f) =>
    mean(motion.positions.subarray(3 * joints * f, 3 * joints * (f + 1)).filter((_, i) => i % 3 === 1)),
  );
  let [own, its] = [0, 0];
  for (let c = 0; c < pairs.length; c++) {
    if (pairs[c]! < 0) continue;
    own += spread(dance.controls, pairs.length, c) / STAGE_HEIGHT ** 2;
    its += spread(motion.local, joints, pairs[c]!) / human ** 2;
  }
  const steps = Array.from({ length: dance.frames }, (_, f) => step(dance, (f + dance.frames - 1) % dance.frames, f));
  const seam = steps.shift()!;
  return {
    rise: range(middle) / STAGE_HEIGHT / (range(theirs) / human),
    amplitude: Math.sqrt(own / its),
    slide: percentile(slides(places), 0.95) / STAGE_HEIGHT,
    seam: seam / percentile(steps, 0.95),
    floats: floating(dance) / dance.frames,
    movement: movement(seen) / STAGE_HEIGHT,
  };
}

const mean = (values: Float32Array): number => values.reduce((sum, x) => sum + x, 0) / values.length;
const range = (values: readonly number[]): number => Math.max(...values) - Math.min(...values);
const percentile = (values: number[], part: number): number => values.sort((a, b) => a - b)[Math.floor(part * (values.length - 1))] ?? 0;
const heightOf = (places: Float32Array): number => range(Array.from(places.filter((_, i) => i % 3 === 1)));

/** Mean square distance from its mean of the `index`th of `count` tracks. */
function spread(tracks: Float32Array, count: number, index: number): number {
  const frames = tracks.length / 3 / count;
  let sum = 0;
  for (let k = 0; k < 3; k++) {
    const along = Float32Array.from({ length: frames }, (_, f) => tracks[3 * (f * count + index) + k]!);
    const centre = mean(along);
    for (const x of along) sum += (x - centre) ** 2 / frames;
  }
  return sum;
}

function step({ controls, frames }: Performance, a: number, b: number): number {
  const size = controls.length / frames;
  let sum = 0;
  for (let i = 0; i < size; i++) sum += (controls[a * size + i]! - controls[b * size + i]!) ** 2;
  return Math.sqrt(sum);
}

/** Metres per second of what lies within half a percent of a height above the ground, then and before. */
function slides(places: readonly Float32Array[]): number[] {
  const found: number[] = [];
  for (let f = 1; f < places.length; f++) {
    const [before, now] = [places[f - 1]!, places[f]!];
    for (let i = 0; i < now.length; i += 3) {
      if (now[i + 1]! > 0.005 * STAGE_HEIGHT || before[i + 1]! > 0.005 * STAGE_HEIGHT) continue;
      found.push(30 * Math.hypot(now[i]! - before[i]!, now[i + 2]! - before[i + 2]!));
    }
  }
  return found;
}

function floating({ contacts, flights, frames }: Performance): number {
  const controls = contacts.length / frames;
  let count = 0;
  for (let f = 0; f < frames; f++) {
    const stands = contacts.subarray(f * controls, (f + 1) * controls).includes(1);
    if (!stands && !flights.some(([a, b]) => a < f && f < b)) count++;
  }
  return count;
}

function movement(seen: readonly Float32Array[]): number {
  const count = seen[0]!.length / 3;
  const way = seen.map((frame) => [0, 1, 2].map((k) => (k === 1 ? 0 : mean(frame.filter((_, i) => i % 3 === k)))));
  let sum = 0;
  for (let s = 0; s < count; s++) {
    const spans = [0, 1, 2].map((k) => range(seen.map((frame, f) => frame[3 * s + k]! - way[f]![k]!)));
    sum += Math.hypot(...spans) / count;
  }
  return sum;
}
