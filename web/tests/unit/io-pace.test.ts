import { expect, it } from "vitest";

import { paced } from "../../src/io/pace";
import { toWorld } from "../../src/sync/placement";

/** One vertex beside the body's middle that swings while the body goes and turns. */
const at = (f: number): Float32Array => toWorld(Float32Array.of(1, Math.sin(0.1 * f), 0.03 * f), [0.1 * f, 0.01 * f, -0.05 * f, 0.02 * f]);
const dance = (count: number): { positions: Float32Array }[] => Array.from({ length: count }, (_, f) => ({ positions: at(f) }));

const numbers = (frames: readonly { positions: Float32Array }[]): number[] => frames.flatMap(({ positions }) => [...positions]);

it("leaves frames as they are at their own pace", () => {
  const frames = dance(20);
  expect(numbers(paced(frames, 30, 1))).toEqual(numbers(frames));
  expect(numbers(paced(frames, 60, 2))).toEqual(numbers(frames));
});

it.each([
  [24, 1],
  [60, 1],
  [30, 0.25],
  [30, 4],
  [24, 1.5],
])("has first and last at %i frames a second, %f times as fast, and goes smoothly between", (fps, speed) => {
  const frames = dance(61);
  const made = paced(frames, fps, speed);
  expect(made).toHaveLength(Math.round((2 * fps) / speed) + 1); // two seconds
  expect(made[0].positions).toEqual(frames[0].positions);
  expect(made.at(-1)?.positions).toEqual(frames[60].positions);
  made.forEach(({ positions }, k) => {
    const wanted = at((k * 60) / (made.length - 1));
    positions.forEach((x, i) => expect(Math.abs(x - wanted[i])).toBeLessThan(1e-3));
  });
});

it("takes clips of a frame or none", () => {
  for (const count of [0, 1]) {
    const frames = dance(count);
    for (const fps of [24, 60]) expect(numbers(paced(frames, fps, 2))).toEqual(numbers(frames));
  }
});
