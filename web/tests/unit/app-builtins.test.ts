import { expect, test } from "vitest";
import { Builtins } from "../../src/app/builtins";
import { parseProject } from "../../src/document/project";
import { normalPath } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { assets } from "./app-support";

const builtins = new Builtins(assets);

test("every character comes with its project and a model of as many vertices as it says", async () => {
  for (const character of builtins.characters) {
    const { document, bytes } = await builtins.load(character);
    expect(document.mesh.file).toBe(builtins.modelFile(character));
    expect(document.mesh.file).toMatch(/^[a-z]+\.glb$/);
    expect(document.motion.files.every((file) => !file.includes("/"))).toBe(true);
    const text = new TextDecoder().decode(await assets.load(normalPath(`characters/${character.project}`)));
    const { mesh, motion, ...parsed } = parseProject(text, "project.json").document;
    expect(document).toEqual({
      ...parsed,
      mesh: { ...mesh, file: document.mesh.file },
      motion: { files: motion.files.map((file) => file.replace(/.*\//, "")) },
    });
    const model = await readModel([{ name: document.mesh.file, bytes }]);
    expect(model.positions.length / 3).toBe(character.vertices);
  }
});

test("every motion can be read, and everything has a picture", async () => {
  for (const dance of builtins.motions) {
    expect(await builtins.motionText(dance.file)).toMatch(/^HIERARCHY/);
    expect(builtins.picture(dance)).toMatch(/\.webp$/);
  }
  for (const character of builtins.characters) expect(builtins.picture(character)).toMatch(/\.webp$/);
  expect(builtins.picture({ file: "nobody.bvh", name: "Nobody", seconds: 1 })).toBeNull();
});
