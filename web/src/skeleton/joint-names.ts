// What joint names say: the side, the part of the body, and words for people. The twin of include/rigless/motion/joint_names.h;
// both obey tests/golden/joint-names.json.

import type { JointName } from "./body-parts";
import { NameReader } from "./name-reader";

/**
 * J: the names of one skeleton together, because they explain each other: what most of them share at either end says nothing,
 * "leg" is the knee beside an "upleg" but the thigh beside a "shin", and "lfemur" is the knee in an Acclaim file, whose joints
 * are the ENDS of their bones. Several joints may be the same part of a side.
 */
export function readJointNames(names: readonly string[]): JointName[] {
  return new NameReader(names).read();
}
