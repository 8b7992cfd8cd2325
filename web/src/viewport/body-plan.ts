// Which bones a mannequin draws, found from the parts of the body and the tree; knows no pose. Works on any tree: what has no
// part it draws as plain capsules.

import type { BodyPart, JointName, Side } from "../skeleton/body-parts";
import type { DrawnHuman } from "../stage/port";

export interface Bone {
  from: number;
  to: number;
  /** Metres. */
  radius: number;
}

export interface Torso {
  leftHip: number;
  rightHip: number;
  leftShoulder: number;
  rightShoulder: number;
  /** Middle of the spine. */
  middle: number;
}

export interface BodyPlan {
  bones: Bone[];
  /** Joints that can be seen and picked. */
  joints: number[];
  /** -1 where no joint is known to be it. */
  head: number;
  /** Its end, if the file has one, else -1. */
  headTop: number;
  /** Null where hips or shoulders are not known. */
  torso: Torso | null;
}

const RADIUS = 0.05;
const THIN: readonly (BodyPart | null)[] = ["hand", "finger", "toe", "tip", "end"];

export function buildBodyPlan({ joints: known, parents }: DrawnHuman): BodyPlan {
  const hidden = known.map(() => false);
  known.forEach((joint, j) => {
    const parent = parents[j] ?? -1;
    const clutter = joint.part === "finger" ? j !== palm(parent, known, parents) : joint.part === "end" && known[parent]?.part !== "hand";
    hidden[j] = clutter || (parent >= 0 && hidden[parent]!);
  });
  const head = known.findIndex(({ part }) => part === "head");
  const headTop = head < 0 ? -1 : parents.indexOf(head);
  if (headTop >= 0) hidden[headTop] = true;
  const torso = findTorso(known, parents, head);
  const joints = known.map((_, j) => j).filter((j) => !hidden[j]);
  const bones = joints
    .filter((j) => (parents[j] ?? -1) >= 0 && j !== head)
    .map((j) => ({ from: parents[j]!, to: j, radius: THIN.includes(known[j]!.part) ? 0.8 * RADIUS : RADIUS }));
  if (head >= 0 && (parents[head] ?? -1) >= 0) bones.push({ from: parents[head]!, to: head, radius: 0.9 * RADIUS });
  return { bones, joints, head, headTop, torso };
}

/** The leaf that stands highest in a pose (J x 3): the head of a body whose names say nothing. */
export function highestLeaf({ parents }: DrawnHuman, joints: readonly number[], pose: Float32Array): number {
  const drawn = new Set(joints);
  const inner = new Set(joints.map((j) => parents[j]!));
  let best = -1;
  for (const j of drawn) if (!inner.has(j) && (best < 0 || pose[3 * j + 1]! > pose[3 * best + 1]!)) best = j;
  return best;
}

/** The finger that stands for all of a hand: they are too many and too small to draw or to pick; -1 where the hand goes on. */
function palm(hand: number, known: readonly JointName[], parents: Int32Array): number {
  const children = known.map((_, j) => j).filter((j) => parents[j] === hand);
  if (known[hand]?.part !== "hand" || children.some((j) => known[j]!.part === "hand")) return -1;
  const fingers = children.filter((j) => known[j]!.part === "finger");
  return fingers.find((j) => /\bmid/i.test(known[j]!.label)) ?? fingers[Math.floor(fingers.length / 2)] ?? -1;
}

function findTorso(known: readonly JointName[], parents: Int32Array, head: number): Torso | null {
  const find = (side: Side, part: BodyPart): number => known.findIndex((joint) => joint.side === side && joint.part === part);
  const torso = {
    leftHip: find("left", "upper_leg"),
    rightHip: find("right", "upper_leg"),
    leftShoulder: find("left", "upper_arm"),
    rightShoulder: find("right", "upper_arm"),
  };
  if (Object.values(torso).some((j) => j < 0)) return null;
  const spine = commonSpine(parents, torso.leftHip, torso.leftShoulder, head < 0 ? torso.rightShoulder : head);
  return spine.length ? { ...torso, middle: spine[Math.floor((spine.length - 1) / 2)]! } : null;
}

/** Joints from just above the hips to where the arms and the neck part. */
function commonSpine(parents: Int32Array, hip: number, shoulder: number, top: number): number[] {
  const ancestors = (joint: number): number[] => {
    const chain: number[] = [];
    for (let j = joint; j >= 0; j = parents[j] ?? -1) chain.unshift(j);
    return chain;
  };
  const legs = new Set(ancestors(hip));
  const neck = new Set(ancestors(top));
  return ancestors(shoulder).filter((j) => neck.has(j) && !legs.has(j));
}
