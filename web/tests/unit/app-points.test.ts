import { expect, test } from "vitest";
import { Points } from "../../src/app/points";
import { FLIGHTS } from "../../src/app/selection";
import { dancingContext, said } from "./app-support";

test("a point at a vertex, or the one that is there already", async () => {
  const { context } = await dancingContext();
  const points = new Points(context);
  const count = context.document.points.length;
  const id = points.add(100);
  expect(context.document.points).toHaveLength(count + 1);
  const [x, y, z] = context.model!.positions.subarray(300, 303);
  expect(context.document.points.at(-1)).toEqual({ id, name: `Point ${count + 1}`, position: [x, y, z], joint: null });
  expect(points.selected).toBe(id);
  expect(points.add(100)).toBe(id);
  expect(points.add(-1)).toBeNull();
  expect(context.document.points).toHaveLength(count + 1);
});

test("points are renamed, paired and taken away, which says so and can be undone", async () => {
  const { context } = await dancingContext();
  const points = new Points(context);
  const of = (id: string) => context.document.points.find((point) => point.id === id);
  expect(points.set("top", { name: "  Crown " })).toBe(true);
  expect(points.set("top", { name: " " })).toBe(false);
  expect(of("top")?.name).toBe("Crown");
  points.pair("top", null);
  expect(of("top")?.joint).toBeNull();
  const before = context.document;
  points.remove("top");
  expect(of("top")).toBeUndefined();
  expect(said(context)).toEqual(["Crown is gone."]);
  context.notices.all[0].actions[0].run();
  expect(context.document).toBe(before);
  context.selection.select(FLIGHTS);
  expect(points.selected).toBeNull();
});

test("each point tells which joint really moves it, by the name that people read", async () => {
  const { context } = await dancingContext();
  const points = new Points(context);
  const labels = () => context.document.points.map(({ id }, c) => [id, points.drivers[points.paired[c]]?.label]);
  expect(labels()).toContainEqual(["top", "Head"]);
  expect(labels()).toContainEqual(["left-arm", "Left hand"]);
  points.pair("top", "LeftForeArm");
  expect(labels()).toContainEqual(["top", "Left elbow"]);
  points.pair("top", null);
  expect(labels()).toContainEqual(["top", undefined]);
});
