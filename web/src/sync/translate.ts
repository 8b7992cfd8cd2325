// What a document asks of the engine, part by part: each setting, pin and run of the document is translated here and nowhere
// else. Pure.

import { type Danced, clipOf, saidOf } from "../document/clips";
import { pointToStage, toStage } from "../document/stage-transform";
import { type ClipEdits, DEFAULT_FOLLOW, type MeshRef, type Pin, type ProjectDocument, SAID_ROLES } from "../document/types";
import type {
  BoundMeshInput,
  ConstraintInput,
  ContactInput,
  ControlInput,
  Motion,
  MotionEdits,
  RetargetInput,
  Solve,
} from "../engine/types";
import { DEFAULT_RADIUS, STAGE_HEIGHT } from "../util/constants";
import { exampleJoints, pointJoints } from "./pairing";
import { type SolverModel, stageFor } from "./placement";
import { exampleControls, own, pointPartners, pointVertices } from "./point-controls";

/** What of a model is solved. */
export const solveOf = (mesh: MeshRef): Solve => mesh.solve ?? "surface";

export function meshInput(model: SolverModel, mesh: MeshRef): BoundMeshInput {
  return { positions: toStage(stageFor(model, mesh), model.positions), faces: model.faces, parts: model.parts, solve: solveOf(mesh) };
}

export function controlInputs(model: SolverModel, document: Pick<ProjectDocument, "points">): ControlInput[] {
  return pointVertices(model, document.points).map((vertex, c) => ({
    vertex,
    radius: (document.points[c].radius ?? DEFAULT_RADIUS) * STAGE_HEIGHT,
    slab: document.points[c].slab ?? false,
  }));
}

/** As UpAxis counts them. */
const UPS: readonly (string | undefined)[] = ["+y", "+z", "-y", "-z"];

export function motionEdits(document: Danced): MotionEdits {
  const { file = {}, cut = [0, 1e9], mirror = false, loop = false } = saidOf(document);
  const { metresPerUnit = 0, fps = 0, up, turn = 0, joints = {} } = file;
  return {
    metresPerUnit,
    fps,
    up: UPS.indexOf(up),
    turns: turn / 90,
    mirror,
    first: cut[0],
    last: cut[1],
    loop,
    joints: SAID_ROLES.map((role) => joints[role] ?? ""),
  };
}

export function retargetInput(model: SolverModel, document: ProjectDocument, motion: Pick<Motion, "joints" | "frames">): RetargetInput {
  const { smoothness, volume, energy, groundContact, inPlace, symmetry } = document.settings;
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
    energy,
    follow: document.points.map(({ joint, follow }) => (joint === null ? (follow ?? DEFAULT_FOLLOW) : "stiff")),
    constraints: pinsWithin(clip, motion.frames).map((pin) => constraintOf(model, document, pin)),
    contacts: contactInputs(document, clip, motion.frames),
    flights: clip.flights
      ? within(
          clip.flights.filter(([a]) => a >= 0),
          motion.frames - 1,
        )
      : null,
    mirror: symmetry ? pointPartners(document.points) : null,
  };
}

/** The pins that the solver is asked to keep, in its order. A clip may be shorter than the one that they were made on, or cut. */
export function pinsWithin({ pins = [] }: ClipEdits, frames: number): readonly Pin[] {
  return pins.filter(({ frame, kind }) => frame >= (kind === "still" ? 1 : 0) && frame < frames);
}

function constraintOf(model: SolverModel, document: ProjectDocument, { kind, point, other, frame, position }: Pin): ConstraintInput {
  const [control, fromControl] = [point, other].map((named) => document.points.findIndex(({ id }) => id === named));
  const same: ConstraintInput = { control, frame, fromControl, fromFrame: frame, value: [0, 0, 0], x: true, y: true, z: true };
  if (kind === "level") return { ...same, x: false, z: false };
  if (kind === "still" || !position) return { ...same, fromControl: control, fromFrame: frame - 1 };
  return { ...same, fromControl: -1, value: [...pointToStage(stageFor(model, document.mesh), position)] };
}

function contactInputs({ points }: Pick<ProjectDocument, "points">, { contacts = {} }: ClipEdits, frames: number): ContactInput[] {
  return points.flatMap(({ id }, control) => {
    const runs = own(contacts, id);
    return runs ? [{ control, runs: within(runs, frames) }] : [];
  });
}

/** Runs as far as they lie in a clip whose last frame may be `end`. */
function within(runs: readonly (readonly [number, number])[], end: number): [number, number][] {
  return runs.map(([a, b]): [number, number] => [Math.max(a, 0), Math.min(b, end)]).filter(([a, b]) => a < b);
}
