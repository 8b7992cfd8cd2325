// Points of a document as controls on the model, and controls as what a document holds. Pure.

import { fromStage, pointToStage, type StageTransform } from "../document/stage-transform";
import type { Example, Point, ProjectDocument, Vec3 } from "../document/types";
import { type SolverModel, stageFor } from "./placement";

/** Of models: the nearest vertex to a place, where it was asked for; a large one is looked through once. */
const NEAREST = new WeakMap<SolverModel, Map<string, number>>();

/** The vertex of each point: the nearest that no earlier point has, because two controls on one vertex would contradict each other. */
export function pointVertices(model: SolverModel, points: readonly Pick<Point, "position">[]): number[] {
  const known = NEAREST.get(model) ?? new Map<string, number>();
  NEAREST.set(model, known);
  const taken = new Set<number>();
  return points.map(({ position }) => {
    const key = position.join();
    let vertex = known.get(key) ?? nearestVertex(model.positions, position, new Set());
    known.set(key, vertex);
    if (taken.has(vertex)) vertex = nearestVertex(model.positions, position, taken);
    taken.add(vertex);
    return vertex;
  });
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
  return pointsOfStage(stageFor(model, document.mesh), document.points, controls);
}

/** By how much C x 3 turns of the stage turn points in the file: what an example holds. */
export function turnsOfControls(
  model: SolverModel,
  document: Pick<ProjectDocument, "mesh" | "points">,
  turns: Float32Array,
): Record<string, Vec3> {
  return pointsOfStage({ ...stageFor(model, document.mesh), scale: 1, offset: [0, 0, 0] }, document.points, turns);
}

function pointsOfStage(stage: StageTransform, points: readonly Point[], at: ArrayLike<number>): Record<string, Vec3> {
  const places = fromStage(stage, at);
  return Object.fromEntries(points.map(({ id }, c) => [id, [places[3 * c], places[3 * c + 1], places[3 * c + 2]] as const]));
}

/** C: each point's partner, itself in the middle, -1 without one; null if no point has any. */
export function pointPartners(points: readonly Point[]): Int32Array | null {
  const partners = points.map(({ id, mirror }) => points.findIndex((other) => other.id === mirror && other.mirror === id));
  return partners.some((partner) => partner >= 0) ? Int32Array.from(partners) : null;
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

/** What a record from a file says of a name, not what every object inherits. */
export function own<T>(record: Readonly<Record<string, T>>, key: string): T | undefined {
  return Object.hasOwn(record, key) ? record[key] : undefined;
}
