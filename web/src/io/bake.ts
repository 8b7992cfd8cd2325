// A whole project through an engine: every frame that an export needs.

import type { ProjectDocument } from "../document/types";
import type { Engine, Frame, Motion, MotionInput, Performance } from "../engine/types";
import { controlInputs, meshInput, retargetInput, type SolverModel } from "../sync/prepare";

export interface Bake {
  motion: Motion;
  performance: Performance;
  /** By frame number; T of them. */
  frames: Frame[];
}

export interface BakeOptions {
  signal?: AbortSignal;
  /** What is being done, and 0..1 of it. */
  onProgress?: (step: string, done: number) => void;
  /** Told the motion once it is read; what it throws ends the bake. */
  onMotion?: (motion: Motion) => void;
  /** Told the number of frames before they are made; what it throws ends the bake. */
  onSolved?: (frames: number) => void;
}

/** Binds, retargets and deforms all T frames. Keeps V x 3 floats per frame. Rejects with EngineError. */
export async function bake(
  engine: Engine,
  document: ProjectDocument,
  model: SolverModel,
  motionInput: MotionInput,
  options: BakeOptions = {},
): Promise<Bake> {
  const call = (step: string): { signal?: AbortSignal; onProgress: (done: number) => void } => ({
    ...(options.signal && { signal: options.signal }),
    onProgress: (done) => options.onProgress?.(step, done),
  });
  const motion = await engine.setMotion(motionInput, call("Reading the motion"));
  options.onMotion?.(motion);
  await engine.setMesh(meshInput(model, document.mesh), call("Binding the model"));
  await engine.setControls(controlInputs(model, document), call("Binding the points"));
  const performance = await engine.retarget(retargetInput(model, document, motion), call("Solving"));
  options.onSolved?.(performance.frames);
  const frames: Frame[] = [];
  const order = Array.from({ length: performance.frames }, (_, f) => f);
  await engine.frames(order, (index, frame) => (frames[index] = frame), call("Deforming"));
  return { motion, performance, frames };
}
