import { validateBytes } from "gltf-validator";
import type { BufferAttribute, Mesh } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { describe, expect, it } from "vitest";

import type { Model } from "../../src/io/model";
import type { NamedFile } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { type GlbInput, keptFrames, writeGlb } from "../../src/io/write-glb";
import { PNG, TETRAHEDRON, textFile } from "../support/files";
import { laidOn, openGlb, TRIANGLE, triangle, valuesOf } from "../support/gltf";

/** A wave through the model, as a dance that is easy to check. */
function wave(model: Model, frames: number): { positions: Float32Array }[] {
  return Array.from({ length: frames }, (_, f) => ({
    positions: model.positions.map((x, i) => x + 0.3 * Math.sin(0.7 * f + i) + (i % 3 === 1 ? 1 : 0.02 * f)),
  }));
}

function inputOf(model: Model, frames: number, more: Partial<GlbInput> = {}): GlbInput {
  return {
    name: "my  dance",
    document: model.document,
    drawn: model.drawn,
    faces: model.faces,
    places: [],
    rest: model.positions,
    clips: [{ name: "my  dance", frames: wave(model, frames) }],
    fps: 30,
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

function dressed(): Promise<Model> {
  const text = TETRAHEDRON.replaceAll(/(v .*)/g, "$1 1 .5 0").replace(
    /f.*/s,
    "mtllib t.mtl\nusemtl skin\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 1/2 4/1 3/3\nf 2/1 3/2 4/3\n",
  );
  return readModel([textFile("t.obj", text), textFile("t.mtl", "newmtl skin\nmap_Kd skin.png\n"), { name: "skin.png", bytes: PNG }]);
}

describe("an animated GLB", () => {
  it.each([
    ["plain", plain],
    ["with colours, seams and a picture", dressed],
  ])("%s has no fault", async (_, make) => {
    expect(await problems(writeGlb(inputOf(await make(), 12)))).toEqual(CLEAN);
  });

  it("plays each kept frame exactly, and at most two targets at a time", async () => {
    const model = await plain();
    const input = inputOf(model, 10, { every: 4 });
    const { mesh, clips } = await load(writeGlb(input));
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
      const wanted = [...model.drawn.toVertex].flatMap((v) => [...input.clips[0].frames[f].positions.subarray(3 * v, 3 * v + 3)]);
      expect(Math.max(...played.map((x, i) => Math.abs(x - wanted[i])))).toBeLessThanOrEqual(1e-6);
    });
  });

  it("keeps the model's own size", async () => {
    const model = await plain();
    const { mesh } = await load(writeGlb(inputOf(model, 2, { scale: 100 })));
    mesh.geometry.computeBoundingBox();
    const { position } = mesh.geometry.attributes;
    expect(Math.max(...Array.from(position.array))).toBe(100);
  });

  it("keeps picture, seams and colours", async () => {
    const model = await dressed();
    const written = await openGlb(writeGlb(inputOf(model, 3)));
    expect(written.images).toEqual(model.document.images);
    expect(valuesOf(written, "TEXCOORD_0")).toEqual(laidOn(model, "TEXCOORD_0", 2));
    expect(valuesOf(written, "COLOR_0")).toEqual(laidOn(model, "COLOR_0", 3));
    expect(written.json.materials).toEqual(model.document.json.materials);
    expect(model.drawn.toVertex.length).toBeGreaterThan(model.positions.length / 3);
  });

  it("lights each frame by its own normals", async () => {
    const model = await plain();
    const turned = model.positions.map((_, i) => [-model.positions[i], model.positions[i], -model.positions[i]][i % 3]);
    const written = await openGlb(writeGlb(inputOf(model, 0, { clips: [{ name: "turned", frames: [{ positions: turned }] }] })));
    const rest = valuesOf(written, "NORMAL") ?? [];
    const delta = valuesOf(written, "NORMAL", { target: 0 }) ?? [];
    expect(rest).toHaveLength(36); // a tetrahedron has creases alone
    rest.forEach((n, i) => expect(n + delta[i]).toBeCloseTo(i % 3 === 1 ? n : -n, 6));
  });

  it("leaves faces flat that have no normals in their file", async () => {
    const { maker } = triangle();
    const written = await openGlb(writeGlb(inputOf(await readModel([maker.glb()]), 2)));
    expect(written.json.meshes![0].primitives[0].attributes).toEqual({ POSITION: expect.any(Number) });
    expect(valuesOf(written, "NORMAL", { target: 0 })).toBeNull();
  });

  /** Two materials, four maps, samplers, and extensions that nobody here knows. */
  function rich(): NamedFile {
    const { maker, primitive } = triangle();
    primitive.attributes.NORMAL = maker.floats([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    primitive.attributes.TEXCOORD_0 = maker.shorts([0, 0, 65535, 0, 0, 65535], "VEC2");
    maker.packer.json().accessors!.at(-1)!.normalized = true;
    primitive.attributes.TEXCOORD_1 = maker.floats([0, 0, 0.5, 0, 0, 0.5], "VEC2");
    primitive.material = 0;
    maker.mesh({ attributes: { POSITION: maker.floats(TRIANGLE.map((x) => x + 2)) }, material: 1 });
    const [color, metal, bumps, glow] = [0, 1, 2, 3].map(() => maker.picture(PNG));
    for (const texture of maker.json.textures!) texture.sampler = 0;
    maker.json = {
      ...maker.json,
      asset: { version: "2.0", copyright: "somebody" } as Model["document"]["json"]["asset"],
      samplers: [{ magFilter: 9728, minFilter: 9728, wrapS: 33071, wrapT: 33648 }],
      materials: [
        {
          name: "coat",
          pbrMetallicRoughness: {
            baseColorTexture: { index: color },
            metallicRoughnessTexture: { index: metal, texCoord: 1 },
            metallicFactor: 0.5,
          },
          normalTexture: { index: bumps, scale: 0.5 },
          emissiveTexture: { index: glow },
          emissiveFactor: [1, 0, 0],
          alphaMode: "MASK",
          alphaCutoff: 0.25,
          doubleSided: true,
        },
        { name: "flat", extensions: { KHR_materials_unlit: {}, VENDOR_paint: { thick: true } } },
      ],
      nodes: [
        { name: "body", mesh: 0 },
        { name: "head", mesh: 1 },
      ],
      scenes: [{ nodes: [0, 1] }],
      extensionsUsed: ["KHR_materials_unlit", "VENDOR_paint", "VRMC_vrm"],
      extensions: { VRMC_vrm: { specVersion: "1.0", humanoid: { humanBones: { head: { node: 1 } } } } },
      extras: { theirs: 1 },
    };
    return maker.glb();
  }

  it("keeps all materials, maps, samplers and extensions that it does not know", async () => {
    const file = rich();
    const model = await readModel([file]);
    const bytes = writeGlb(inputOf(model, 3));
    const { json, images } = await openGlb(bytes);
    const own = model.document.json;
    for (const key of ["materials", "textures", "samplers", "extensions", "extensionsUsed", "extras"] as const) {
      expect(json[key], key).toEqual(own[key]);
    }
    expect(json.asset).toEqual({ ...own.asset, generator: "Rigless" });
    expect(images).toEqual(model.document.images);
    expect(json.nodes!.map(({ name }) => name)).toEqual(["body", "head", "my_dance"]);
    expect(json.meshes![0].primitives.map(({ material }) => material)).toEqual([0, 1]);
    const written = await openGlb(bytes);
    expect(valuesOf(written, "TEXCOORD_0")).toEqual([0, 0, 1, 0, 0, 1]);
    expect(valuesOf(written, "TEXCOORD_1")).toEqual([0, 0, 0.5, 0, 0, 0.5]);
    // What the validator says of the file itself it says of the dance, and nothing else.
    const warnings = async (glb: Uint8Array) => (await validateBytes(glb)).issues.messages.map(({ code }) => code);
    const known = await warnings(file.bytes);
    expect((await warnings(bytes)).filter((code) => !known.includes(code) && code !== "NODE_EMPTY")).toEqual([]);
  });

  it("keeps the first and the last frame whatever is left out", () => {
    expect(keptFrames(1, 7)).toEqual([0]);
    expect(keptFrames(3, 7)).toEqual([0, 2]);
    expect(keptFrames(9, 4)).toEqual([0, 4, 8]);
    expect(keptFrames(0, 1)).toEqual([]);
  });
});
