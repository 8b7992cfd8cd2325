// How odd models stand and which limbs they have is found without any names, against the truth that each brings.

import { afterAll, beforeAll, expect, test } from "vitest";

import { glbBytes, HOSTILE, type HostileModel, objText } from "../../authoring/strangers/hostile.js";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine, ShapeAnalysis } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { shapeInput } from "../../src/sync/shape-input";

let engine: Engine;
beforeAll(async () => void (engine = await createNodeEngine()));
afterAll(() => engine.close());

/** Boxes that touch over whole sides: where an arm begins, their names alone tell. */
const { million, blocks, ...FOUND } = HOSTILE;

async function said(made: HostileModel, named: boolean): Promise<ShapeAnalysis> {
  const bytes = made.format === "glb" ? glbBytes(made) : new TextEncoder().encode(objText(made));
  const { joints, ...model } = await readModel([{ name: `${made.name}.${made.format}`, bytes }]);
  return engine.analyseShape(shapeInput(named ? { ...model, joints } : model));
}

const sides = ({ points }: ShapeAnalysis, ...roles: string[]): string[] =>
  points.flatMap(({ role, side, wanted }) => (wanted && roles.includes(role) ? [side ?? "middle"] : [])).sort();

function limbsOf({ truth }: HostileModel, end: string): string[] {
  return Object.keys(truth.limbs)
    .filter((name) => name.endsWith(end))
    .map((name) => (name.includes("left") ? "left" : "right"))
    .sort();
}

test.each(Object.entries(FOUND))("%s", async (_, make) => {
  const made = make();
  const found = await said(made, false);
  expect(found.up).toBe(made.truth.up);
  if (made.truth.front) expect(found.facing).toBe(made.truth.front);
  const [hands, feet] = [limbsOf(made, "hand"), limbsOf(made, "foot")];
  if (hands.length > 0) expect(sides(found, "hand")).toEqual(hands);
  if (feet.length > 0) expect(sides(found, "foot", "foreleg")).toEqual(feet);
});

test("an arm that is named and hangs beside the hips ends at its hand, not at the foot below", async () => {
  const made = HOSTILE["person-hanging"]();
  const model = await readModel([{ name: "person.obj", bytes: new TextEncoder().encode(objText(made)) }]);
  const inside = ([x, y, z]: [number, number, number]): [number, number, number] => [0.6 * x, y, z];
  const landmarks = (["left", "right"] as const).flatMap((side) =>
    (["hand", "foot"] as const).map((role) => ({
      role,
      side: side === "left" ? (1 as const) : (-1 as const),
      position: inside(made.truth.limbs[`${side}-${role}`]),
    })),
  );
  const found = await engine.analyseShape({ ...shapeInput(model), landmarks });
  const heights = (role: string): number[] =>
    found.points.filter((point) => point.role === role).map(({ vertex }) => model.positions[3 * vertex + 1]);
  expect(heights("hand")).toHaveLength(2);
  for (const y of heights("hand")) expect(y).toBeGreaterThan(0.6);
  expect(heights("foot")).toHaveLength(2);
  for (const y of heights("foot")) expect(y).toBeLessThan(0.15);
});

test("parts that are named say where arms end that lie against the trunk", async () => {
  const made = blocks();
  const found = await said(made, true);
  expect({ up: found.up, facing: found.facing }).toEqual({ up: made.truth.up, facing: made.truth.front });
  expect(sides(found, "hand")).toEqual(["left", "right"]);
  expect(sides(found, "foot")).toEqual(["left", "right"]);
});
