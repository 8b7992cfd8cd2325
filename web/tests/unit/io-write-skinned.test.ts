import { validateBytes } from "gltf-validator";
import { AnimationMixer, type SkinnedMesh, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { expect, it } from "vitest";

import { buildSkinInNode } from "../../src/engine/skin-node";
import type { BuiltSkin } from "../../src/engine/types";
import type { Model } from "../../src/io/model";
import { type GlbInput, keptFrames } from "../../src/io/write-glb";
import { writeSkinned } from "../../src/io/write-skinned";
import { laidOn, openGlb, valuesOf } from "../support/gltf";
import { bent, HEIGHT, post } from "../support/post";

async function made(
  model: Model,
  frames: number,
  more: Partial<GlbInput> = {},
  joints = 64,
): Promise<{ input: GlbInput; skin: BuiltSkin; glb: Uint8Array<ArrayBuffer> }> {
  const input: GlbInput = {
    name: "my dance",
    ...{ document: model.document, drawn: model.drawn, faces: model.faces, rest: model.positions },
    places: [
      { name: "Left hand", position: [0, 2, 0] },
      { name: "Base", position: [0, 0, 0] },
    ],
    clips: [{ name: "my dance", frames: bent(model, frames) }],
    ...{ fps: 30, scale: 1, every: 1 },
    ...more,
  };
  const skin = await buildSkinInNode({
    positions: input.rest,
    faces: input.faces,
    frames: input.clips.flatMap(({ frames }) => frames.map((f) => f.positions)),
    joints,
  });
  return { input, skin, glb: writeSkinned(input, skin) };
}

/** The largest way between what three.js plays and the frames, in diagonals of the model at rest. */
async function played(glb: Uint8Array<ArrayBuffer>, model: Model, { clips, fps, every, scale }: GlbInput): Promise<number> {
  const { scene, animations } = await new GLTFLoader().parseAsync(glb.buffer, "");
  const meshes: SkinnedMesh[] = [];
  scene.traverse((object) => void ("isSkinnedMesh" in object && meshes.push(object as SkinnedMesh)));
  expect(meshes).toHaveLength(model.drawn.instances.length);
  const mixer = new AnimationMixer(scene);
  expect(animations).toHaveLength(clips.length);
  let worst = 0;
  clips.forEach(({ frames }, c) => {
    mixer.stopAllAction();
    mixer.clipAction(animations[c]).play();
    for (const f of keptFrames(frames.length, every)) {
      mixer.setTime(Math.min(f / fps, animations[c].duration - 1e-7));
      scene.updateMatrixWorld(true);
      meshes.forEach((mesh, m) => {
        mesh.skeleton.update();
        const { first, count } = model.drawn.instances[m];
        for (let r = 0; r < count; r++) {
          const at = mesh.getVertexPosition(r, new Vector3()).divideScalar(scale);
          const v = 3 * model.drawn.toVertex[first + r];
          const wanted = frames[f].positions;
          worst = Math.max(worst, at.distanceTo(new Vector3(wanted[v], wanted[v + 1], wanted[v + 2])));
        }
      });
    }
  });
  return worst / Math.hypot(0.4, HEIGHT, 0.4);
}

it("is faultless, and plays every frame in three.js as like as it says", async () => {
  const model = await post();
  const { input, skin, glb } = await made(model, 40);
  expect(skin.rms).toBeLessThanOrEqual(0.0013);
  expect(skin.worst).toBeLessThanOrEqual(0.008);
  const { issues } = await validateBytes(glb);
  expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const worst = await played(glb, model, input);
  expect(Math.abs(worst - skin.worst)).toBeLessThan(2e-4);
});

it("holds by morph targets what its joints cannot, and plays that too", async () => {
  const model = await post();
  const squashed = bent(model, 40).map(({ positions }, f) => ({
    positions: positions.map((x, i) => (i % 3 === 1 ? x + 0.2 * Math.sin(0.9 * f) * Math.sin(6 * model.positions[i]) : x)),
  }));
  const { input, skin, glb } = await made(model, 0, { clips: [{ name: "squash", frames: squashed }] }, 4);
  expect(skin.centres).toHaveLength(12);
  expect((await validateBytes(glb)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const { meshes = [], animations = [] } = (await openGlb(glb)).json;
  expect(meshes[0].weights?.length).toBeGreaterThan(0);
  expect(JSON.stringify(animations[0].channels)).toContain('"weights"');
  expect(Math.abs((await played(glb, model, input)) - skin.worst)).toBeLessThan(2e-4);
});

it("plays every frame of all clips by one skeleton", async () => {
  const model = await post();
  const clips = [
    { name: "slow bow", frames: bent(model, 30).map((frame, f, all) => (f % 2 === 0 ? all[f / 2] : frame)) },
    { name: "wave", frames: bent(model, 50).slice(20) },
    { name: "nothing", frames: [] },
    { name: "wave", frames: bent(model, 8) },
  ];
  const filled = clips.filter(({ frames }) => frames.length > 0);
  const { input, skin, glb } = await made(model, 0, { clips, fps: 60 });
  expect((await validateBytes(glb)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const { skins, animations = [] } = (await openGlb(glb)).json;
  expect(skins).toHaveLength(1);
  expect(animations.map(({ name }) => name)).toEqual(["slow_bow", "wave", "wave_2"]);
  expect(Math.abs((await played(glb, model, { ...input, clips: filled })) - skin.worst)).toBeLessThan(2e-4);
});

it("keeps kept frames alone, and the model's own size", async () => {
  const model = await post();
  const { input, skin, glb } = await made(model, 21, { every: 4, scale: 100 });
  expect(await played(glb, model, input)).toBeLessThan(skin.worst + 2e-4);
  const written = await openGlb(glb);
  expect(written.json.accessors![written.json.animations![0].samplers[0].input].count).toBe(6);
});

it("keeps materials, pictures and their places", async () => {
  const model = await post(true);
  const written = await openGlb((await made(model, 5)).glb);
  expect(written.images).toEqual(model.document.images);
  expect(written.json.materials).toEqual(model.document.json.materials);
  expect(valuesOf(written, "TEXCOORD_0")).toEqual(laidOn(model, "TEXCOORD_0", 2));
});

it("names joints after the places that they are nearest to, and flat under one root", async () => {
  const model = await post();
  const { skin, glb } = await made(model, 30);
  const { nodes = [], skins = [], animations = [] } = (await openGlb(glb)).json;
  const names = skins[0].joints.map((n) => nodes[n].name ?? "");
  expect(names).toHaveLength(skin.centres.length / 3);
  expect(new Set(names).size).toBe(names.length);
  for (const name of names) expect(name).toMatch(/^(Left_hand|Base)(_\d+)?$/);
  expect(nodes[skins[0].skeleton!]).toMatchObject({ name: "root", children: skins[0].joints });
  expect(animations.map(({ name }) => name)).toEqual(["my_dance"]);
});

it("has tracks only for what moves", async () => {
  const model = await post();
  const rest = { positions: model.positions };
  const { skin, glb } = await made(model, 0, {
    clips: [{ name: "step", frames: [rest, { positions: model.positions.map((x, i) => (i % 3 === 0 ? x + 1 : x)) }] }],
  });
  expect(skin.centres).toHaveLength(3);
  expect((await openGlb(glb)).json.animations![0].channels).toEqual([{ sampler: 0, target: { node: 1, path: "translation" } }]);
});

it("ends on abort, and says what is no mesh", async () => {
  const model = await post();
  const task = { positions: model.positions, faces: model.faces, frames: bent(model, 10).map((f) => f.positions), joints: 64 };
  const stop = new AbortController();
  await expect(buildSkinInNode(task, { signal: stop.signal, onProgress: () => stop.abort() })).rejects.toMatchObject({
    name: "AbortError",
  });
  const bad = { ...task, frames: [model.positions.with(4, NaN)] };
  await expect(buildSkinInNode(bad)).rejects.toMatchObject({ code: "bad_mesh" });
});
