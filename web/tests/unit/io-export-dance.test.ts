import { expect, it } from "vitest";

import { type Dance, everyFor, exportDance, sizeFault, sayReplaced } from "../../src/io/export-dance";
import { ModelError } from "../../src/io/named-file";
import type { Profile } from "../../src/io/profile";
import { buildMorphsInNode, buildSkinInNode } from "../../src/engine/skin-node";
import { PROFILES } from "../../src/io/profiles";
import { readModel } from "../../src/io/read-model";
import { type GlbInput, keptFrames, writeGlb } from "../../src/io/write-glb";
import { TETRAHEDRON, textFile } from "../support/files";

const [, , morph] = PROFILES;
const tools = { buildSkin: buildSkinInNode, buildMorphs: buildMorphsInNode };
const model = await readModel([textFile("t.obj", TETRAHEDRON)]);
const frames = Array.from({ length: 5 }, (_, f) => ({ positions: model.positions.map((x) => x + f) }));
const dance: Dance = { name: "wave", model, mesh: { file: "t.obj", up: "+y", facing: "+z" }, clips: [{ name: "wave", frames }] };

it("keeps as many frames as every viewer takes, and no fewer than needed", () => {
  const { mostKept } = morph;
  for (const length of [1, 2, 120, 255, 256, 257, 510, 511, 512, 5000]) {
    const every = everyFor([length], morph);
    expect(keptFrames(length, every).length).toBeLessThanOrEqual(mostKept ?? Infinity);
    if (every > 1) expect(keptFrames(length, every - 1).length).toBeGreaterThan(mostKept ?? Infinity);
  }
  expect(everyFor([5000], PROFILES[0])).toBe(1);
});

it("writes by the profile that is asked for: the model at rest on the stage, in its own size", async () => {
  const seen: GlbInput[] = [];
  const dummy: Profile = {
    ...morph,
    id: "dummy",
    write: (input) => {
      seen.push(input);
      return Promise.resolve({ bytes: Uint8Array.of(1, 2, 3), likeness: null });
    },
  };
  expect((await exportDance(dance, 2, tools, dummy)).bytes).toEqual(Uint8Array.of(1, 2, 3));
  expect(seen[0]).toMatchObject({ name: "wave", every: 2, fps: 30, clips: dance.clips, document: model.document });
  expect(seen[0].drawn.toVertex).toBe(model.drawn.toVertex);
  expect(Math.max(...seen[0].rest.filter((_, i) => i % 3 === 1))).toBeCloseTo(1.7, 5);
  expect(seen[0].scale * 1.7).toBeCloseTo(1, 5); // the tetrahedron is 1 tall in its file
  expect((await exportDance(dance, 2, tools, morph)).bytes).toEqual(writeGlb(seen[0]));
});

it("does not begin a file that is too large to be one", async () => {
  const heavy: Profile = { ...morph, mostBytes: PROFILES[0].mostBytes, bytes: (vertices, kept) => (vertices / 3) * kept * 2e8 };
  expect(sizeFault(model, [5], 1, morph)).toBeNull();
  expect(sizeFault(model, [5], 1, heavy)).toEqual({ text: "would hold 4.0 GB, more than a GLB can", every: 4 });
  const exact: Profile = { ...heavy, mostBytes: morph.mostBytes, bytes: (vertices, kept) => (vertices / 3) * kept * 2e7 };
  expect(sizeFault(model, [5], 1, exact)).toEqual({ text: "would hold 400 MB, more than the 200 MB that viewers open", every: 4 });
  await expect(exportDance(dance, 1, tools, heavy)).rejects.toThrow(new ModelError("wave.glb would hold 4.0 GB, more than a GLB can."));
});

it("what of the model's own file makes way is told: its skeleton, its clips, or nothing", () => {
  const told = (json: object) => sayReplaced({ document: { json } } as unknown as Parameters<typeof sayReplaced>[0]);
  expect(told({})).toBeNull();
  expect(told({ skins: [{}] })).toBe("The model's own skeleton is replaced.");
  expect(told({ animations: [{}] })).toBe("The model's own clip is replaced.");
  expect(told({ animations: [{}, {}] })).toBe("The model's own 2 clips are replaced.");
  expect(told({ skins: [{}], animations: [{}] })).toBe("The model's own skeleton and clip are replaced.");
});
