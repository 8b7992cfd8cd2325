// How the joints of a model that brings its own clips go, so that it can dance these as they were made.

import type { Pose, Sampled } from "./sample-clip";

/** File units and axes. */
export interface OwnMoves {
  readonly fps: number;
  /** J, as the motion and the model call them. */
  readonly names: readonly string[];
  /** J x 7 and T x J x 7: places, and turns as x, y, z, w. */
  readonly rest: Float32Array;
  readonly frames: Float32Array;
}

const SEVEN = 7;

export function ownMoves(names: readonly string[], rest: Pose, { fps, positions, turns }: Sampled): OwnMoves {
  const frames = new Float32Array(SEVEN * names.length * positions.length);
  positions.forEach((places, f) => void put([places, turns[f]], frames, SEVEN * names.length * f));
  return { fps, names, rest: put(rest, new Float32Array(SEVEN * names.length), 0), frames };
}

function put(
  [places, turns]: readonly [Pose[0] | Sampled["positions"][number], Pose[1] | Sampled["turns"][number]],
  out: Float32Array,
  from: number,
): Float32Array {
  places.forEach((place, j) => {
    place.toArray(out, from + SEVEN * j);
    turns[j].toArray(out, from + SEVEN * j + 3);
  });
  return out;
}
