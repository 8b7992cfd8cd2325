// From what the user said to what the engine is asked, and back: units, axes, nearest vertices, joints by name. Pure.

import { boundsOf, fromStage, pointToStage, STAGE_HEIGHT, stageOf, toStage } from "../document/stage";
import type { Stage } from "../document/stage";
import type { Example, MeshRef, Point, ProjectDocument, Vec3 } from "../document/types";
import { isSameJoint, jointFinder } from "../engine/match-joints";
import type { ControlInput, Joint, MeshInput, Motion, RetargetInput } from "../engine/types";

/** What of a model the solver knows; file units and axes. */
export interface SolverModel {
  /** V x 3. */
  readonly positions: Float32Array;
  /** F x 3. */
  readonly faces: Uint32Array;
}

/** A point's disc, in model heights, unless it says otherwise. */
export const DEFAULT_RADIUS = 0.05;

/** The transform between the model's file and the stage. */
export function stageFor(model: SolverModel, mesh: MeshRef): Stage {
  return stageOf(boundsOf(model.positions), mesh.facing, mesh.up);
}

export function meshInput(model: SolverModel, mesh: MeshRef): MeshInput {
  return { positions: toStage(stageFor(model, mesh), model.positions), faces: model.faces };
}

/** The vertex of each point: the nearest that no earlier point has, because two controls on one vertex would contradict each other. */
export function pointVertices(model: SolverModel, points: readonly Point[]): number[] {
  const taken = new Set<number>();
  return points.map(({ position }) => {
    const vertex = nearestVertex(model.positions, position, taken);
    taken.add(vertex);
    return vertex;
  });
}

export function controlInputs(model: SolverModel, document: Pick<ProjectDocument, "points">): ControlInput[] {
  return pointVertices(model, document.points).map((vertex, c) => ({
    vertex,
    radius: (document.points[c].radius ?? DEFAULT_RADIUS) * STAGE_HEIGHT,
  }));
}

/** C x 3, stage: where the points are while the model rests. */
export function restControls(model: SolverModel, document: Pick<ProjectDocument, "mesh" | "points">): Float32Array {
  const stage = stageFor(model, document.mesh);
  const out = new Float32Array(3 * document.points.length);
  pointVertices(model, document.points).forEach((v, c) => {
    const [x, y, z] = model.positions.subarray(3 * v, 3 * v + 3);
    out.set(pointToStage(stage, [x, y, z]), 3 * c);
  });
  return out;
}

/** C x 3, stage: an example's points; one that it does not name rests. */
export function exampleControls(
  model: SolverModel, document: Pick<ProjectDocument, "mesh" | "points">, example: Pick<Example, "points">,
): Float32Array {
  const stage = stageFor(model, document.mesh);
  const out = restControls(model, document);
  document.points.forEach(({ id }, c) => {
    const place = own(example.points, id);
    if (place) out.set(pointToStage(stage, place), 3 * c);
  });
  return out;
}

/** Where C x 3 stage controls stand in the file, by point: what an example holds. */
export function pointsOfControls(
  model: SolverModel, document: Pick<ProjectDocument, "mesh" | "points">, controls: ArrayLike<number>,
): Record<string, Vec3> {
  const places = fromStage(stageFor(model, document.mesh), controls);
  return Object.fromEntries(document.points.map(({ id }, c) => [id, [places[3 * c], places[3 * c + 1], places[3 * c + 2]] as const]));
}

/** J x 3 body-local joints by name: what an example holds. */
export function jointsOfPose(joints: readonly Joint[], pose: ArrayLike<number>): Record<string, Vec3> {
  return Object.fromEntries(joints.map(({ name }, j) => [name, [pose[3 * j], pose[3 * j + 1], pose[3 * j + 2]] as const]));
}

export function retargetInput(model: SolverModel, document: ProjectDocument, motion: Pick<Motion, "joints">): RetargetInput {
  const find = jointFinder(motion.joints.map((joint) => joint.name));
  const { smoothness, volume, groundContact, inPlace } = document.settings;
  return {
    pairs: Int32Array.from(document.points, ({ joint }) => (joint === null ? -1 : find(joint, jointsSaid(document)))),
    examples: document.examples.filter((example) => knows(example, motion)).map((example) => ({
      joints: exampleJoints(example, motion),
      controls: exampleControls(model, document, example),
    })),
    smoothness, volume, groundContact, inPlace,
  };
}

/** What the motion's skeleton cannot do for this document, in plain words. */
export function pairingNotes(document: ProjectDocument, motion: Pick<Motion, "joints">): string[] {
  const find = jointFinder(motion.joints.map((joint) => joint.name));
  const name = document.motion.files.at(-1) ?? "This motion";
  return [
    ...document.points.flatMap(({ name: point, joint }) =>
      joint === null ? [] : pairingNote(name, point, joint, motion.joints[find(joint, jointsSaid(document))]?.name)),
    ...document.examples.flatMap((example, n) =>
      knows(example, motion) ? [] : [`Pose ${n + 1} was made on another skeleton, and ${name} has none of its joints: it is left out.`]),
  ];
}

function pairingNote(motion: string, point: string, joint: string, found: string | undefined): string[] {
  if (found === undefined) return [`${motion} has no joint "${joint}": "${point}" follows the whole pose.`];
  return isSameJoint(joint, found) ? [] : [`${motion} has no joint "${joint}": "${point}" follows "${found}".`];
}

/** Every joint's name that the document says: what one of them means may depend on the others. */
function jointsSaid({ points, examples }: ProjectDocument): string[] {
  return [...points.flatMap(({ joint }) => joint ?? []), ...Object.keys(examples[0]?.joints ?? {})];
}

/** J x 3: the example's joints in the motion's order; NaN where it has none of that name. */
function exampleJoints(example: Example, motion: Pick<Motion, "joints">): Float32Array {
  const names = Object.keys(example.joints);
  const find = jointFinder(names);
  const out = new Float32Array(3 * motion.joints.length).fill(NaN);
  motion.joints.forEach((joint, j) => {
    const n = find(joint.name, motion.joints.map(({ name }) => name));
    if (n >= 0) out.set(example.joints[names[n]], 3 * j);
  });
  return out;
}

function knows(example: Example, motion: Pick<Motion, "joints">): boolean {
  const find = jointFinder(Object.keys(example.joints));
  return motion.joints.some((joint) => find(joint.name) >= 0);
}

function nearestVertex(positions: Float32Array, [x, y, z]: Vec3, taken: ReadonlySet<number>): number {
  let best = -1;
  let least = Infinity;
  for (let v = 0; v < positions.length / 3; v++) {
    const dx = positions[3 * v] - x;
    const dy = positions[3 * v + 1] - y;
    const dz = positions[3 * v + 2] - z;
    const distance = dx * dx + dy * dy + dz * dz;
    if (distance < least && !taken.has(v)) [best, least] = [v, distance];
  }
  return best;
}

function own<T>(record: Readonly<Record<string, T>>, key: string): T | undefined {
  return Object.hasOwn(record, key) ? record[key] : undefined;
}
