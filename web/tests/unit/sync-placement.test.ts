import { expect, test } from "vitest";
import { toLocal, toWorld } from "../../src/sync/placement";
import type { Root } from "../../src/sync/placement";

test("yaw turns +Z towards +X about the vertical axis", () => {
  const [x, y, z] = toWorld(Float32Array.of(0, 0, 1), [0, 0, 0, Math.PI / 2]);
  expect(x).toBeCloseTo(1, 6);
  expect(y).toBeCloseTo(0, 6);
  expect(z).toBeCloseTo(0, 6);
});

test("there and back again", () => {
  const root: Root = [0.4, 0.1, -2, 2.3];
  const world = toWorld(Float32Array.of(0.3, 1.2, -0.5), root);
  const back = toLocal([world[0], world[1], world[2]], root);
  expect(back[0]).toBeCloseTo(0.3, 6);
  expect(back[1]).toBeCloseTo(1.2, 6);
  expect(back[2]).toBeCloseTo(-0.5, 6);
});
