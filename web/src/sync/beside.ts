// How two dances go together: at which of its frames a companion is while the one in hand dances, and where it stands then.

import type { Offset } from "../document/types";
import type { Performance } from "../engine/types";
import type { Standing } from "../util/standing";

/** A frame of a dance that goes round, and which round it is. */
export interface Beat {
  readonly frame: number;
  readonly round: number;
}

/** So many frames after the dance began. Before that a circle comes from its end; all else waits at its first frame. */
export function beatAt(at: number, frames: number, closed: boolean): Beat {
  const length = Math.max(1, frames - Number(closed));
  const whole = Math.floor(at + 1e-6);
  if (whole < 0 && !closed) return { frame: 0, round: 0 };
  const round = Math.floor(whole / length);
  return { frame: whole - round * length, round };
}

type Travelled = Pick<Performance, "travel">;

/**
 * Where a companion's world is in that of the one in hand: it begins at its place, and in a further round goes on from where it
 * came to. `rounds`: how many of its own lie behind it, less those that lie behind the one in hand, which begins anew each time.
 */
export function standingOf({ place, yaw }: Offset, hand: Travelled, own: Travelled, rounds: number): Standing {
  const [x, z] = [0, 2].map((k) => rounds * ((own.travel.at(k - 3) ?? 0) - own.travel[k]) - own.travel[k]);
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  return { x: c * x + s * z + place[0] + hand.travel[0], z: -s * x + c * z + place[1] + hand.travel[2], yaw };
}
