import { expect, test } from "vitest";
import { Playback } from "../../src/app/playback";
import { setSettings } from "../../src/document/commands";
import { danced, dancingContext } from "./app-support";

test("the page opens moving once its frame is there, unless that is unwelcome", async () => {
  for (const begins of [true, false]) {
    const { context } = await dancingContext();
    new Playback(context, begins);
    context.history.apply(setSettings({ volume: 2 }));
    await danced(context);
    expect(context.player.playing).toBe(begins);
  }
});

test("a pose that was made while it danced lets it dance on; whoever pauses wants no surprise", async () => {
  const { context } = await dancingContext();
  const playback = new Playback(context, false);
  context.signals.emit("freeze", { frame: 0, playOn: true });
  context.history.apply(setSettings({ volume: 2 }));
  await danced(context);
  expect(context.player.playing).toBe(true);
  playback.toggle();
  expect(context.player.playing).toBe(false);
  context.signals.emit("freeze", { frame: 0, playOn: true });
  playback.toggle();
  playback.toggle();
  context.history.apply(setSettings({ volume: 1 }));
  await danced(context);
  expect(context.player.playing).toBe(false);
});

test("the playhead is as long as the dance, else as the motion, and frames are made from where it is", async () => {
  const { context } = await dancingContext();
  new Playback(context, false);
  context.player.setFrames(3);
  context.history.apply((document) => ({ ...document, points: [], examples: [] }));
  await danced(context);
  expect(context.player.frames).toBe(30);
  context.history.undo();
  context.player.seek(20);
  const order: number[] = [];
  context.workspace.on("frame", (frame) => order.push(frame));
  await danced(context);
  expect(order[0]).toBe(20);
});
