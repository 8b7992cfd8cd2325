// A whole document at once: every frame that an export needs.

import type { ProjectDocument } from "../document/types";
import type { Frame, Motion, MotionInput, Performance } from "../engine/types";
import type { Binding, CallFor } from "./binding";
import type { SolverModel } from "./placement";

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
  binding: Binding,
  document: ProjectDocument,
  parts: { readonly model: SolverModel; readonly motion: MotionInput },
  { signal, onProgress, onMotion, onSolved }: BakeOptions = {},
): Promise<Bake> {
  const call: CallFor = (step) => {
    onProgress?.(step, 0); // quick steps are told too
    return { ...(signal && { signal }), onProgress: (done) => onProgress?.(step, done) };
  };
  const motion = await binding.takeMotion(document, parts.motion, call);
  onMotion?.(motion);
  await binding.take(document, parts, call);
  const performance = await binding.solve(document, call);
  onSolved?.(performance.frames);
  const frames: Frame[] = [];
  const order = Array.from({ length: performance.frames }, (_, f) => f);
  await binding.frames(order, (index, frame) => (frames[index] = frame), call);
  return { motion, performance, frames };
}
