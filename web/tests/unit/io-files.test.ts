import { zipSync } from "fflate";
import { describe, expect, it } from "vitest";

import { newDocument } from "../../src/document/commands";
import { DocumentError, serializeProject } from "../../src/document/project";
import { baseName, decodeText, findFile, type NamedFile } from "../../src/io/named-file";
import { openProject, projectFileName, saveProject } from "../../src/io/project-file";
import { findMotions } from "../../src/io/read-motion-files";
import { sortFiles } from "../../src/io/sort-files";
import { unzip, zip } from "../../src/io/zip";
import { PNG, TETRAHEDRON, textFile } from "../support/files";

const BVH = "HIERARCHY\nROOT Hips\n{\n}\nMOTION\n";
const ASF = "# comment\n:version 1.10\n:name VICON\n:root\n:bonedata\n";
const AMC = "#!OML:ASF walk.asf\n:FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0\n";

const junk = (name: string): NamedFile => ({ name, bytes: Uint8Array.from([1, 0, 2, 0, 255]) });
const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

async function refusal(act: () => unknown): Promise<string> {
  try {
    await act();
  } catch (error) {
    expect(error).toBeInstanceOf(DocumentError);
    return (error as DocumentError).message;
  }
  throw new Error("was accepted");
}

describe("motions among files", () => {
  it("pairs ASF and AMC in either order, each AMC with the skeleton of its name", async () => {
    const files = [
      textFile("07_05.amc", AMC),
      textFile("02.asf", ASF),
      textFile("a/02_01.amc", AMC),
      textFile("07.asf", ASF),
      textFile("hop.bvh", BVH),
    ];
    const { motions, problems } = await findMotions(files);
    expect(problems).toEqual([]);
    expect(motions.map((motion) => motion.files)).toEqual([["07.asf", "07_05.amc"], ["02.asf", "a/02_01.amc"], ["hop.bvh"]]);
    expect(motions[1].input).toEqual({ name: "02_01.amc", text: AMC, skeleton: { name: "02.asf", text: ASF } });
    expect(motions[2].input).toEqual({ name: "hop.bvh", text: BVH });
  });

  it("an AMC without its ASF takes one that is at hand", async () => {
    const { motions, problems } = await findMotions([textFile("02_02.amc", AMC)], [textFile("01.asf", "x"), textFile("02.asf", ASF)]);
    expect([motions.map((motion) => motion.files), problems]).toEqual([[["02.asf", "02_02.amc"]], []]);
    const own = await findMotions([textFile("02_02.amc", AMC), textFile("b.asf", ASF)], [textFile("a.asf", ASF)]);
    expect(own.motions.map((motion) => motion.files)).toEqual([["b.asf", "02_02.amc"]]);
  });

  it("says what is missing", async () => {
    expect((await findMotions([textFile("02_01.amc", AMC)])).problems).toEqual(["02_01.amc needs its skeleton: drop the .asf with it."]);
    expect((await findMotions([textFile("02.asf", ASF)])).problems).toEqual([
      "02.asf is a skeleton without a motion: drop an .amc with it.",
    ]);
    expect(await findMotions([junk("hop.bvh")])).toEqual({ motions: [], problems: ["hop.bvh is not text, so it is no BVH file."] });
    expect(await findMotions([textFile("hop.bvh", " \n")])).toEqual({ motions: [], problems: ["hop.bvh is empty, so it is no BVH file."] });
  });

  it("goes by what a file says before its name, and reads UTF-16", async () => {
    const wide = Uint8Array.from([0xff, 0xfe, ...[...BVH].flatMap((letter) => [letter.charCodeAt(0), 0])]);
    expect(
      (await findMotions([textFile("hop.txt", BVH), { name: "wide.bvh", bytes: wide }])).motions.map(({ input }) => [
        input.name,
        input.text,
      ]),
    ).toEqual([
      ["hop.txt", BVH],
      ["wide.bvh", BVH],
    ]);
    expect(decodeText(new TextEncoder().encode("\ufeffhé"))).toBe("hé");
  });
});

describe("one drop of many files", () => {
  it("is sorted, and what is unknown is named", async () => {
    const inner = zipSync({ "dance/hop.bvh": new TextEncoder().encode(BVH), "__MACOSX/x": PNG, "dance/.DS_Store": PNG });
    const sorted = await sortFiles([
      textFile("cow.obj", TETRAHEDRON),
      { name: "cow.png", bytes: PNG },
      textFile("cow.mtl", ""),
      { name: "hop.zip", bytes: inner },
      textFile("letter.docx", "hello"),
      textFile("02_01.amc", AMC),
    ]);
    expect(sorted.project).toBeNull();
    expect(sorted.models.map((file) => file.name)).toEqual(["cow.obj"]);
    expect(sorted.motions.map((motion) => motion.files)).toEqual([["dance/hop.bvh"]]);
    expect(sorted.files.map((file) => file.name)).toEqual(["cow.obj", "cow.png", "cow.mtl", "dance/hop.bvh", "letter.docx", "02_01.amc"]);
    expect(sorted.problems).toEqual([
      "02_01.amc needs its skeleton: drop the .asf with it.",
      "letter.docx is nothing that Rigless opens. Models: OBJ, OFF, PLY, STL, glTF, GLB, FBX, DAE, 3MF, USDZ. " +
        "Motions: BVH, ASF with AMC, glTF, GLB, FBX.",
    ]);
  });

  it.each(["walk.c3d", "walk.trc", "amass.npz", "dance.mp4", "dance.vmd"])("%s gets one sentence that names the way", async (name) => {
    const { problems, motions, models } = await sortFiles([junk(name)]);
    expect([motions, models, problems.length]).toEqual([[], [], 1]);
    expect(problems[0]).toMatch(new RegExp(`^${name} is .+\\. .*(BVH|FBX|glTF)`));
  });

  it("a picture alone belongs to a model", async () => {
    expect((await sortFiles([{ name: "cow.png", bytes: PNG }])).problems).toEqual(["cow.png belongs to a model: drop both together."]);
  });
});

