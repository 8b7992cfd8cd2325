import { expect, test } from "vitest";
import { Sources } from "../../src/app/sources";
import { readModel } from "../../src/io/read-model";
import { Library } from "../../src/sync/library";
import { PNG, TETRAHEDRON, textFile } from "../support/files";
import { nod } from "./engine-support";

test("a model keeps its files; the same files again are the same model", async () => {
  const library = new Library();
  const sources = new Sources(library);
  const files = [textFile("tetra.obj", TETRAHEDRON), { name: "skin.png", bytes: PNG }];
  const model = await readModel(files.slice(0, 1));
  expect(sources.addModel("tetra.obj", model, files)).toBe("tetra.obj");
  expect(sources.of(model)?.model).toBe(model);
  expect(sources.of(model)?.files.map(({ name }) => name)).toEqual(["tetra.obj", "skin.png"]);
  expect(sources.addModel("tetra.obj", await readModel(files.slice(0, 1)), files)).toBe("tetra.obj");
  expect(library.model("tetra.obj")).toBe(model);
  const other = textFile("tetra.obj", TETRAHEDRON.replace("v 0 0 1", "v 0 0 2"));
  expect(sources.addModel("tetra.obj", await readModel([other]), [other])).toBe("tetra 2.obj");
});

test("a project is saved with the model's files and the texts of its motions, each once", async () => {
  const library = new Library();
  const sources = new Sources(library);
  const file = textFile("tetra.obj", TETRAHEDRON);
  const model = await readModel([file]);
  sources.addModel("tetra.obj", model, [file]);
  const motion = nod();
  const names = sources.addMotion(["nod.bvh"], motion);
  const other = sources.addMotion(["shake.bvh"], { ...motion, name: "shake.bvh" });
  const saved = sources.filesOf(model, [names, other, names]);
  expect(saved.map(({ name }) => name)).toEqual(["tetra.obj", "nod.bvh", "shake.bvh"]);
  expect(new TextDecoder().decode(saved[1].bytes)).toBe(motion.text);
});
