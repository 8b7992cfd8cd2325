import { expect, test } from "vitest";
import { ModelSettings } from "../../src/app/model-settings";
import { ProjectSettings } from "../../src/app/project-settings";
import { emptyContext } from "./app-support";

test("a slider's travel is one step", () => {
  const { context } = emptyContext();
  const settings = new ProjectSettings(context);
  for (const volume of [1.2, 1.6, 2]) settings.set("volume", volume, true);
  settings.set("volume", 2.1, false);
  settings.set("volume", 2.5, true);
  settings.set("volume", 2.6, false);
  expect(context.document.settings.volume).toBe(2.6);
  context.history.undo();
  expect(context.document.settings.volume).toBe(2.1);
  context.history.undo();
  expect(context.document.settings.volume).toBe(1);
});

test("the name and how the model stands", () => {
  const { context } = emptyContext();
  const settings = new ProjectSettings(context);
  settings.rename("Disco");
  expect(context.document.name).toBe("Disco");
  const model = new ModelSettings(context);
  model.turn();
  expect(context.document.mesh).toMatchObject({ facing: "+x", up: "+y" });
  model.setUp("+x");
  expect(context.document.mesh.up).toBe("+x");
  expect(context.document.mesh.facing[1]).not.toBe("x");
});
