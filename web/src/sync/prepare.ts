// From what the user said to what the engine is asked, and back: units, axes, nearest vertices. Pure.

import { clipOf } from "../document/clips";
import { boundsOf, fromStage, pointToStage, stageOf, toStage } from "../document/stage";
import type { Stage } from "../document/stage";
import type { Clip, Example, MeshRef, Pin, Point, ProjectDocument, Vec3 } from "../document/types";
import type { ConstraintInput, ContactInput, ControlInput, MeshInput, Motion, RetargetInput } from "../engine/types";
import { DEFAULT_RADIUS, STAGE_HEIGHT } from "../util/constants";
import { exampleJoints, pointJoints } from "./pairing";

/** What of a model the solver knows; file units and axes. */
export interface SolverModel {
  /** V x 3. */
  readonly positions: Float32Array;
  /** F x 3. */
  readonly faces: Uint32Array;
}

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
  model: SolverModel,
  document: Pick<ProjectDocument, "mesh" | "points">,
  example: Pick<Example, "points">,
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
  model: SolverModel,
  document: Pick<ProjectDocument, "mesh" | "points">,
  controls: ArrayLike<number>,
): Record<string, Vec3> {
  const places = fromStage(stageFor(model, document.mesh), controls);
  return Object.fromEntries(document.points.map(({ id }, c) => [id, [places[3 * c], places[3 * c + 1], places[3 * c + 2]] as const]));
}

export function retargetInput(model: SolverModel, document: ProjectDocument, motion: Pick<Motion, "joints" | "frames">): RetargetInput {
  const { smoothness, volume, groundContact, inPlace, symmetry } = document.settings;
  const clip = clipOf(document);
  const known = exampleJoints(document, motion);
  return {
    pairs: pointJoints(document, motion),
    examples: document.examples.flatMap((example, n) => {
      const joints = known[n];
      return joints ? [{ joints, controls: exampleControls(model, document, example) }] : [];
    }),
    smoothness,
    volume,
    groundContact,
    inPlace,
    constraints: pinsWithin(clip, motion.frames).map((pin) => constraintOf(model, document, pin)),
    contacts: contactInputs(document, clip, motion.frames),
    flights: clip.flights ? within(clip.flights, motion.frames - 1) : null,
    mirror: symmetry ? pointPartners(document.points) : null,
  };
}

/** C: each point's partner, itself in the middle, -1 without one; null if no point has any. */
export function pointPartners(points: readonly Point[]): Int32Array | null {
  const partners = points.map(({ id, mirror }) => points.findIndex((other) => other.id === mirror && other.mirror === id));
  return partners.some((partner) => partner >= 0) ? Int32Array.from(partners) : null;
}

/** The pins that the solver is asked to keep, in its order. A clip may be shorter than the one that they were made on. */
export function pinsWithin({ pins = [] }: Clip, frames: number): readonly Pin[] {
  return pins.filter(({ frame }) => frame < frames);
}

function constraintOf(model: SolverModel, document: ProjectDocument, { kind, point, frame, position }: Pin): ConstraintInput {
  const control = document.points.findIndex(({ id }) => id === point);
  if (kind === "still" || !position) return { kind: "still", control, frame };
  return { kind: "position", control, frame, value: [...pointToStage(stageFor(model, document.mesh), position)] };
}

function contactInputs({ points }: Pick<ProjectDocument, "points">, { contacts = {} }: Clip, frames: number): ContactInput[] {
  return points.flatMap(({ id }, control) => {
    const runs = own(contacts, id);
    return runs ? [{ control, runs: within(runs, frames) }] : [];
  });
}

/** Runs as far as they lie in a clip whose last frame may be `end`. */
function within(runs: readonly (readonly [number, number])[], end: number): [number, number][] {
  return runs.map(([a, b]): [number, number] => [a, Math.min(b, end)]).filter(([a, b]) => a < b);
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
