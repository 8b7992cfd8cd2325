import type { Example, ProjectDocument } from "../document/types";
import type { BodyPart, Motion } from "../engine/types";
import { jointPartners } from "../skeleton/pair-joints";
import { exampleJoints } from "../sync/pairing";

/** By these a pose is known, whatever else a motion names. */
const ENDS: readonly (BodyPart | null)[] = ["head", "hand", "foot"];
/** Root mean square metres between them: farther is another pose. */
const NEAR = 0.2;

/**
 * The frame at which the human comes nearest to the mirror image of an example's pose; null if it never comes near, or if no
 * joint of a side has a partner on the other.
 */
export function mirroredFrame(example: Example, { joints: roles }: Pick<ProjectDocument, "joints">, motion: Motion): number | null {
  const [pose] = exampleJoints({ points: [], examples: [example], ...(roles && { joints: roles }) }, motion);
  const partners = jointPartners(motion.joints);
  const ends = [...partners.keys()].filter((j) => ENDS.includes(motion.joints[j].part));
  const known = ends.filter((j) => partners[j] >= 0 && !Number.isNaN(pose?.[3 * partners[j]] ?? NaN));
  if (!pose || known.every((j) => partners[j] === j)) return null;
  const wanted = known.map((j) => [-1, 1, 1].map((sign, k) => sign * pose[3 * partners[j] + k]));
  const count = motion.joints.length;
  let best: number | null = null;
  let least = NEAR * NEAR;
  for (let frame = 0; frame < motion.frames; frame++) {
    let sum = 0;
    known.forEach((j, n) => {
      const at = 3 * (frame * count + j);
      for (let k = 0; k < 3; k++) sum += (motion.local[at + k] - wanted[n][k]) ** 2;
    });
    if (sum / known.length < least) [best, least] = [frame, sum / known.length];
  }
  return best;
}
