// Runs of frames in which something holds: a point stands, nobody does.

import type { Performance } from "../engine/types";

/** A half-open run of frames. */
export type Run = readonly [number, number];

/** The runs in which a control stands on the ground. */
export function runsOf(performance: Performance, control: number, controls: number): Run[] {
  if (performance.contacts.length !== performance.frames * controls) return [];
  const runs: Run[] = [];
  let start = -1;
  for (let frame = 0; frame <= performance.frames; frame++) {
    const on = frame < performance.frames && performance.contacts[frame * controls + control] === 1;
    if (on && start < 0) start = frame;
    if (!on && start >= 0) {
      runs.push([start, frame]);
      start = -1;
    }
  }
  return runs;
}

/** What of a run a hand has hold of. */
export type Grip = "begin" | "end" | "all";

/** The runs after one of them was moved by so many frames; it stays in the clip and at least a frame long. */
export function movedRun(runs: readonly Run[], at: number, grip: Grip, by: number, frames: number): Run[] {
  const run = runs[at];
  if (!run) return [...runs];
  const [a, b] = run;
  const clamp = (value: number, low: number, high: number): number => Math.max(low, Math.min(high, value));
  if (grip === "begin") return runs.toSpliced(at, 1, [clamp(a + by, 0, b - 1), b]);
  if (grip === "end") return runs.toSpliced(at, 1, [a, clamp(b + by, a + 1, frames)]);
  const shift = clamp(by, -a, frames - b);
  return runs.toSpliced(at, 1, [a + shift, b + shift]);
}
