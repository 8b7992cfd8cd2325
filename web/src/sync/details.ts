// What few documents say, for the engine: of single frames of a clip, of single points, of turns in poses, and that it shall be as
// in the paper. Not part of the first load. Pure.

import { clipOf } from "../document/clips";
import { pointToStage } from "../document/stage-transform";
import { type ClipEdits, DEFAULT_WHOLE_POSE, type Pin, type ProjectDocument } from "../document/types";
import type { ConstraintInput, ContactInput, Motion, RetargetInput } from "../engine/types";
import { FPS } from "../util/constants";
import { type SolverModel, stageFor } from "./placement";
import { own } from "./point-controls";
import { turnInputs } from "./turns";

/** What is asked of the engine, with these. */
export function detailed(
  input: RetargetInput,
  model: SolverModel,
  document: ProjectDocument,
  motion: Pick<Motion, "joints" | "frames">,
): RetargetInput {
  const clip = clipOf(document);
  const { frames } = motion;
  const flights = clip.flights?.filter(([a]) => a >= 0);
  const asked = document.settings.paper ? asInPaper(input) : input;
  return {
    ...asked,
    poseWeights: asked.paper ? null : Float32Array.from(document.points, ({ wholePose = DEFAULT_WHOLE_POSE }) => wholePose),
    constraints: pinsWithin(clip, frames).map((pin) => constraintOf(model, document, pin)),
    contacts: contactInputs(document, clip, frames),
    flights: flights ? within(flights, frames - 1) : null,
    turns: turnInputs(model, document, motion, asked),
  };
}

/** Without what the paper does not have. */
function asInPaper(input: RetargetInput): RetargetInput {
  return { ...input, paper: true, energy: 0, groundContact: false, follow: [], mirror: null };
}

/** The pins that the solver is asked to keep, in its order. A clip may be shorter than the one that they were made on, or cut. */
export function pinsWithin({ pins = [] }: ClipEdits, frames: number): readonly Pin[] {
  return pins.filter(({ frame, kind }) => frame >= (kind === "still" || kind === "moves" ? 1 : 0) && frame < frames);
}

function constraintOf(
  model: SolverModel,
  document: ProjectDocument,
  { kind, point, other, frame, position, velocity }: Pin,
): ConstraintInput {
  const [control, fromControl] = [point, other].map((named) => document.points.findIndex(({ id }) => id === named));
  const same: ConstraintInput = { control, frame, fromControl, fromFrame: frame, value: [0, 0, 0], x: true, y: true, z: true };
  if (kind === "moves" && velocity) {
    const [x, y, z] = pointToStage({ ...stageFor(model, document.mesh), offset: [0, 0, 0] }, velocity);
    return { ...same, fromControl: control, fromFrame: frame - 1, value: [x / FPS, y / FPS, z / FPS] };
  }
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
