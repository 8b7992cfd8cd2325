import { expect, test } from "vitest";
import { Coverage } from "../../src/app/coverage";
import { Dragging } from "../../src/app/dragging";
import { Poses } from "../../src/app/poses";
import { danced, dancingContext, listen } from "./app-support";

test("the pose that teaches most is asked for, and a pose at its frame is the answer", async () => {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => poses.take(dropped));
  const poses = new Poses(context, dragging);
  const coverage = new Coverage(context, poses);
  context.history.apply((document) => ({ ...document, examples: [] }));
  await danced(context);
  const told = listen(context, "coverage", "intro");
  const [best] = coverage.asked;
  expect(best).toBe(context.performance?.ask[0]?.frame);
  context.selection.beginIntro();
  coverage.ask();
  expect(coverage.asking).toBe(best);
  expect(context.player.frame).toBe(best);
  expect(context.selection.intro).toBe(false);
  expect(told.at(-1)).toBe("coverage");
  coverage.answer();
  expect(coverage.asking).toBeNull();
  expect(poses.here.map(({ source }) => source.frame)).toEqual([best]);
  expect(coverage.asked).not.toContain(best);
});

test("a question is over when it is skipped, or another way answers it", async () => {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => poses.take(dropped));
  const poses = new Poses(context, dragging);
  const coverage = new Coverage(context, poses);
  coverage.ask(12);
  coverage.skip();
  expect(coverage.asking).toBeNull();
  coverage.ask(12);
  poses.add();
  expect(coverage.asking).toBeNull();
  coverage.ask(20);
  context.player.seek(3);
  context.history.undo();
  expect(coverage.asking).toBeNull();
});
