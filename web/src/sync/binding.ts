// The one path from a document to frames: which part of the document each call to the engine depends on. What the engine holds
// already is not told again.

import { type Danced, clipOf } from "../document/clips";
import type { MeshRef, ProjectDocument } from "../document/types";
import { EngineError } from "../engine/types";
import type { CallOptions, Engine, Frame, MeshReport, Motion, MotionInput, Performance, ShapedFrame } from "../engine/types";
import type { SolverModel } from "./placement";
import { controlInputs, meshInput, motionEdits, retargetInput, solveOf } from "./translate";

/** The options of a call, by what it does in plain words. */
export type CallFor = (step: string) => CallOptions;

const QUIETLY: CallFor = () => ({});

/** What a document names. */
export interface Parts {
  readonly model: SolverModel | undefined;
  readonly motion: MotionInput | undefined;
}

/** What an engine says of a mesh that it took. */
export interface TakenMesh {
  readonly model: SolverModel;
  readonly mesh: ProjectDocument["mesh"];
  /** What else of the document it was bound with. */
  readonly said: readonly unknown[];
  readonly report: MeshReport;
}

export interface TakenMotion {
  readonly input: MotionInput;
  /** What was said of it, as text. */
  readonly said: string;
  readonly motion: Motion;
}

/** An engine and what it holds of a document. On failure (EngineError) it holds what it held before that call. */
export class Binding {
  mesh: TakenMesh | null = null;
  motion: TakenMotion | null = null;
  private points: string | null = null;
  private solved: readonly unknown[] | null = null;

  constructor(readonly engine: Engine) {}

  /** Mesh, points and motion, as far as the document has them: bad_mesh, bad_controls, bad_motion, cancelled. */
  async take(document: ProjectDocument, { model, motion }: Parts, call: CallFor = QUIETLY): Promise<void> {
    if (!model) return;
    await this.takeMesh(document, model, call);
    await this.takePoints(document, model, call);
    if (motion) await this.takeMotion(document, motion, call);
  }

  /** The motion as the document cuts and reads it. */
  async takeMotion(document: Danced, input: MotionInput, call: CallFor = QUIETLY): Promise<Motion> {
    const edits = motionEdits(document);
    const said = JSON.stringify(edits);
    if (this.motion?.input !== input || this.motion.said !== said) {
      const motion = await this.engine.setMotion({ ...input, edits }, call("Reading the motion"));
      this.motion = { input, said, motion };
      this.solved = null;
    }
    return this.motion.motion;
  }

  /** Whether the dance of this document was solved last. */
  isSolved(document: ProjectDocument): boolean {
    const parts = solvedParts(document);
    return this.solved?.every((part, k) => part === parts[k]) ?? false;
  }

  /** The dance of a document that was taken: bad_controls, bad_motion, bad_examples, cancelled. */
  async solve(document: ProjectDocument, call: CallFor = QUIETLY, onLook?: (frame: ShapedFrame) => void): Promise<Performance> {
    const { mesh, motion } = this;
    if (!mesh) throw new EngineError("bad_mesh", "There is no model yet.");
    if (!motion) throw new EngineError("bad_motion", "There is no motion yet. Choose one.");
    let input = retargetInput(mesh.model, document, motion.motion);
    if (hasDetails(document)) input = (await import("./details")).detailed(input, mesh.model, document, motion.motion);
    const performance = await this.engine.retarget(input, call("Solving"), onLook);
    this.solved = solvedParts(document);
    return performance;
  }

  /** Frames of the dance that was solved last, in this order, as each is ready; then the same as they are drawn. */
  frames(order: ArrayLike<number>, onFrame: (index: number, frame: Frame) => void, call: CallFor = QUIETLY): Promise<void> {
    return this.engine.frames(order, onFrame, call("Deforming"));
  }
  shapes(order: ArrayLike<number>, onShape: (index: number, frame: ShapedFrame) => void, call: CallFor = QUIETLY): Promise<void> {
    return this.engine.shapes(order, onShape, call("Deforming"));
  }

  private async takeMesh(document: ProjectDocument, model: SolverModel, call: CallFor): Promise<void> {
    const { mesh, stiff, settings } = document;
    const said = [stiff, settings.paper];
    const held = this.mesh;
    if (held?.model === model && sameMesh(held.mesh, mesh) && said.every((one, k) => one === held.said[k])) return;
    const input = meshInput(model, mesh);
    if (settings.paper) input.paper = true;
    if (stiff) input.rigidity = (await import("./stiff")).rigidityOf(model, document);
    const report = await this.engine.setMesh(input, call("Binding the model"));
    this.mesh = { model, mesh, said, report };
    this.points = null;
    this.solved = null;
  }

  private async takePoints(document: ProjectDocument, model: SolverModel, call: CallFor): Promise<void> {
    const solid = solveOf(document.mesh) === "solid";
    const limbs = solid && model.joints?.length ? (await import("./named-limbs")).namedLimbs(model, document) : [];
    const controls = controlInputs(model, document).map((control, c) => ({ ...control, ...limbs[c] }));
    const key = JSON.stringify(controls);
    if (this.points === key || controls.length === 0) return;
    await this.engine.setControls(controls, call("Binding the points"));
    this.points = key;
    this.solved = null;
  }
}

/** Whether a model taken as one is taken as the other. */
export function sameMesh(a: MeshRef, b: MeshRef): boolean {
  return a.facing === b.facing && a.up === b.up && solveOf(a) === solveOf(b);
}

/** Whether it says what few documents say. */
function hasDetails(document: ProjectDocument): boolean {
  const { pins, contacts, flights } = clipOf(document);
  const { points, examples, settings } = document;
  return (
    [pins, contacts, flights, settings.paper].some(Boolean) || [...points, ...examples].some((one) => "wholePose" in one || "turns" in one)
  );
}

/** What a dance depends on besides mesh and motion, by identity: the document is immutable. */
function solvedParts(document: ProjectDocument): readonly unknown[] {
  return [document.points, document.examples, document.settings, clipOf(document)];
}
