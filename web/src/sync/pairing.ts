// A document's joints in a motion, which may have another skeleton; and a motion's joints as a document says them. Pure.

import type { Example, Point, ProjectDocument, Vec3 } from "../document/types";
import type { Joint, Motion } from "../engine/types";
import { jointFinder, roleOf, rolesOfNames } from "../skeleton/pair-joints";
import type { JointRoles } from "../skeleton/pair-joints";

/** What of a document names joints. */
type Said = Pick<ProjectDocument, "points" | "examples" | "joints">;

/** C: the joint of each point in the motion, or -1. */
export function pointJoints(document: Said, motion: Pick<Motion, "joints">): Int32Array {
  const find = jointFinder(motion.joints);
  return Int32Array.from(document.points, ({ joint }) => {
    if (joint === null) return -1;
    const names = namesAround(document, joint);
    return find(names, document.joints, true)[names.indexOf(joint)];
  });
}

/** N x J x 3: the joints of each example in the motion's order, NaN where it does not know one; null if it knows none. */
export function exampleJoints({ examples, joints: roles }: Said, motion: Pick<Motion, "joints">): (Float32Array | null)[] {
  const find = jointFinder(motion.joints);
  return examples.map(({ joints }) => {
    const names = Object.keys(joints);
    const out = new Float32Array(3 * motion.joints.length).fill(NaN);
    const found = find(names, roles);
    names.forEach((name, n) => {
      const j = found[n];
      if (j >= 0 && (Number.isNaN(out[3 * j]) || motion.joints[j].name === name)) out.set(joints[name], 3 * j);
    });
    return found.some((j) => j >= 0) ? out : null;
  });
}

/** A motion's joint by the name that a document stores, with what to record of it so that other skeletons have it too. */
export function sayJoint(document: Said, joint: Joint): { name: string; roles: JointRoles } {
  const name = nameFor(document, joint) ?? joint.name;
  const names = namesAround(document, name);
  const all = names.includes(name) ? names : [...names, name];
  return { name, roles: untold(all, (other) => (other === name ? roleOf(joint) : null)) };
}

/** J x 3 body-local joints of a motion as an example holds them, likewise. */
export function sayPose(document: Said, { joints }: Pick<Motion, "joints">, pose: ArrayLike<number>): SaidPose {
  const said = joints.flatMap((joint, j) => {
    const name = nameFor(document, joint);
    return name === null ? [] : [{ name, role: roleOf(joint), place: [pose[3 * j], pose[3 * j + 1], pose[3 * j + 2]] as const }];
  });
  const role = new Map(said.map((joint) => [joint.name, joint.role]));
  return {
    joints: Object.fromEntries(said.map(({ name, place }) => [name, place])),
    roles: untold([...role.keys()], (name) => role.get(name) ?? null),
  };
}

export interface SaidPose {
  joints: Record<string, Vec3>;
  roles: JointRoles;
}

/** The roles of points' joints that their names do not tell. */
export function rolesToRecord(points: readonly Point[], joints: readonly Joint[]): JointRoles {
  const role = new Map(joints.map((joint) => [joint.name, roleOf(joint)]));
  return untold([...new Set(points.flatMap(({ joint }) => joint ?? []))], (name) => role.get(name) ?? null);
}

/** What the motion's skeleton cannot do for this document, in plain words. */
export function pairingNotes(document: ProjectDocument, motion: Pick<Motion, "joints" | "told">): string[] {
  const name = motionName(document);
  const lost = document.examples.length > 0 ? exampleJoints(document, motion) : [];
  return [
    ...(motion.told || pairingFault(document, motion) === null ? [] : [untoldText(name)]),
    ...lostPoints(document, motion, name),
    ...lost.flatMap((joints, n) =>
      joints ? [] : [`Pose ${n + 1} was made on another skeleton, and ${name} has none of its joints: it is left out.`],
    ),
  ];
}

function lostPoints(document: ProjectDocument, motion: Pick<Motion, "joints">, name: string): string[] {
  const found = pointJoints(document, motion);
  const wanted = document.points.filter(({ joint }) => joint !== null).length;
  const lost = document.points.flatMap(({ name: point, joint }, c) => (joint === null || found[c] >= 0 ? [] : [{ point, joint }]));
  if (lost.length < 2 || lost.length < wanted)
    return lost.map(({ point, joint }) => `${name} has no joint "${joint}": "${point}" follows the whole pose.`);
  return [`${name} has none of the joints ${list(lost.map(({ joint }) => joint))}: all points follow the whole pose.`];
}

/**
 * Why this motion is none for this document, or null: it has none of the joints that the points name; or which joints are what
 * cannot be told, and it does not have them all.
 */
export function pairingFault(document: ProjectDocument, motion: Pick<Motion, "joints" | "told">): string | null {
  const name = motionName(document);
  const wanted = document.points.flatMap(({ joint }) => joint ?? []);
  const found = pointJoints(document, motion).filter((joint) => joint >= 0).length;
  if (motion.told ? found > 0 || wanted.length === 0 : found > 0 && found === wanted.length) return null;
  return motion.told ? `${name} has none of the joints ${list(wanted)}, which the points follow.` : untoldText(name);
}

/** "Head", "Hips" and 5 more */
function list(joints: readonly string[]): string {
  const names = [...new Set(joints)].map((joint) => `"${joint}"`);
  return names.length > 4 ? `${names.slice(0, 3).join(", ")} and ${names.length - 3} more` : names.join(", ");
}

function untoldText(motion: string): string {
  return `We cannot tell which joints of ${motion} are its head, hands and feet, neither by their names nor by how they hang together.`;
}

function motionName({ motion }: ProjectDocument): string {
  return motion.files.at(-1) ?? "This motion";
}

/** The names that a joint stands among, since what one means may depend on the others: an example's, else those of all points. */
function namesAround({ points, examples }: Said, joint: string): string[] {
  const example = examples.find(({ joints }: Example) => Object.hasOwn(joints, joint));
  return example ? Object.keys(example.joints) : [...new Set(points.flatMap((point) => point.joint ?? []))];
}

/** A joint's own name, unless the document means another part of the body by it: then one that means the same, if any can. */
function nameFor({ joints: roles = {} }: Said, joint: Joint): string | null {
  const role = roleOf(joint);
  if (!Object.hasOwn(roles, joint.name) || roles[joint.name] === role) return joint.name;
  return Object.keys(roles).find((name) => roles[name] === role) ?? role;
}

/** Of names that stand together, the roles that these do not tell. */
function untold(names: readonly string[], roleNow: (name: string) => string | null): JointRoles {
  const told = rolesOfNames(names);
  return Object.fromEntries(
    names.flatMap((name, n): [string, string][] => {
      const role = roleNow(name);
      return role === null || role === told[n] ? [] : [[name, role]];
    }),
  );
}
