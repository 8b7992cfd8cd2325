import { expect, it } from "vitest";

import { type Cut, cutClip } from "../../src/io/cut-clip";
import { toWorld } from "../../src/sync/placement";

/** One vertex beside the body's middle that swings while the body goes and turns. */
const dance = (count: number): { positions: Float32Array; root: [number, number, number, number] }[] =>
  Array.from({ length: count }, (_, f) => {
    const root: [number, number, number, number] = [0.1 * f, 0.01 * f, -0.05 * f, 0.02 * f];
    return { positions: toWorld(Float32Array.of(1, Math.sin(0.1 * f), 0.03 * f), root), root };
  });

const plain: Cut = { fps: 30, loop: false };
const numbers = (frames: readonly { positions: Float32Array }[]): number[] => frames.flatMap(({ positions }) => [...positions]);

it("leaves frames as they are at their own pace", () => {
  const frames = dance(20);
  expect(numbers(cutClip(frames, plain))).toEqual(numbers(frames));
});

it.each([24, 60])("has first and last at %i frames a second, and goes smoothly between", (fps) => {
  const frames = dance(31);
  const cut = cutClip(frames, { ...plain, fps });
  expect(cut).toHaveLength(fps + 1); // a second
  expect(cut[0].positions).toEqual(frames[0].positions);
  expect(cut[fps].positions).toEqual(frames[30].positions);
  cut.forEach(({ positions }, k) => {
    const f = (k * 30) / fps;
    const at = toWorld(Float32Array.of(1, Math.sin(0.1 * f), 0.03 * f), [0.1 * f, 0.01 * f, -0.05 * f, 0.02 * f]);
    positions.forEach((x, i) => expect(Math.abs(x - at[i])).toBeLessThan(1e-3));
  });
});

it("takes clips of a frame or none", () => {
  for (const count of [0, 1]) {
    const frames = dance(count);
    for (const fps of [24, 60]) expect(numbers(cutClip(frames, { fps, loop: true }))).toEqual(numbers(frames));
  }
});

it("leads the end to the beginning, and goes on from where it is", () => {
  const frames = dance(40);
  const closed = cutClip(frames, { ...plain, loop: true });
  expect(numbers(closed.slice(0, 30))).toEqual(numbers(frames.slice(0, 30)));
  const [x, , z, yaw] = frames[39].root;
  const wanted = toWorld(frames[0].positions, [x, 0, z, yaw]);
  closed[39].positions.forEach((value, i) => expect(value).toBeCloseTo(wanted[i], 5));
  // Nowhere does it go much faster than it did.
  const steps = (all: readonly { positions: Float32Array }[]): number[] =>
    all.slice(1).map(({ positions }, f) => Math.hypot(...positions.map((value, i) => value - all[f].positions[i])));
  expect(Math.max(...steps(closed))).toBeLessThan(3 * Math.max(...steps(frames)));
});
