import { validateBytes } from "gltf-validator";
import { AnimationMixer, type Mesh, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { expect, it } from "vitest";

import { buildMorphsInNode, buildSkinInNode } from "../../src/engine/skin-node";
import { sayLikeness } from "../../src/io/export-dance";
import type { Model } from "../../src/io/model";
import type { Likeness } from "../../src/io/profile";
import { cartoonMorphs } from "../../src/io/profiles/cartoon-morphs";
import { gameCharacter } from "../../src/io/profiles/game-character";
import { morphTargets } from "../../src/io/profiles/morph-targets";
import { type Clip, type GlbInput, keptFrames } from "../../src/io/write-glb";
import { Shapes } from "../../src/io/drawn-shape";
import { openGlb } from "../support/gltf";
import { bent, HEIGHT, post } from "../support/post";

const tools = { buildSkin: buildSkinInNode, buildMorphs: buildMorphsInNode };

/** It bulges and flattens while it bends, goes and turns. */
function squashed(model: Model, frames: number): { positions: Float32Array }[] {
  const bulged = (f: number): Model => ({
    ...model,
    positions: model.positions.map((x, i) => x * (i % 3 === 1 ? 1 - 0.2 * Math.sin(0.5 * f) : 1 + 0.4 * Math.sin(0.5 * f))),
  });
  return Array.from({ length: frames }, (_, f) => bent(bulged(f), f + 1)[f]);
}

async function made(
  model: Model,
  clips: readonly Clip[],
  more: Partial<GlbInput> = {},
): Promise<{ glb: Uint8Array<ArrayBuffer>; likeness: Likeness; input: GlbInput }> {
  const { document, drawn, faces, positions: rest } = model;
  const input = { name: "my dance", document, drawn, faces, rest, places: [], clips, fps: 30, scale: 1, every: 1, ...more };
  const { bytes, likeness } = await cartoonMorphs.write(input, tools);
  expect(likeness).not.toBeNull();
  return { glb: bytes, likeness: likeness!, input };
}

/** Ways in diagonals and turns of normals in radians, rms and worst, between what three.js plays and the frames. */
async function played(
  glb: Uint8Array<ArrayBuffer>,
  model: Model,
  { clips, every, fps, scale }: GlbInput,
): Promise<{ worst: number; normals: number }> {
  const { scene, animations } = await new GLTFLoader().parseAsync(glb.buffer, "");
  const meshes: Mesh[] = [];
  scene.traverse((object) => void ("isMesh" in object && meshes.push(object as Mesh)));
  expect(meshes).toHaveLength(model.drawn.instances.length);
  expect(animations).toHaveLength(clips.length);
  const mixer = new AnimationMixer(scene);
  const shapes = new Shapes(model.drawn, model.positions, 1);
  const found = { worst: 0, square: 0, count: 0 };
  clips.forEach(({ frames }, c) => {
    mixer.stopAllAction();
    mixer.clipAction(animations[c]).play();
    for (const f of keptFrames(frames.length, every)) {
      mixer.setTime(Math.min(f / fps, animations[c].duration - 1e-7));
      scene.updateMatrixWorld(true);
      const { normals } = shapes.of(frames[f].positions);
      meshes.forEach((mesh, m) => {
        const { first, count } = model.drawn.instances[m];
        for (let r = 0; r < count; r++) {
          const at = mesh.localToWorld(mesh.getVertexPosition(r, new Vector3())).divideScalar(scale);
          const v = 3 * model.drawn.toVertex[first + r];
          found.worst = Math.max(found.worst, at.distanceTo(new Vector3(...frames[f].positions.subarray(v, v + 3))));
          const normal = new Vector3().fromBufferAttribute(mesh.geometry.getAttribute("normal"), r);
          (mesh.geometry.morphAttributes.normal ?? []).forEach((target, k) => {
            normal.addScaledVector(new Vector3().fromBufferAttribute(target, r), mesh.morphTargetInfluences?.[k] ?? 0);
          });
          normal.applyQuaternion(mesh.getWorldQuaternion(new Quaternion()));
          const wanted = new Vector3(...(normals ?? new Float32Array(0)).subarray(3 * (first + r), 3 * (first + r) + 3));
          found.square += normal.angleTo(wanted) ** 2;
          found.count++;
        }
      });
    }
  });
  return { worst: found.worst / Math.hypot(0.4, HEIGHT, 0.4), normals: Math.sqrt(found.square / found.count) };
}

it("is faultless, and plays every frame in three.js as like as it says, lit as like too", async () => {
  const model = await post();
  const clips = [{ name: "squash", frames: squashed(model, 40) }];
  const { glb, likeness, input } = await made(model, clips);
  expect(likeness.rms).toBeLessThanOrEqual(0.0013);
  expect(likeness.worst).toBeLessThanOrEqual(0.008);
  expect(likeness.targets).toBeLessThan(12);
  expect(sayLikeness(likeness)).toMatch(/^\d+ morph targets; /);
  expect((await validateBytes(glb)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const { worst, normals } = await played(glb, model, input);
  expect(Math.abs(worst - likeness.worst)).toBeLessThan(2e-4);
  expect(Math.abs(normals - likeness.normals)).toBeLessThan(0.01);
  expect(normals).toBeLessThan(0.1);
});

it("plays kept frames of several clips by the same targets, at the model's own size", async () => {
  const model = await post();
  const frames = squashed(model, 50);
  const clips = [
    { name: "slow squash", frames: frames.slice(0, 21) },
    { name: "squash", frames: frames.slice(20) },
  ];
  const { glb, likeness, input } = await made(model, clips, { every: 3, scale: 100, fps: 60 });
  expect((await validateBytes(glb)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const { animations = [], meshes = [], nodes = [] } = (await openGlb(glb)).json;
  expect(animations.map(({ name }) => name)).toEqual(["slow_squash", "squash"]);
  for (const { targets } of meshes[0].primitives) expect(targets).toHaveLength(likeness.targets!);
  expect(nodes).toHaveLength(1);
  expect((await played(glb, model, input)).worst).toBeLessThan(likeness.worst + 2e-4);
});

it("holds more than bones do, in far less than a target for each frame", async () => {
  const model = await post();
  const clips = [{ name: "squash", frames: squashed(model, 60) }];
  const [{ glb, likeness, input }, exact] = [await made(model, clips), morphTargets];
  const bones = await gameCharacter.write(input, tools);
  expect(likeness.rms).toBeLessThan(bones.likeness!.rms * 1.5);
  expect(3 * glb.length).toBeLessThan((await exact.write(input, tools)).bytes.length);
});

it("ends on abort, and says what is no mesh", async () => {
  const model = await post();
  const clips = [{ name: "squash", frames: squashed(model, 10) }];
  for (const last of [0.2, 0.9]) {
    const stop = new AbortController();
    const onProgress = (done: number): void => void (done >= last && stop.abort());
    const { input } = await made(model, clips);
    await expect(cartoonMorphs.write(input, { ...tools, signal: stop.signal, onProgress })).rejects.toMatchObject({ name: "AbortError" });
  }
  const bad = [{ name: "squash", frames: [{ positions: model.positions.with(4, NaN) }] }];
  await expect(made(model, bad)).rejects.toMatchObject({ code: "bad_mesh" });
});
