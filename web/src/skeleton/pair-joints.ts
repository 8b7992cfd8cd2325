// The same joint on another skeleton: by its exact name where that means the same, else by its role, else by what it is called.
// Pure.

import { partLabel } from "./joint-labels";
import { readJointNames } from "./joint-names";
import type { BodyPart, JointName, Side } from "./body-parts";
import { NameReader } from "./name-reader";

/** A joint of a skeleton and its role there, which no other joint has; without one, both are null. */
export interface RoledJoint {
  readonly name: string;
  readonly side: Side;
  readonly part: BodyPart | null;
}

/** Roles of joints by name: "left foot". */
export type JointRoles = Readonly<Record<string, string>>;

/** Parts of which a body has many, so that none of them is a role. */
const MANY: readonly (BodyPart | null)[] = ["finger", "end", null];

/** Parts that are drawn as one. */
const UNIQUE: readonly (BodyPart | null)[] = ["head", "upper_arm", "upper_leg"];

/** "left lower arm", "hips"; null where there is none. */
export function roleOf({ side, part }: Pick<JointName, "side" | "part">): string | null {
  if (part === null || MANY.includes(part)) return null;
  return [...(side ? [side] : []), part.replace("_", " ")].join(" ");
}

/**
 * The roles that the names of one skeleton tell. Of several joints of one part the first has its role, but of a hand whose bones
 * are named after their ends the last; where none is called the chest, it is the last of a spine.
 */
export function rolesOfNames(names: readonly string[]): (string | null)[] {
  const reader = new NameReader(names);
  const all = reader.read().map(roleOf);
  const owner = (role: string | null): number => (reader.boneEnds && role?.endsWith("hand") ? all.lastIndexOf(role) : all.indexOf(role));
  const roles = all.map((role, n) => (owner(role) === n ? role : null));
  const top = all.lastIndexOf("spine");
  return all.includes("chest") || top === all.indexOf("spine") ? roles : roles.with(top, "chest");
}

/**
 * Finds joints of a skeleton by the names that are said together, which may be another skeleton's: the index of each, -1 where
 * there is none. `roles`: what is recorded of them beside what their names tell. `near`: of several joints of one part, those
 * that do not have its role find it too.
 */
export type JointFinder = (names: readonly string[], roles?: JointRoles, near?: boolean) => Int32Array;

export const jointFinder = once((joints: readonly RoledJoint[]): JointFinder => {
  const byName = new Map(joints.map(({ name }, j) => [name, j] as const).reverse());
  const byRole = new Map(joints.flatMap((joint, j) => entry(roleOf(joint), j)).reverse());
  const labels = readJointNames(joints.map(({ name }) => name)).map(({ label }) => label);
  const byLabel = new Map(joints.flatMap((joint, j) => entry(roleOf(joint) === null ? labels[j] : null, j)).reverse());
  const find = (names: readonly string[], roles: JointRoles, near: boolean): Int32Array => {
    const isOwn = names.every((name) => byName.has(name));
    const read = readJointNames(names);
    const told = rolesOfNames(names);
    return Int32Array.from(names, (name, n) => {
      const exact = byName.get(name) ?? -1;
      const recorded = Object.hasOwn(roles, name) ? roles[name] : null;
      const role = recorded ?? told[n];
      const there = exact < 0 ? null : roleOf(joints[exact]);
      if (exact >= 0 && (role === there || (recorded === null && (isOwn || role === null || there === null)))) return exact;
      const close = near ? roleOf(read[n]) : null;
      return byRole.get(role ?? "") ?? byLabel.get(read[n].label) ?? byRole.get(close ?? "") ?? -1;
    });
  };
  const known = new Map<string, Int32Array>(); // poses repeat the names of one skeleton
  return (names, roles = {}, near = false) => {
    const key = JSON.stringify([names, roles, near]);
    const found = known.get(key) ?? find(names, roles, near);
    known.set(key, found);
    return found;
  };
});

/** What people read of a skeleton's joints: the roles that they have, in words, and what else their names tell. */
export const describeJoints = once((joints: readonly RoledJoint[]): readonly JointName[] => {
  const read = plainForRoles(joints, readJointNames(joints.map(({ name }) => name)));
  const taken = new Set(read.map(({ label }) => label));
  return joints.map((joint, j) => {
    const { side, part } = joint.part === null && !UNIQUE.includes(read[j].part) ? read[j] : joint;
    const label = read[j].part === null && part !== null ? (partLabel(side, part) ?? read[j].label) : read[j].label;
    return { side, part, label: label === read[j].label || !taken.has(label) ? label : read[j].label };
  });
});

/** Remembers what was made of each list, which stays while a motion plays. */
function once<K extends object, V>(make: (key: K) => V): (key: K) => V {
  const made = new WeakMap<K, V>();
  return (key) => {
    const value = made.get(key) ?? make(key);
    made.set(key, value);
    return value;
  };
}

/** Of several joints of one part, the one that has its role is called so without a number. */
function plainForRoles(joints: readonly RoledJoint[], read: JointName[]): JointName[] {
  joints.forEach(({ side, part }, j) => {
    const plain = partLabel(side, part);
    const other = read.findIndex(({ label }) => label === plain);
    if (other < 0 || other === j || read[j].part !== part) return;
    [read[j].label, read[other].label] = [read[other].label, read[j].label];
  });
  return read;
}

/** The joint of the same part on the other side, itself in the middle; -1 without a role. */
export function jointPartners(joints: readonly RoledJoint[]): Int32Array {
  const roles = joints.map(roleOf);
  const swapped = { left: "right", right: "left" } as const;
  return Int32Array.from(joints, ({ side, part }) => (part ? roles.indexOf(roleOf({ side: side && swapped[side], part })) : -1));
}

const entry = <K>(key: K | null, value: number): (readonly [K, number])[] => (key === null ? [] : [[key, value]]);
