// The odd models that other tests lean on are what they say: whole, the same each time, limbs where they are told, and files that open.

import { expect, test } from "vitest";

import { glbBytes, HOSTILE, type HostileModel, objText } from "../../authoring/strangers/hostile.js";
import { readModel } from "../../src/io/read-model";

const { million, ...SMALL } = HOSTILE;
const MADE = Object.entries(SMALL).map(([name, make]) => [name, make()] as const);

function heightOf({ positions, truth }: HostileModel): number {
  const axis = "xyz".indexOf(truth.up[1]);
  const along = positions.filter((_, i) => i % 3 === axis);
  return Math.max(...along) - Math.min(...along);
}

/** From a place to the nearest vertex or middle of an edge. */
function gapTo(place: readonly number[], { positions, faces }: HostileModel): number {
  let least = Infinity;
  const at = (v: number, k: number): number => positions[3 * v + k] - place[k];
  for (let i = 0; i < faces.length; i++) {
    const [a, b] = [faces[i], faces[i % 3 === 2 ? i - 2 : i + 1]];
    least = Math.min(least, Math.hypot(at(a, 0), at(a, 1), at(a, 2)));
    least = Math.min(least, Math.hypot(...[0, 1, 2].map((k) => (at(a, k) + at(b, k)) / 2)));
  }
  return least;
}

test("there are at least thirty of them, a million triangles among them", () => {
  expect(Object.keys(HOSTILE).length).toBeGreaterThanOrEqual(30);
  expect(million).toBeTypeOf("function");
});

test.each(MADE)("%s is whole and its limbs end on it", (name, model) => {
  const vertices = model.positions.length / 3;
  expect(model.name).toBe(name);
  expect(model.positions.every(Number.isFinite)).toBe(true);
  expect(model.faces.every((v) => v < vertices)).toBe(true);
  expect(model.parts.reduce((sum, { count }) => sum + count, 0)).toBe(model.faces.length / 3);
  const height = heightOf(model);
  for (const place of Object.values(model.truth.limbs)) expect(gapTo(place, model) / height).toBeLessThan(0.09);
});

test.each(["soup", "holes", "random-winding", "debris"])("%s is the same each time", (name) => {
  const before = MADE.find(([known]) => known === name)?.[1];
  const again = HOSTILE[name]();
  // Not toEqual: of tens of thousands of numbers it would print the differences for minutes.
  expect(again.positions.every((x, i) => x === before?.positions[i])).toBe(true);
  expect(again.faces.every((v, i) => v === before?.faces[i])).toBe(true);
});

test.each(MADE)("%s opens from its file", async (name, model) => {
  const bytes = model.format === "glb" ? glbBytes(model) : new TextEncoder().encode(objText(model));
  const read = await readModel([{ name: `${name}.${model.format}`, bytes }]);
  expect(read.faces.length).toBeGreaterThan(0);
  expect(read.faces.length).toBeLessThanOrEqual(model.faces.length);
});

test("the person turned by quarters stands as its truth says", () => {
  for (const [name, up, front] of [
    ["upside-down", "-y", "+z"],
    ["quarter-left", "+y", "+x"],
    ["backwards", "+y", "-z"],
    ["z-up", "+z", "-y"],
    ["lies-on-side", "-x", "+z"],
  ]) {
    const { positions, truth } = HOSTILE[name]();
    expect(truth).toMatchObject({ up, front });
    const along = (place: readonly number[], axis: string): number => (axis[0] === "-" ? -1 : 1) * place["xyz".indexOf(axis[1])];
    const { head, "left-foot": foot } = truth.limbs;
    // The nose, the one thing that sticks out in front, is nearer to the head than the back of anything.
    expect(along(head, up) - along(foot, up)).toBeCloseTo(1.655, 3);
    const ahead: number[] = [];
    for (let i = 0; i < positions.length; i += 3) ahead.push(along([...positions.subarray(i, i + 3)], front));
    expect(Math.max(...ahead)).toBeCloseTo(along(foot, front) + 0.04, 1);
  }
});
