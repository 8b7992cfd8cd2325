import { expect, test } from "vitest";
import { Builtins } from "../../src/app/builtins";
import { Motions } from "../../src/app/motions";
import { newDocument, setMotion } from "../../src/document/commands";
import { assets, emptyContext } from "./app-support";
import { nod } from "./engine-support";

test("built-in motions and those that were opened; the next one goes around the end", () => {
  const { context } = emptyContext();
  const motions = new Motions(context, new Builtins(assets));
  const [first, second] = assets.motions;
  context.history.replace(newDocument("A", { file: "", facing: "+z", up: "+y" }, { files: [first.file] }));
  expect(motions.list).toHaveLength(assets.motions.length);
  expect(motions.list.filter((entry) => motions.isPlaying(entry)).map(({ name }) => name)).toEqual([first.name]);
  expect(motions.next?.files).toEqual([second.file]);
  context.history.apply(setMotion({ files: [assets.motions.at(-1)?.file ?? ""] }));
  expect(motions.next?.files).toEqual([first.file]);
  context.workspace.library.addMotion(["nod.bvh"], nod());
  context.workspace.library.addMotion([first.file], { name: first.file, text: "as built in" });
  expect(motions.list.slice(assets.motions.length)).toEqual([{ files: ["nod.bvh"], builtin: false, name: "nod" }]);
});
