// Which of its limbs each vertex of a model is of, by the joints that move it: arms that touch the trunk stay arms. Pure.

import { boundsOf } from "../document/stage-transform";
import { type NamedJoint, type NamedLimb, readNamedLimbs } from "./named-body";

/** Of a limb's way from its base to its end, what goes with the trunk too. */
const BEGINNING = 0.25;

/**
 * V: 0 for the trunk, l for limb l, counted from 1, -l for where that begins. Null where no joints are named as limbs.
 * positions: V x 3, as the joints; movedBy: V, the joint that moves a vertex most, or -1.
 */
export function limbParts(positions: Float32Array, joints: readonly NamedJoint[], movedBy: Int32Array): Int32Array | null {
  const limbs = joints.length > 0 ? readNamedLimbs(joints, boundsOf(positions)) : [];
  if (limbs.length === 0) return null;
  const limbOf = new Int32Array(joints.length);
  limbs.forEach((limb, l) => {
    for (const j of limb.joints) limbOf[j] = l + 1;
  });
  return Int32Array.from(movedBy, (joint, v) => {
    const limb = joint < 0 ? 0 : limbOf[joint];
    return limb > 0 && along(limbs[limb - 1], positions, 3 * v) < BEGINNING ? -limb : limb;
  });
}

/** How far a limb's vertex is on its way: 0 at its base, 1 at its end. */
function along({ base, end }: NamedLimb, positions: Float32Array, at: number): number {
  const way = base.map((x, k) => end[k] - x);
  return way.reduce((sum, x, k) => sum + x * (positions[at + k] - base[k]), 0) / (Math.hypot(...way) ** 2 || 1);
}
