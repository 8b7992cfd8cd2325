import { WebIO } from "@gltf-transform/core";
import { validateBytes } from "gltf-validator";
import type { BufferAttribute, Mesh } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { describe, expect, it } from "vitest";

import type { Model } from "../../src/io/model";
import { readModel } from "../../src/io/read-model";
import { type GlbInput, keptFrames, writeGlb } from "../../src/io/write-glb";
import { PNG, TETRAHEDRON, textFile } from "../support/files";

/** A wave through the model, as a dance that is easy to check. */
function wave(model: Model, frames: number): { positions: Float32Array }[] {
  return Array.from({ length: frames }, (_, f) => ({
    positions: model.positions.map((x, i) => x + 0.3 * Math.sin(0.7 * f + i) + (i % 3 === 1 ? 1 : 0.02 * f)),
  }));
}

function inputOf(model: Model, frames: number, more: Partial<GlbInput> = {}): GlbInput {
  return {
    name: "my  dance",
    drawn: model.drawn,
    faces: model.faces,
    rest: model.positions,
    frames: wave(model, frames),
    scale: 1,
    every: 1,
    ...more,
  };
}

async function problems(glb: Uint8Array): Promise<unknown> {
  const { issues } = await validateBytes(glb);
  return { errors: issues.numErrors, warnings: issues.numWarnings, messages: issues.messages };
}

const CLEAN = { errors: 0, warnings: 0, messages: [] };

/** The mesh and its clip through three's GLTFLoader, as a viewer sees them. */
async function load(glb: Uint8Array) {
  const gltf = await new GLTFLoader().parseAsync(new Uint8Array(glb).buffer, "");
  const meshes: Mesh[] = [];
  gltf.scene.traverse((object) => void ("isMesh" in object && meshes.push(object as Mesh)));
  expect(meshes).toHaveLength(1);
  return { mesh: meshes[0], clips: gltf.animations };
}

const plain = (): Promise<Model> => readModel([textFile("t.obj", TETRAHEDRON)]);

async function dressed(): Promise<Model> {
  const model = await readModel([
    textFile(
      "t.obj",
      TETRAHEDRON.replaceAll(/(v .*)/g, "$1 1 .5 0").replace(
        /f.*/s,
        "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 1/2 4/1 3/3\nf 2/1 3/2 4/3\n",
      ),
    ),
  ]);
  model.drawn.texture = { bytes: PNG, mime: "image/png" };
  return model;
}

describe("an animated GLB", () => {
  it.each([
    ["plain", plain],
    ["with colours, seams and a picture", dressed],
  ])("%s has no fault", async (_, make) => {
    expect(await problems(await writeGlb(inputOf(await make(), 12)))).toEqual(CLEAN);
  });

  it("plays each kept frame exactly, and at most two targets at a time", async () => {
    const model = await plain();
    const input = inputOf(model, 10, { every: 4 });
    const { mesh, clips } = await load(await writeGlb(input));
    const kept = keptFrames(10, 4);
    expect(kept).toEqual([0, 4, 8, 9]);
    expect(clips).toHaveLength(1);
    expect(clips[0].name).toBe("my_dance");
    const [track] = clips[0].tracks;
    expect([...track.times]).toEqual(kept.map((f) => expect.closeTo(f / 30, 6)));

    const position = mesh.geometry.attributes.position as BufferAttribute;
    const targets = mesh.geometry.morphAttributes.position ?? [];
    expect(targets).toHaveLength(kept.length);
    kept.forEach((f, n) => {
      const weights = track.values.slice(n * kept.length, (n + 1) * kept.length);
      expect([...weights]).toEqual(kept.map((_, k) => (k === n ? 1 : 0)));
      const played = Array.from(position.array, (x, i) => x + targets[n].array[i]);
      const wanted = [...model.drawn.toVertex].flatMap((v) => [...input.frames[f].positions.subarray(3 * v, 3 * v + 3)]);
      expect(Math.max(...played.map((x, i) => Math.abs(x - wanted[i])))).toBeLessThanOrEqual(1e-6);
    });
  });

  it("keeps the model's own size", async () => {
    const model = await plain();
    const { mesh } = await load(await writeGlb(inputOf(model, 2, { scale: 100 })));
    mesh.geometry.computeBoundingBox();
    const { position } = mesh.geometry.attributes;
    expect(Math.max(...Array.from(position.array))).toBe(100);
  });

  it("keeps picture, seams and colours", async () => {
    const model = await dressed();
    const root = (await new WebIO().readBinary(await writeGlb(inputOf(model, 3)))).getRoot();
    expect([...(root.listTextures()[0].getImage() ?? [])]).toEqual([...PNG]);
    const primitive = root.listMeshes()[0].listPrimitives()[0];
    expect(primitive.getAttribute("TEXCOORD_0")?.getArray()).toEqual(model.drawn.uvs);
    expect(primitive.getAttribute("COLOR_0")?.getArray()).toEqual(model.drawn.colors);
    expect(model.drawn.toVertex.length).toBeGreaterThan(model.positions.length / 3);
  });

  it("lights each frame by its own normals", async () => {
    const model = await plain();
    const turned = model.positions.map((_, i) => [-model.positions[i], model.positions[i], -model.positions[i]][i % 3]);
    const root = (await new WebIO().readBinary(await writeGlb(inputOf(model, 0, { frames: [{ positions: turned }] })))).getRoot();
    const primitive = root.listMeshes()[0].listPrimitives()[0];
    const rest = [...(primitive.getAttribute("NORMAL")?.getArray() ?? [])];
    const delta = [...(primitive.listTargets()[0].getAttribute("NORMAL")?.getArray() ?? [])];
    rest.forEach((n, i) => expect(n + delta[i]).toBeCloseTo(i % 3 === 1 ? n : -n, 6));
  });

  it("keeps the first and the last frame whatever is left out", () => {
    expect(keptFrames(1, 7)).toEqual([0]);
    expect(keptFrames(3, 7)).toEqual([0, 2]);
    expect(keptFrames(9, 4)).toEqual([0, 4, 8]);
    expect(keptFrames(0, 1)).toEqual([]);
  });
});
