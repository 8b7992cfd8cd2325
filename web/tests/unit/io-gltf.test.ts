import { describe, expect, it } from "vitest";

import { ModelError, type NamedFile } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { PNG } from "../support/files";
import { laidOn, TRIANGLE, triangle } from "../support/gltf";

async function refusal(...files: NamedFile[]): Promise<string> {
  const error: unknown = await readModel(files).then(
    () => null,
    (caught: unknown) => caught,
  );
  expect(error).toBeInstanceOf(ModelError);
  return (error as ModelError).message;
}

describe("GLB", () => {
  it("applies the nodes' transforms and joins all meshes", async () => {
    const { maker } = triangle();
    maker.json.nodes = [
      { mesh: 0, translation: [10, 0, 0], scale: [2, 2, 2] },
      { rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2], children: [2] },
      { mesh: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1] },
    ];
    maker.json.scenes = [{ nodes: [0, 1] }];
    const model = await readModel([maker.glb()]);
    const close = (values: number[]) => values.map((x) => expect.closeTo(x, 5));
    expect([...model.positions]).toEqual(close([10, 0, 0, 12, 0, 0, 10, 2, 0, -5, 0, 0, -5, 1, 0, -6, 0, 0]));
  });

  it("turns the faces of a mirrored node", async () => {
    const { maker } = triangle();
    maker.json.nodes = [{ mesh: 0, scale: [-1, 1, 1] }];
    expect([...(await readModel([maker.glb()])).positions]).toEqual([0, 0, 0, 0, 1, 0, -1, 0, 0].map((x) => expect.closeTo(x, 6)));
  });

  it("reads strips and fans", async () => {
    const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
    const read = (mode: number) => {
      const { maker, primitive } = triangle(square);
      primitive.mode = mode;
      return readModel([maker.glb()]);
    };
    expect([...(await read(5)).faces]).toEqual([0, 1, 2, 2, 1, 3]);
    expect([...(await read(6)).faces]).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it("keeps pictures, their places, colours and the seam", async () => {
    const { maker, primitive } = triangle([...TRIANGLE, ...TRIANGLE.slice(3), 1, 1, 0]);
    primitive.attributes.TEXCOORD_0 = maker.floats([0, 0, 1, 0, 0, 1, 0.5, 0, 0, 1, 1, 1], "VEC2");
    primitive.attributes.COLOR_0 = maker.floats(Array(18).fill(0.5));
    primitive.material = 0;
    maker.json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: maker.picture(PNG) }, baseColorFactor: [1, 0.5, 0, 1] } }];
    const model = await readModel([maker.glb()]);
    expect(model.positions.length / 3).toBe(4);
    expect([...model.drawn.toVertex]).toEqual([0, 1, 2, 1, 2, 3]);
    expect(model.document.images).toEqual([{ bytes: PNG, mime: "image/png", drawn: true }]);
    expect(laidOn(model, "TEXCOORD_0", 2)?.slice(0, 4)).toEqual([0, 0, 1, 0]);
    expect(model.document.json.materials).toEqual(maker.json.materials);
  });

  it("draws of shared vertices only what its triangles use", async () => {
    const { maker, primitive } = triangle([9, 9, 9, ...TRIANGLE, 8, 8, 8]);
    primitive.indices = maker.shorts([3, 1, 2]);
    primitive.attributes.TEXCOORD_0 = maker.floats([9, 9, 0, 0, 1, 0, 0, 1, 8, 8], "VEC2");
    const { drawn, ...model } = await readModel([maker.glb()]);
    expect([...drawn.positions]).toEqual(TRIANGLE);
    expect([...(drawn.instances[0].vertices ?? [])]).toEqual([1, 2, 3]);
    expect([...drawn.index]).toEqual([2, 0, 1]);
    expect(laidOn({ ...model, drawn }, "TEXCOORD_0", 2)).toEqual([0, 0, 1, 0, 0, 1]);
  });

  it("reads what is sparse, and what many places show", async () => {
    const { maker, primitive } = triangle();
    maker.packer.json().accessors![primitive.attributes.POSITION].sparse = {
      count: 1,
      indices: { bufferView: maker.packer.view(Uint8Array.of(2)), componentType: 5121 },
      values: { bufferView: maker.packer.view(new Uint8Array(Float32Array.of(0, 7, 0).buffer)) },
    };
    maker.json.nodes = [
      { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: maker.floats([0, 0, 0, 10, 0, 0]) } } } },
    ];
    const model = await readModel([maker.glb()]);
    expect([...model.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 7, 0, 10, 0, 0, 11, 0, 0, 10, 7, 0]);
    expect(model.document.json.accessors?.[0].sparse).toBeUndefined();
  });

  it("turns the file's normals with its nodes, and knows where there are none", async () => {
    const { maker, primitive } = triangle();
    primitive.attributes.NORMAL = maker.floats([0, 0, 1, 0, 0, 1, 0.6, 0, 0.8]);
    maker.mesh({ attributes: { POSITION: maker.floats(TRIANGLE.map((x) => x + 5)) } });
    maker.json.nodes = [{ mesh: 0, scale: [1, 1, 2], rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] }, { mesh: 1 }];
    maker.json.scenes = [{ nodes: [0, 1] }];
    const { drawn } = await readModel([maker.glb()]);
    expect(drawn.instances.map(({ flat }) => flat)).toEqual([false, true]);
    const [x, z] = [0.4 / Math.hypot(0.4, 0.6), -0.6 / Math.hypot(0.4, 0.6)]; // by the inverse of the scale, then turned
    const wanted = [1, 0, 0, 1, 0, 0, x, 0, z, ...Array<number>(9).fill(0)];
    expect([...drawn.normals]).toEqual(wanted.map((n) => expect.closeTo(n, 6)));
  });

  it("takes a skinned model in its current pose and says so", async () => {
    const { maker, primitive } = triangle();
    primitive.attributes.JOINTS_0 = maker.shorts([0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0], "VEC4");
    primitive.attributes.WEIGHTS_0 = maker.floats([1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0], "VEC4");
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    maker.json.skins = [{ joints: [1, 2], inverseBindMatrices: maker.matrices([...identity, ...identity]) }];
    // A skinned mesh does not follow its node.
    maker.json.nodes = [{ mesh: 0, skin: 0, translation: [100, 0, 0] }, { name: "a" }, { name: "b", translation: [0, 0, 3] }];
    maker.json.scenes = [{ nodes: [0, 1, 2] }];
    const model = await readModel([maker.glb()]);
    expect([...model.positions]).toEqual([0, 0, 0, 1, 0, 3, 0, 1, 1.5]);
    expect(model.notes).toEqual([
      "This file already has a skeleton. We use its current pose and the names of its joints, and leave the bones out.",
    ]);
  });

  it("takes a morphed model in its current shape and says so", async () => {
    const { maker, primitive } = triangle();
    primitive.targets = [{ POSITION: maker.floats([0, 0, 2, 0, 0, 2, 0, 0, 2]) }];
    maker.json.meshes![0].weights = [0.5];
    const model = await readModel([maker.glb()]);
    expect([...model.positions]).toEqual([0, 0, 1, 1, 0, 1, 0, 1, 1]);
    expect(model.notes).toEqual(["This file has shape keys. We use its current shape."]);
  });

  it("keeps far coordinates exact: their middle is taken off before they are rounded", async () => {
    const { maker } = triangle();
    const far = [4_500_000.25, 12, 500_000.5];
    maker.json.nodes = [{ mesh: 0, translation: far }];
    const { positions, origin } = await readModel([maker.glb()]);
    expect(origin).toEqual([far[0] + 0.5, far[1] + 0.5, far[2]]);
    expect([...positions]).toEqual([-0.5, -0.5, 0, 0.5, -0.5, 0, -0.5, 0.5, 0]);
    expect((await readModel([triangle().maker.glb()])).origin).toEqual([0, 0, 0]);
  });

  it("says what is there instead of triangles", async () => {
    const { maker, primitive } = triangle();
    primitive.mode = 1;
    maker.json.cameras = [{ type: "perspective" }];
    expect(await refusal(maker.glb("curves.glb"))).toBe("curves.glb has no triangles. It holds 1 set of lines or points and 1 camera.");
  });

  it.each([5, 16, 40, 200])("refuses one that is cut %d bytes before its end", async (cut) => {
    const whole = triangle().maker.glb();
    expect(await refusal({ name: "cut.glb", bytes: whole.bytes.subarray(0, Math.max(8, whole.bytes.length - cut)) })).toMatch(/^cut\.glb /);
  });

  it.each([
    ['{"asset":{"version":"1.0"}}', "x.gltf is not glTF 2.0."],
    ["{}", "x.gltf holds no glTF model."],
    ["hello", "x.gltf holds no glTF model."],
    ['{"asset":{"version":"2.0"}}', "x.gltf has no triangles."],
    [
      '{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":7}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]}',
      "x.gltf is a broken glTF file: mesh 0 names one of its accessors that is not there.",
    ],
  ])("refuses %s", async (text, message) => {
    expect(await refusal({ name: "x.gltf", bytes: new TextEncoder().encode(text) })).toBe(message);
  });
});

