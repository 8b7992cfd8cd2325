import { readFileSync } from "node:fs";
import { validateBytes } from "gltf-validator";
import { expect, it } from "vitest";
import { newDocument } from "../../src/document/commands";
import type { Frame } from "../../src/engine/types";
import { buildMorphsInNode, buildSkinInNode } from "../../src/engine/skin-node";
import { type DanceBeside, exportDuet, framesBeside } from "../../src/io/export-duet";
import { PROFILES } from "../../src/io/profiles";
import { readModel } from "../../src/io/read-model";
import { stageFor } from "../../src/sync/placement";
import { meshInput } from "../../src/sync/translate";
import { openGlb, valuesOf } from "../support/gltf";

const [game, cartoon, exact] = PROFILES;
const tools = { buildSkin: buildSkinInNode, buildMorphs: buildMorphsInNode };
const read = (file: string) => {
  const bytes = new Uint8Array(readFileSync(new URL(`../../assets/${file}`, import.meta.url)));
  return readModel([{ name: file.replace(/^.*\//, ""), bytes }]);
};
const mesh = { file: "x.glb", up: "+y", facing: "+z" } as const;
const [cactus, lamp] = await Promise.all([read("cactus/cactus.glb"), read("characters/lamp/lamp.glb")]);

/** Goes forward by a centimetre a frame and bends. */
const walk = (model: typeof cactus, count: number): Frame[] => {
  const rest = meshInput(model, mesh).positions;
  return Array.from({ length: count }, (_, f) => ({
    positions: rest.map((value, i) => value + (i % 3 === 2 ? 0.01 * f : i % 3 === 0 ? 0.01 * f * rest[i + 1] : 0)),
    root: [0, 0, 0.01 * f, 0],
    volumeRatio: 1,
    milliseconds: 1,
  }));
};

const beside = (count: number, seconds = 0, loop = false): DanceBeside => ({
  document: { ...newDocument("Lamp", mesh, { files: ["w.bvh"] }), ...(loop && { clips: { "w.bvh": { loop } } }) },
  offset: { seconds, place: [2, -1], yaw: Math.PI / 2 },
  model: lamp,
  name: "Lamp",
  frames: walk(lamp, count),
});

it.each([game, cartoon, exact])("$name: both models with their pictures, and one clip that moves both", async (profile) => {
  const frames = walk(cactus, 6);
  const hand = { name: "Cactus", model: cactus, mesh, clips: [{ name: "Cactus", frames }] };
  const { bytes, likeness } = await exportDuet(hand, frames, beside(6), 1, tools, profile);
  expect((await validateBytes(bytes)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const document = await openGlb(bytes);
  const { json } = document;
  expect(json.meshes).toHaveLength(2);
  expect(json.images?.length ?? 0).toBe((cactus.document.json.images?.length ?? 0) + (lamp.document.json.images?.length ?? 0));
  expect(json.materials?.length).toBe((cactus.document.json.materials?.length ?? 0) + (lamp.document.json.materials?.length ?? 0));
  expect(json.animations?.map(({ name }) => name)).toEqual(["Cactus"]);
  const moved = new Set((json.animations?.[0].channels as { target: { node: number } }[]).map(({ target }) => target.node));
  expect(json.nodes?.filter(({ mesh: shown }, n) => shown !== undefined && profile !== game && !moved.has(n))).toEqual([]);
  const place = json.nodes?.find(({ name }) => name === "Lamp_place");
  const metre = 1 / stageFor(cactus, mesh).scale;
  expect(place?.translation?.map((value) => value / metre)).toEqual([2, 0, -1].map((value) => expect.closeTo(value, 5)));
  expect(place?.rotation).toEqual([0, expect.closeTo(Math.SQRT1_2), 0, expect.closeTo(Math.SQRT1_2)]);
  if (likeness) expect(likeness.worst).toBeLessThan(0.02);

  // The second one is as large as the stage has it, in units of the first.
  const rest = meshInput(lamp, mesh).positions;
  const height = (values: ArrayLike<number>): number => Math.max(...Array.from(values).filter((_, i) => i % 3 === 1));
  expect(height(valuesOf(document, "POSITION", { mesh: 1 }) ?? []) / metre).toBeCloseTo(height(rest), 4);
});

it("the second one's frames are as long as the first dance, later or earlier, round after round", () => {
  const firsts = (of: DanceBeside, length: number): number[] =>
    framesBeside(of, 30, length).map(({ positions }) => Math.round(100 * (positions[2] - of.frames[0].positions[2])));
  expect(firsts(beside(4), 6)).toEqual([0, 1, 2, 3, 3, 4]); // begins anew where it came to
  expect(firsts(beside(4, 0.1), 6)).toEqual([0, 0, 0, 0, 1, 2]);
  expect(firsts(beside(4, -0.1), 3)).toEqual([3, 3, 4]);
  expect(firsts(beside(4, 1 / 30, true), 5)).toEqual([-1, 0, 1, 2, 3]);
  expect(framesBeside(beside(4), 60, 3)).toHaveLength(3);
});