describe("project files", () => {
  const document = newDocument("my: cow", { file: "cow.obj", facing: "+x", up: "+y" }, { files: ["02.asf", "02_01.amc"] });
  const files = [textFile("cow.obj", TETRAHEDRON), textFile("02.asf", ASF), textFile("02_01.amc", AMC), { name: "cow.png", bytes: PNG }];

  it("come back as they went, and the same project gives the same bytes", async () => {
    const saved = saveProject(document, files);
    const opened = await openProject([{ name: "cow.rigless", bytes: saved }]);
    expect(opened.document).toEqual(document);
    expect(opened.modelFiles[0].name).toBe("cow.obj");
    expect(text(opened.modelFiles[0].bytes)).toBe(TETRAHEDRON);
    expect(opened.modelFiles.map((file) => file.name)).toContain("cow.png");
    expect(opened.motion).toEqual({ name: "02_01.amc", text: AMC, skeleton: { name: "02.asf", text: ASF } });
    expect(saveProject(document, files)).toEqual(saved);
    expect(projectFileName(document)).toBe("my cow.rigless");
  });

  it("opens project.json among its files, in a folder too", async () => {
    const loose = [
      textFile("a/project.json", serializeProject(document)),
      ...files.map(({ name, bytes }) => ({ name: `a/${name}`, bytes })),
    ];
    expect((await openProject(loose)).modelFiles[0].name).toBe("a/cow.obj");
  });

  it("never names a file outside itself", async () => {
    const outside = { ...document, mesh: { ...document.mesh, file: "../models/cow.obj" } };
    const saved = saveProject(outside, [{ ...files[0], name: "../models/cow.obj" }, ...files.slice(1)]);
    expect(unzip({ name: "x.rigless", bytes: saved }).map((file) => file.name)).toEqual([
      "project.json",
      "models/cow.obj",
      "02.asf",
      "02_01.amc",
      "cow.png",
    ]);
    expect((await openProject([{ name: "x.rigless", bytes: saved }])).document.mesh.file).toBe("models/cow.obj");
  });

  it("say what is missing", async () => {
    expect(await refusal(() => saveProject(document, files.slice(1)))).toBe("The project names cow.obj, which is not with it.");
    const json = textFile("project.json", serializeProject(document));
    expect(await refusal(async () => await openProject([json, files[0], files[1]]))).toBe(
      "project.json names 02_01.amc, which is not with it.",
    );
    expect(await refusal(async () => await openProject([files[0]]))).toBe("cow.obj holds no project.json.");
    const noModel = textFile("project.json", serializeProject({ ...document, mesh: { ...document.mesh, file: "02.asf" } }));
    expect(await refusal(async () => await openProject([noModel, ...files]))).toBe(
      "project.json names 02.asf, which is no model (OBJ, OFF, PLY, STL, glTF, GLB, FBX, DAE, 3MF, USDZ).",
    );
    const two = textFile("project.json", serializeProject({ ...document, motion: { files: ["02.asf"] } }));
    expect(await refusal(async () => await openProject([two, ...files]))).toBe(
      "project.json: 02.asf is a skeleton without a motion: drop an .amc with it.",
    );
  });
});

describe("zips from strangers", () => {
  it.each(["../evil.obj", "a/../../evil.obj", "/etc/evil.obj", "C:\\evil.obj", "..\\evil.obj"])("%s does not get out", async (path) => {
    const evil = { name: "evil.zip", bytes: zipSync({ [path]: PNG }) };
    expect(await refusal(() => unzip(evil))).toContain("evil.zip holds a file whose path leads out of it");
  });

  it("a bomb is not unpacked", async () => {
    const bomb = zipSync({ "a.obj": new Uint8Array(1e6) });
    const view = new DataView(bomb.buffer);
    const central = view.getUint32(bomb.length - 6, true);
    view.setUint32(central + 24, 600e6, true); // what it says it holds
    expect(await refusal(() => unzip({ name: "bomb.zip", bytes: bomb }))).toBe(
      "bomb.zip would unpack to more than 512 MB. We did not open it.",
    );
    view.setUint32(central + 24, 10, true); // a lie: no more than that is written
    expect(unzip({ name: "bomb.zip", bytes: bomb })[0].bytes.length).toBe(10);
    const many = zipSync(Object.fromEntries(Array.from({ length: 1001 }, (_, n) => [`${n}.obj`, new Uint8Array(0)])));
    expect(await refusal(() => unzip({ name: "many.zip", bytes: many }))).toBe(
      "many.zip would unpack to more than 1,000 files. We did not open it.",
    );
  });

  it("one that is cut short is named", async () => {
    const whole = zip([textFile("a.obj", TETRAHEDRON)]);
    expect(await refusal(() => unzip({ name: "cut.zip", bytes: whole.subarray(0, 60) }))).toMatch(/^cut\.zip is a broken zip: /);
  });
});

it("finds a file by its path seen from another, else by its name", async () => {
  const files = [textFile("a/b/cow.obj", ""), textFile("a/Wood.PNG", ""), textFile("cow.obj", "")];
  expect(findFile(files, "cow.obj", "a/b/project.json")).toBe(files[0]);
  expect(findFile(files, "./cow.obj")).toBe(files[2]);
  expect(findFile(files, "tex\\wood.png", "a/b/x.mtl")).toBe(files[1]);
  expect(findFile(files, "pig.obj")).toBeUndefined();
  expect(baseName("a\\b\\c.obj")).toBe("c.obj");
});
