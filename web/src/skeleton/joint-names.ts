// What joint names say: the side, the part of the body, and words for people. The twin of include/rigless/motion/joint_names.h;
// both obey tests/golden/joint-names.json.

import { NameReader } from "./name-reader";

export type Side = "left" | "right" | null;

/**
 * A joint is named after where it is: upper_leg is the hip joint, lower_leg the knee, foot the ankle, toe the ball; shoulder is
 * the collar, upper_arm the shoulder joint, lower_arm the elbow, hand the wrist. tip is the end of the foot, end any other end.
 */
export type BodyPart =
  | "hips"
  | "spine"
  | "chest"
  | "neck"
  | "head"
  | "shoulder"
  | "upper_arm"
  | "lower_arm"
  | "hand"
  | "finger"
  | "upper_leg"
  | "lower_leg"
  | "foot"
  | "toe"
  | "tip"
  | "end";

export interface JointName {
  side: Side;
  part: BodyPart | null;
  /** "Left elbow"; the joint's own words where the part is none, finger or end; unique in the list. */
  label: string;
}

/**
 * J: the names of one skeleton together, because they explain each other: what most of them share at either end says nothing,
 * "leg" is the knee beside an "upleg" but the thigh beside a "shin", and "lfemur" is the knee in an Acclaim file, whose joints
 * are the ENDS of their bones. Several joints may be the same part of a side.
 */
export function readJointNames(names: readonly string[]): JointName[] {
  return new NameReader(names).read();
}
