import { expect, test } from "vitest";
import { Dragging } from "../../src/app/dragging";
import { Pins } from "../../src/app/pins";
import { pointsOfControls } from "../../src/sync/point-controls";
import { danced, dancingContext, said } from "./app-support";

async function pinning() {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => pins.take(dropped));
  const pins = new Pins(context, dragging);
  return { context, dragging, pins };
}

test("what the hand holds is pinned where it is; the next dance keeps it", async () => {
  const { context, dragging, pins } = await pinning();
  const frozen: unknown[] = [];
  context.signals.on("freeze", (freeze) => frozen.push(freeze));
  context.player.seek(10);
  pins.arm(true);
  dragging.grab("left-arm");
  dragging.nudge("left-arm", "ArrowUp", false);
  const targets = dragging.active!.targets.slice();
  pins.add();
  expect(dragging.active).toBeNull();
  const position = pointsOfControls(context.model!, context.document, targets)["left-arm"];
  expect(pins.here).toEqual([{ id: "n1", point: "left-arm", frame: 10, kind: "place", position }]);
  expect([pins.armed, pins.chosenPin]).toEqual([false, pins.here[0]]);
  expect(frozen).toEqual([{ frame: 10, playOn: false }]);
  await danced(context);
  expect(context.performance?.missed.worst[0]).toBeLessThan(1e-3);
  expect(said(context)).toEqual([]);
});

test("the selected point is pinned where it is; without one the next drag is armed", async () => {
  const { context, pins } = await pinning();
  pins.add();
  expect(pins.armed).toBe(true);
  pins.add();
  expect(pins.armed).toBe(false);
  context.selection.select("top");
  context.player.seek(5);
  pins.add();
  expect(pins.here).toMatchObject([{ point: "top", frame: 5, kind: "place" }]);
});

test("a pin is spoken of, made still, and taken away, which can be undone", async () => {
  const { context, pins } = await pinning();
  context.selection.select("top");
  context.player.seek(5);
  pins.add();
  context.player.seek(0);
  context.selection.select(null);
  pins.choose("n1");
  expect([context.player.frame, context.selection.point]).toEqual([5, "top"]);
  pins.setKind(pins.here[0], "still");
  expect(pins.here[0].kind).toBe("still");
  pins.remove("n1");
  expect([pins.here, pins.chosen]).toEqual([[], null]);
  expect(said(context)).toEqual(["The pin at frame 5 is gone."]);
  context.notices.all[0].actions[0].run();
  expect(pins.here).toHaveLength(1);
});

test("a pin keeps its point as high as its partner; without one as another point", async () => {
  const { context, pins } = await pinning();
  context.selection.select("left-arm");
  context.player.seek(12);
  pins.add();
  pins.setKind(pins.here[0], "level");
  expect(pins.here).toMatchObject([{ point: "left-arm", kind: "level", other: "right-arm" }]);
  await danced(context);
  expect(context.performance?.missed.worst[0]).toBeLessThan(1e-3);
  pins.remove("n1");
  context.selection.select("top");
  pins.add();
  pins.setKind(pins.here[0], "level");
  expect(pins.here).toMatchObject([{ point: "top", kind: "level", other: context.document.points.find(({ id }) => id !== "top")?.id }]);
});

test("two that contradict each other are told, by how much and which; and it is taken back", async () => {
  const { context, dragging, pins } = await pinning();
  context.selection.select("left-arm");
  context.player.seek(9);
  pins.add();
  context.player.seek(10);
  pins.add();
  pins.setKind(pins.here[1], "still");
  dragging.grab("left-arm");
  for (let k = 0; k < 30; k++) dragging.nudge("left-arm", "ArrowUp", false);
  dragging.drop();
  await danced(context);
  expect(said(context)).toEqual(["A pin is not kept."]);
  expect(context.notices.all[0].text).toMatch(/^The pin of Left arm at frame \d+ is missed by \d+ cm\. The pin of Left arm/);
  for (const { id } of [...pins.here]) pins.remove(id);
  await danced(context);
  expect(said(context)).not.toContain("A pin is not kept.");
});
