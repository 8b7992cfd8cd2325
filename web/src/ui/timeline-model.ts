import type { Performance } from "../engine/types";

export interface ContactRow {
  control: number;
  /** Half-open runs [a, b) of frames on the ground. */
  runs: [number, number][];
}

/** One row per control that ever stands on the ground, in the order of the controls. */
export function contactRows(performance: Performance | null, controls: number): ContactRow[] {
  if (!performance || performance.contacts.length !== performance.frames * controls) return [];
  const rows: ContactRow[] = [];
  for (let control = 0; control < controls; control++) {
    const runs: [number, number][] = [];
    let start = -1;
    for (let frame = 0; frame <= performance.frames; frame++) {
      const on = frame < performance.frames && performance.contacts[frame * controls + control] === 1;
      if (on && start < 0) start = frame;
      if (!on && start >= 0) {
        runs.push([start, frame]);
        start = -1;
      }
    }
    if (runs.length > 0) rows.push({ control, runs });
  }
  return rows;
}

const STEPS = [5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
const LABEL_PX = 56;

/** Frames between two labels of the ruler, so that labels keep their distance. */
export function rulerStep(last: number, pixels: number): number {
  return STEPS.find((step) => (step / last) * pixels >= LABEL_PX) ?? 10_000;
}
