// Which bones a mannequin draws, found from joint names and parents; knows no pose. Works on any tree: what it cannot name
// it draws as plain capsules.

import { isClutter, isEndSite, readJointName, type Side } from "../skeleton/joint-names";
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
  /** The joint called head; -1 where nothing is. */
  head: number;
  /** Its end, if the file has one, else -1. */
  headTop: number;
  /** Null where hips or shoulders have no names we know. */
  torso: Torso | null;
}

const RADIUS = 0.05;

export function buildBodyPlan({ names, parents }: DrawnHuman): BodyPlan {
  const hidden = names.map(() => false);
  names.forEach((name, j) => {
    const parent = parents[j] ?? -1;
    const end = isEndSite(name) && !/toe|foot|head|ball|hand/i.test(name + (names[parent] ?? ""));
    hidden[j] = isClutter(name) || end || (parent >= 0 && hidden[parent]!);
  });
  const head = findHead(names);
  const headTop = head < 0 ? -1 : parents.indexOf(head);
  if (headTop >= 0) hidden[headTop] = true;
  const torso = findTorso(names, parents, head);
  const joints = names.map((_, j) => j).filter((j) => !hidden[j]);
  const bones = joints
    .filter((j) => (parents[j] ?? -1) >= 0 && j !== head)
    .map((j) => ({ from: parents[j]!, to: j, radius: /toe|fingers|hand/.test(readJointName(names[j]!).base) ? 0.8 * RADIUS : RADIUS }));
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

function findHead(names: string[]): number {
  const exact = names.findIndex((name) => readJointName(name).base === "head");
  return exact >= 0 ? exact : names.findIndex((name) => /head$/.test(readJointName(name).base));
}

function findTorso(names: string[], parents: Int32Array, head: number): Torso | null {
  const find = (side: Side, ...bases: string[]): number => {
    for (const base of bases) {
      const joint = names.findIndex((name) => {
        const read = readJointName(name);
        return read.side === side && read.base === base;
      });
      if (joint >= 0) return joint;
    }
    return -1;
  };
  const hips = ["upleg", "upperleg", "thigh", "hip", "hipjoint"];
  const shoulders = ["uparm", "upperarm", "arm", "clavicle", "shoulder"]; // Mixamo's "shoulder" is the collar, but then it has an "arm"
  const torso = {
    leftHip: find("left", ...hips),
    rightHip: find("right", ...hips),
    leftShoulder: find("left", ...shoulders),
    rightShoulder: find("right", ...shoulders),
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
