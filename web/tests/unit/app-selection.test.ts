import { expect, test } from "vitest";
import { FLIGHTS } from "../../src/app/selection";
import { newDocument } from "../../src/document/commands";
import { emptyContext, listen } from "./app-support";

test("a point is selected until it is gone; the row of flights stays", () => {
  const { context } = emptyContext();
  const { selection } = context;
  const told = listen(context, "selection");
  selection.select("a");
  selection.select("a");
  expect(told).toEqual(["selection"]);
  const point = { id: "a", name: "A", position: [0, 0, 0] as const, joint: null };
  const document = { ...newDocument("A", { file: "", facing: "+z", up: "+y" }, { files: [] }), points: [point] };
  selection.follow(document);
  expect(selection.point).toBe("a");
  selection.follow({ ...document, points: [] });
  expect(selection.point).toBeNull();
  selection.select(FLIGHTS);
  selection.follow({ ...document, points: [] });
  expect(selection.point).toBe(FLIGHTS);
});

test("panel, layout, intro and help each tell their topic", () => {
  const { context } = emptyContext();
  const { selection } = context;
  const told = listen(context, "panel", "layout", "intro", "help");
  selection.togglePanel("poses");
  expect(selection.panel).toBe("poses");
  selection.togglePanel("points");
  selection.togglePanel("points");
  expect(selection.panel).toBeNull();
  selection.setLayout("overlay");
  selection.beginIntro();
  selection.endIntro();
  selection.endIntro();
  selection.setHelp(true);
  selection.setHelp(true);
  expect([selection.layout, selection.intro, selection.help]).toEqual(["overlay", false, true]);
  expect(told).toEqual(["panel", "panel", "panel", "layout", "intro", "intro", "help"]);
});
