import { expect, test } from "vitest";
import { Guesses } from "../../src/app/guesses";
import { dancingContext, listen } from "./app-support";

test("the points panel suggests where else the model may be held, and one click takes one", async () => {
  const { context } = await dancingContext();
  const guesses = new Guesses(context);
  const told = listen(context, "suggestions");
  expect(guesses.suggested).toEqual([]);
  context.history.apply((document) => ({ ...document, points: [], examples: [] }));
  context.selection.setPanel("points");
  await expect.poll(() => told).toEqual(["suggestions"]);
  const [first, ...others] = guesses.suggested;
  expect(others.length).toBeGreaterThan(2);
  expect(guesses.take("top")).toBe(false);
  expect(guesses.take(guesses.markOf(first))).toBe(true);
  expect(context.document.points).toEqual([first]);
  expect(context.selection.point).toBe(first.id);
  expect(guesses.suggested).not.toContainEqual(first);
});

test("a model is asked once, and says how it stands", async () => {
  const { context } = await dancingContext();
  const guesses = new Guesses(context);
  const guess = await guesses.of(context.model!);
  expect(guess?.mesh).toEqual({ up: "+y", facing: "+z" });
  expect(guess?.points.length).toBeGreaterThan(3);
  context.workspace.close();
  expect(await guesses.of(context.model!)).toEqual(guess);
  expect(await guesses.of({ positions: new Float32Array(9), faces: Uint32Array.of(0, 1, 2) })).toBeNull();
});
