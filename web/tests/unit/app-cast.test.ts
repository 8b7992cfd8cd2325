import { expect, test } from "vitest";
import { Builtins } from "../../src/app/builtins";
import { Cast } from "../../src/app/cast";
import { newDocument } from "../../src/document/commands";
import { assets, emptyContext } from "./app-support";

const on = (file: string) => newDocument("Somebody", { file, facing: "+z", up: "+y" }, { files: [] });

test("ours and those that were opened; the next one goes around the end", () => {
  const { context } = emptyContext();
  const cast = new Cast(context, new Builtins(assets));
  expect(cast.presentName).toBe("");
  const ours = cast.list.map(({ file }) => file);
  expect(ours).toHaveLength(assets.characters.length);
  context.history.replace(on("cactus.glb"));
  expect(cast.presentName).toBe("Cactus");
  expect(cast.next?.file).toBe(ours[1]);
  context.history.replace(on(ours.at(-1) ?? ""));
  expect(cast.next?.file).toBe(ours[0]);
  context.history.replace(on("folder/box.obj"));
  expect(cast.list.at(-1)).toEqual({ file: "folder/box.obj", name: "box", character: null });
  expect(cast.presentName).toBe("Box");
});

test("whoever leaves keeps the project until they come back", () => {
  const { context } = emptyContext();
  const cast = new Cast(context, new Builtins(assets));
  const box = on("box.obj");
  context.history.replace(box);
  context.history.apply(() => on("cactus.glb"));
  expect(cast.remembered("box.obj")).toBe(box);
  expect(cast.list.map(({ file }) => file)).toContain("box.obj");
  expect(cast.remembered("cactus.glb")).toBeUndefined();
});
