import type { Example, Vec3 } from "../document/types";
import { jointFinder } from "../skeleton/match-joints";
import type { Motion } from "../engine/types";

/** Root mean square metres between joints: farther is another pose. */
const NEAR = 0.16;

/**
 * The frame at which the human comes nearest to the mirror image of an example's pose; null if it never comes near, or if no
 * joint has a partner by name.
 */
export function mirroredFrame({ joints }: Example, motion: Motion): number | null {
  const names = Object.keys(joints);
  const find = jointFinder(names);
  const wanted = motion.joints.map(({ name }): Vec3 | null => {
    const other = find(otherSide(name));
    const place = other < 0 ? undefined : joints[names[other]];
    return place ? [-place[0], place[1], place[2]] : null;
  });
  if (!motion.joints.some(({ name }, j) => wanted[j] && otherSide(name) !== name)) return null;
  const count = motion.joints.length;
  let best: number | null = null;
  let least = NEAR * NEAR;
  for (let frame = 0; frame < motion.frames; frame++) {
    let sum = 0;
    let known = 0;
    wanted.forEach((place, j) => {
      if (!place) return;
      known++;
      const at = 3 * (frame * count + j);
      for (let k = 0; k < 3; k++) sum += (motion.local[at + k] - place[k]) ** 2;
    });
    if (sum / known < least) [best, least] = [frame, sum / known];
  }
  return best;
}

/** "LeftHand" for "RightHand", "lfoot" for "rfoot". */
function otherSide(name: string): string {
  const swap = (side: string): string =>
    ({ left: "right", right: "left", Left: "Right", Right: "Left", LEFT: "RIGHT", RIGHT: "LEFT", l: "r", r: "l", L: "R", R: "L" })[side] ??
    side;
  const word = /left|right/i.exec(name);
  if (word) return name.replace(word[0], swap(word[0]));
  return name.replace(
    /(^|[:|._ -])([lrLR])(?=[A-Z._ -]|(?:foot|hand|wrist|thumb|fingers|femur|tibia|toes|hipjoint|clavicle|humerus|radius)\b)/,
    (_, before: string, side: string) => before + swap(side),
  );
}
