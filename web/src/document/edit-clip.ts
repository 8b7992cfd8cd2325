// How a motion is cut and read: what only those need who change it.

import { clipName, merged, saidOf } from "./clips";
import type { Command } from "./store";
import type { ClipEdits, FileFacts } from "./types";

/** What of a motion can be said besides pins and contacts; undefined: as it came. */
export type MotionEdits = { [K in "cut" | "speed" | "mirror" | "loop"]?: ClipEdits[K] | undefined };

export const editMotion =
  (edits: MotionEdits): Command =>
  (document) =>
    change(document, { ...saidOf(document), ...edits });

/** What of a file can be said; undefined: as guessed. */
export type FileEdits = { [K in keyof FileFacts]?: FileFacts[K] | undefined };

/** What the file is, instead of what is guessed. `pace`: frames go so many times as fast now, and what is said of some goes with them. */
export const correctFile =
  (edits: FileEdits, pace = 1): Command =>
  (document) => {
    const said = saidOf(document);
    const file = told({ ...said.file, ...edits });
    return change(document, { ...atPace(said, pace), file: Object.keys(file).length > 0 ? file : undefined });
  };

function atPace(clip: ClipEdits, pace: number): ClipEdits {
  if (pace === 1) return clip;
  const { cut, pins, contacts, flights } = clip;
  const at = (frame: number): number => Math.round(frame / pace);
  const run = ([a, b]: readonly [number, number]): readonly [number, number] => [at(a), Math.max(at(b), at(a) + 1)];
  return {
    ...clip,
    ...(cut && { cut: run(cut) }),
    ...(pins && { pins: pins.map((pin) => ({ ...pin, frame: Math.max(at(pin.frame), pin.kind === "still" ? 1 : 0) })) }),
    ...(contacts && { contacts: Object.fromEntries(Object.entries(contacts).map(([id, runs]) => [id, merged(runs.map(run))])) }),
    ...(flights && { flights: merged(flights.map(run)) }),
  };
}

function change(document: Parameters<Command>[0], edits: { [K in keyof ClipEdits]: ClipEdits[K] | undefined }): ReturnType<Command> {
  const clip = told(edits);
  if (JSON.stringify(clip) === JSON.stringify(saidOf(document))) return document;
  return { ...document, clips: { ...document.clips, [clipName(document)]: clip } };
}

/** Without what is not said. */
function told<T extends object>(said: T): { [K in keyof T]?: NonNullable<T[K]> } {
  return Object.fromEntries(Object.entries(said).filter(([, value]) => value !== undefined)) as { [K in keyof T]?: NonNullable<T[K]> };
}
