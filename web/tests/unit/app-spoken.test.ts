import { expect, test } from "vitest";
import { Dragging } from "../../src/app/dragging";
import { Points } from "../../src/app/points";
import { Poses } from "../../src/app/poses";
import { Spoken } from "../../src/app/spoken";
import { setSettings } from "../../src/document/commands";
import { dancingContext } from "./app-support";

async function listening() {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => poses.take(dropped));
  const poses = new Poses(context, dragging);
  const spoken = new Spoken(context, dragging);
  const heard: string[] = [];
  context.signals.on("document", (before) => heard.push(spoken.of(before)));
  const free = Array.from({ length: 30 }, (_, f) => f).find((f) => poses.here.every(({ source }) => source.frame !== f)) ?? 0;
  context.player.seek(free);
  return { context, dragging, poses, heard, free };
}

test("a burst of arrows says which way the point went, and how many poses there are", async () => {
  const { context, dragging, heard, free } = await listening();
  const count = context.document.examples.length;
  for (let k = 0; k < 3; k++) dragging.nudge("top", "ArrowUp", false);
  dragging.drop();
  expect(heard).toEqual([`Top 3 cm up, ${count + 1} poses`]);
  context.history.undo();
  expect(heard.at(-1)).toBe(`Pose at frame ${free} is gone, ${count} poses`);
});

test("a drag that was let go of is not told with the next pose", async () => {
  const { context, dragging, poses, heard, free } = await listening();
  dragging.nudge("top", "ArrowUp", false);
  dragging.cancel();
  await Promise.resolve();
  poses.add();
  expect(heard).toEqual([`Pose at frame ${free}, ${context.document.examples.length} poses`]);
});

test("settings, points and their joints have words of their own; what is not heard says nothing", async () => {
  const { context, heard } = await listening();
  const points = new Points(context);
  const count = context.document.points.length;
  context.history.apply(setSettings({ volume: 1.25 }));
  context.history.apply(setSettings({ groundContact: false }));
  points.set("top", { name: "Crown" });
  points.pair("top", null);
  points.set("top", { radius: 0.1 });
  points.remove("top");
  expect(heard).toEqual([
    expect.stringMatching(/^Volume 1\.[23]$/),
    "Ground contact off",
    "Top is Crown",
    "Crown follows the whole pose",
    "Crown changed",
    expect.stringContaining(`, ${count - 1} points`),
  ]);
});
