import { expect, test } from "vitest";
import { setSettings } from "../../src/document/commands";
import { danced, dancingContext, emptyContext, listen, said } from "./app-support";

test("a document that changes is solved, and every topic is told", async () => {
  const { context } = await dancingContext();
  const told = listen(context, "document", "saved", "solve", "meter", "frame", "play", "notices");
  const before = context.performance;
  context.history.apply(setSettings({ volume: 2 }));
  expect(told.splice(0)).toEqual(["document", "saved"]);
  await expect.poll(() => context.performance).not.toBe(before); // nobody asks for it
  await danced(context);
  expect(told).toContain("solve");
  expect(context.solving).toBe(false);
  expect(context.meter.median).toBeGreaterThan(0);
  context.player.seek(7);
  expect(told).toContain("frame");
  context.player.play();
  expect(told).toContain("play");
  context.notices.say({ title: "Hello." });
  expect(told).toContain("notices");
  expect(said(context)).toEqual(["Hello."]);
});

test("what is: model, motion, dance and its controls; no dance while points came or went", async () => {
  const { context } = await dancingContext();
  expect(context.model?.positions.length).toBe(3 * (context.workspace.report?.vertices ?? 0));
  expect(context.motion?.frames).toBe(30);
  expect(context.motionName).toBe("hop.bvh");
  const size = 3 * context.document.points.length;
  expect(context.controlsAt(3)).toEqual(context.performance?.controls.slice(3 * size, 4 * size));
  context.selection.select("top");
  context.history.apply((document) => ({ ...document, points: document.points.slice(1) }));
  expect(context.performance).toBeNull();
  expect(context.controlsAt(3)).toBeNull();
  expect(context.selection.point).toBeNull();
});

test("nothing is there to begin with", () => {
  const { context } = emptyContext();
  expect([context.model, context.motion, context.performance, context.motionName]).toEqual([undefined, null, null, ""]);
});
