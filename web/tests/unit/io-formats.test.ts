import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

import { accepted, FORMATS, formatNamed, formatOf, listed } from "../../src/io/formats";
import { findMotions } from "../../src/io/read-motion-files";
import { sortFiles } from "../../src/io/sort-files";
import { textFile } from "../support/files";

const text = (path: string): string => readFileSync(new URL(`../../../${path}`, import.meta.url), "utf8");

it("each ending belongs to one format", () => {
  const endings = FORMATS.flatMap(({ extensions }) => extensions);
  expect(new Set(endings).size).toBe(endings.length);
  expect(new Set(FORMATS.map(({ id }) => id)).size).toBe(FORMATS.length);
});

it("dialogs and sentences name every format of a kind", () => {
  expect(accepted(["motion", "skeleton"])).toBe(".gltf,.glb,.vrm,.vrma,.fbx,.bvh,.amc,.asf");
  expect(accepted(["model"])).toBe(".obj,.off,.ply,.stl,.gltf,.glb,.vrm,.vrma,.fbx,.dae,.3mf,.usdz,.usda,.usdc,.usd");
  expect(listed("model", "or")).toBe("OBJ, OFF, PLY, STL, glTF, GLB, FBX, DAE, 3MF or USDZ");
  expect(listed("motion", "or")).toBe("BVH, ASF with AMC, glTF, GLB or FBX");
});

it("README and docs name every model and motion", () => {
  for (const path of ["README.md", "docs/project-format.md"]) {
    const words = FORMATS.flatMap((format) => (["model", "motion", "skeleton"].includes(format.kind) ? [format.words] : []));
    expect(words.filter((word) => !new RegExp(`\\b${word}\\b`).test(text(path)))).toEqual([]);
  }
  expect(text("README.md")).toContain(`drop an ${listed("model", "or")} file`);
  expect(text("docs/project-format.md")).toContain(listed("model", "or"));
});

it("a file is what it says, else what it is called; an archive is one or is none", () => {
  const id = (name: string, content: string): string | undefined => formatOf(textFile(name, content))?.id;
  expect(id("a.obj", "glTF....")).toBe("glb");
  expect(id("a.txt", "ply\nformat ascii 1.0\n")).toBe("ply");
  expect(id("a", "OFF\n")).toBe("off");
  expect(id("a.txt", "HIERARCHY\nROOT a")).toBe("bvh");
  expect(id("a.bvh", ":bonedata")).toBe("asf");
  expect(id("a", "x\n:DEGREES\n")).toBe("amc");
  expect(id("a.json", "PK\u0003\u0004")).toBe("zip");
  expect(id("a.zip", "no zip")).toBeUndefined();
  expect(id("A.OBJ", "v 0 0 0")).toBe("obj");
  expect(formatNamed("a/b.rigless")?.kind).toBe("archive");
});

it("sides of a drop come from the table alone", async () => {
  for (const { kind, extensions } of FORMATS) {
    const { models, project, problems } = await sortFiles([textFile(`a.${extensions[0]}`, "nothing of its kind")]);
    expect([kind, models.length]).toEqual([kind, kind === "model" ? 1 : 0]);
    expect([kind, project !== null]).toEqual([kind, kind === "project"]);
    if (kind === "picture" || kind === "part") expect(problems[0]).toContain("belongs to a model");
  }
  const { motions } = await findMotions([
    textFile("a.amc", ":degrees\n"),
    textFile("a.asf", ":bonedata\n"),
    textFile("b.bvh", "HIERARCHY"),
  ]);
  expect(motions.map(({ files, input }) => [input.skeleton?.name, ...files])).toEqual([
    ["a.asf", "a.asf", "a.amc"],
    [undefined, "b.bvh"],
  ]);
});
