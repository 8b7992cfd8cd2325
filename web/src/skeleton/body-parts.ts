// Parts and sides of a body, and what a joint's name says of them.

import type { BodyPart as CorePart, BodySide as CoreSide } from "../util/constants";

export type Side = Exclude<CoreSide, "none"> | null;

/**
 * A joint is named after where it is: upper_leg is the hip joint, lower_leg the knee, foot the ankle, toe the ball; shoulder is
 * the collar, upper_arm the shoulder joint, lower_arm the elbow, hand the wrist. tip is the end of the foot, end any other end.
 */
export type BodyPart = Exclude<CorePart, "none">;

export interface JointName {
  side: Side;
  part: BodyPart | null;
  /** "Left elbow"; the joint's own words where the part is none, finger or end; unique in the list. */
  label: string;
}