describe("glTF beside its files", () => {
  async function parts() {
    const { maker, primitive } = triangle();
    primitive.attributes.TEXCOORD_0 = maker.floats([0, 0, 1, 0, 0, 1], "VEC2");
    primitive.material = 0;
    maker.json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    maker.json.textures = [{ source: 0 }];
    maker.json.images = [{ uri: "tex/oak%20wood.png" }];
    const { json, buffers } = maker.document();
    json.buffers![0].uri = "data.bin";
    const gltf = { name: "m/table.gltf", bytes: new TextEncoder().encode(JSON.stringify(json)) };
    return { gltf, bin: { name: "m/data.bin", bytes: buffers[0] }, picture: { name: "m/tex/oak wood.png", bytes: PNG } };
  }

  it("finds them, by folder or by name", async () => {
    const { gltf, bin, picture } = await parts();
    expect((await readModel([picture, bin, gltf])).document.images[0]?.mime).toBe("image/png");
    const flat = [gltf, bin, picture].map(({ name, bytes }) => ({ name: name.slice(name.lastIndexOf("/") + 1), bytes }));
    expect((await readModel(flat)).document.images[0]?.mime).toBe("image/png");
  });

  it("names a file whose parts are not what they say", async () => {
    const { gltf, bin } = await parts();
    const text = new TextDecoder().decode(gltf.bytes);
    const odd = new TextEncoder().encode(text.replace(/"componentType": ?5126/g, '"componentType":77'));
    expect(await refusal({ ...gltf, bytes: odd }, bin)).toBe("table.gltf is a broken glTF file: it ends early or its parts do not fit.");
    expect(await refusal({ ...gltf, bytes: new TextEncoder().encode('{"asset":{"version":2}}') })).toBe("table.gltf is not glTF 2.0.");
  });

  it("names what is missing", async () => {
    const { gltf, bin } = await parts();
    expect(await refusal(gltf)).toBe("table.gltf needs data.bin; drop both together.");
    expect((await readModel([gltf, bin])).notes).toEqual(["This model names oak wood.png; drop it too."]);
  });

  it("takes what stands in the file itself", async () => {
    const { gltf, bin } = await parts();
    const inline = (bytes: Uint8Array): string => `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`;
    const text = new TextDecoder().decode(gltf.bytes).replace("data.bin", inline(bin.bytes)).replace("tex/oak%20wood.png", inline(PNG));
    const model = await readModel([{ ...gltf, bytes: new TextEncoder().encode(text) }]);
    expect([...model.positions]).toEqual(TRIANGLE);
    expect(model.document.images[0]?.bytes).toEqual(PNG);
  });
});
