import { expect, test } from "vitest";
import { applied, difference } from "../../src/document/difference";

const BEFORE = {
  name: "Cactus",
  settings: { volume: 1, energy: 0 },
  points: [
    { id: "top", joint: "Head", position: [0, 1, 0] },
    { id: "arm", joint: "Hand", position: [1, 1, 0], radius: 0.1 },
  ],
  clips: { "hop.bvh": { cut: [3, 20] } },
};

test.each<[string, unknown]>([
  ["nothing", BEFORE],
  ["a name", { ...BEFORE, name: "Spiky" }],
  ["a value in a table", { ...BEFORE, settings: { volume: 2, energy: 0 } }],
  ["a key that is gone and one that is new", { name: "Cactus", settings: {}, points: BEFORE.points, joints: { a: "head" } }],
  ["a thing that is gone", { ...BEFORE, points: [BEFORE.points[1]] }],
  ["another order", { ...BEFORE, points: [BEFORE.points[1], BEFORE.points[0]] }],
  [
    "a thing that has changed, without what it had",
    { ...BEFORE, points: [BEFORE.points[0], { id: "arm", joint: null, position: [1, 2, 0] }] },
  ],
  ["a new thing", { ...BEFORE, points: [...BEFORE.points, { id: "foot", joint: "Foot", position: [0, 0, 0] }] }],
  ["no things", { ...BEFORE, points: [] }],
  ["an empty table", { ...BEFORE, clips: {} }],
  ["a table that became nothing", { ...BEFORE, settings: null }],
])("%s is told as a difference and comes back", (_, after) => {
  const told = JSON.stringify(difference(BEFORE, after) ?? null);
  expect(applied(BEFORE, JSON.parse(told) ?? undefined)).toEqual(after);
});

test("what is alike is not told", () => {
  expect(difference(BEFORE, structuredClone(BEFORE))).toBeUndefined();
  expect(difference(BEFORE, { ...BEFORE, points: [BEFORE.points[0], { ...BEFORE.points[1], radius: 0.2 }] })).toEqual([
    { points: [0, [1, [{ radius: 0.2 }]]] },
  ]);
});

test("what is no difference is refused", () => {
  for (const change of [5, {}, [5], [{ points: 5 }], [{ points: [2] }], [{ points: ["0"] }], [{ settings: [[]] }]])
    expect(() => applied(BEFORE, change), JSON.stringify(change)).toThrow(RangeError);
});
