import { expect, test } from "vitest";
import { Guesses } from "../../src/app/guesses";
import { Pairing } from "../../src/app/pairing";
import { Points } from "../../src/app/points";
import { dancingContext } from "./app-support";

async function pairing() {
  const { context } = await dancingContext();
  const points = new Points(context);
  const guesses = new Guesses(context);
  return { context, guesses, pairing: new Pairing(context, points, guesses) };
}

test("a click on the model makes a point that waits for a joint; a click on a joint is the answer", async () => {
  const { context, pairing: pairs } = await pairing();
  const count = context.document.points.length;
  pairs.surface(100);
  expect(context.document.points).toHaveLength(count);
  pairs.toggleAdd();
  pairs.surface(100);
  const id = context.document.points.at(-1)?.id;
  expect([pairs.waiting, pairs.asks]).toEqual([id, true]);
  pairs.joint(3);
  expect(context.document.points.at(-1)?.joint).toBe(context.motion?.joints[3].name);
  expect(pairs.waiting).toBeNull();
  pairs.stop();
  expect(pairs.asks).toBe(false);
});

test("a dot of the model waits while points are made; a dot of the human gives its joint", async () => {
  const { context, pairing: pairs } = await pairing();
  pairs.pick("top", "model");
  expect([context.selection.point, pairs.waiting]).toEqual(["top", null]);
  context.selection.setPanel("points");
  pairs.pick("top", "model");
  expect(pairs.waiting).toBe("top");
  pairs.pick("left-arm", "human");
  expect(context.document.points[0].joint).toBe("LeftHand");
  expect([context.selection.point, pairs.waiting]).toEqual(["top", null]);
});

test("the panel begins with adding where nothing is yet, and ends what it asked for", async () => {
  const { context, pairing: pairs } = await pairing();
  context.selection.setPanel("points");
  expect(pairs.adding).toBe(false);
  context.history.apply((document) => ({ ...document, points: [], examples: [] }));
  context.selection.setPanel("points");
  expect(pairs.adding).toBe(true);
  pairs.surface(7);
  expect(pairs.waiting).not.toBeNull();
  context.history.undo();
  expect(pairs.waiting).toBeNull();
  context.selection.setPanel(null);
  expect(pairs.asks).toBe(false);
});

test("a click on a suggested dot makes it a point", async () => {
  const { context, guesses, pairing: pairs } = await pairing();
  context.history.apply((document) => ({ ...document, points: [], examples: [] }));
  await guesses.suggest();
  const [suggested] = guesses.suggested;
  pairs.pick(guesses.markOf(suggested), "model");
  expect(context.document.points).toEqual([suggested]);
});
