import { Document, Primitive, WebIO } from "@gltf-transform/core";
import { describe, expect, it } from "vitest";

import { ModelError, type NamedFile } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { PNG } from "../support/files";

const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A document with one triangle on one node, to be changed. */
function triangle(mode: number = Primitive.Mode.TRIANGLES, positions = TRIANGLE) {
  const document = new Document();
  const buffer = document.createBuffer();
  const floats = (array: number[], type: "VEC2" | "VEC3" | "VEC4" | "MAT4" = "VEC3") =>
    document.createAccessor().setType(type).setArray(new Float32Array(array)).setBuffer(buffer);
  const primitive = document
    .createPrimitive()
    .setMode(mode as 4)
    .setAttribute("POSITION", floats(positions));
  const mesh = document.createMesh("m").addPrimitive(primitive);
  const node = document.createNode("n").setMesh(mesh);
  const scene = document.createScene().addChild(node);
  return { document, buffer, floats, primitive, mesh, node, scene };
}

async function glb(document: Document, name = "t.glb"): Promise<NamedFile> {
  return { name, bytes: await new WebIO().writeBinary(document) };
}

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
    const { document, node, mesh, scene } = triangle();
    node.setTranslation([10, 0, 0]).setScale([2, 2, 2]);
    const parent = document
      .createNode()
      .setRotation([0, 0, Math.SQRT1_2, Math.SQRT1_2])
      .addChild(document.createNode().setMesh(mesh).setTranslation([0, 5, 0]));
    scene.addChild(parent);
    const model = await readModel([await glb(document)]);
    const close = (values: number[]) => values.map((x) => expect.closeTo(x, 5));
    expect([...model.positions]).toEqual(close([10, 0, 0, 12, 0, 0, 10, 2, 0, -5, 0, 0, -5, 1, 0, -6, 0, 0]));
  });

  it("turns the faces of a mirrored node", async () => {
    const { document, node } = triangle();
    node.setScale([-1, 1, 1]);
    expect([...(await readModel([await glb(document)])).positions]).toEqual([0, 0, 0, 0, 1, 0, -1, 0, 0].map((x) => expect.closeTo(x, 6)));
  });

  it("reads strips and fans", async () => {
    const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
    const strip = await readModel([await glb(triangle(Primitive.Mode.TRIANGLE_STRIP, square).document)]);
    expect([...strip.faces]).toEqual([0, 1, 2, 2, 1, 3]);
    const fan = await readModel([await glb(triangle(Primitive.Mode.TRIANGLE_FAN, square).document)]);
    expect([...fan.faces]).toEqual([0, 1, 2, 0, 2, 3]);
  });

  it("keeps the picture, its places, colours and the seam", async () => {
    const { document, primitive, floats } = triangle(4, [...TRIANGLE, ...TRIANGLE.slice(3), 1, 1, 0]);
    primitive
      .setAttribute("TEXCOORD_0", floats([0, 0, 1, 0, 0, 1, 0.5, 0, 0, 1, 1, 1], "VEC2"))
      .setAttribute("COLOR_0", floats(Array(18).fill(0.5)));
    const texture = document
      .createTexture("skin")
      .setImage(PNG as Uint8Array<ArrayBuffer>)
      .setMimeType("image/png");
    primitive.setMaterial(document.createMaterial().setBaseColorTexture(texture).setBaseColorFactor([1, 0.5, 0, 1]));
    const model = await readModel([await glb(document)]);
    expect(model.positions.length / 3).toBe(4);
    expect(model.drawn.toVertex.length).toBe(5);
    expect(model.drawn.texture?.mime).toBe("image/png");
    expect([...(model.drawn.texture?.bytes ?? [])]).toEqual([...PNG]);
    expect([...(model.drawn.uvs ?? [])].slice(0, 4)).toEqual([0, 0, 1, 0]);
    expect([...(model.drawn.colors ?? [])].slice(0, 3)).toEqual([0.5, 0.25, 0]);
  });

  it("takes a skinned model in its current pose and says so", async () => {
    const { document, primitive, node, buffer, scene, floats } = triangle();
    const bytes = (array: number[]) => document.createAccessor().setType("VEC4").setArray(new Uint8Array(array)).setBuffer(buffer);
    primitive.setAttribute("JOINTS_0", bytes([0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]));
    primitive.setAttribute("WEIGHTS_0", floats([1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0], "VEC4"));
    const joints = [document.createNode("a"), document.createNode("b").setTranslation([0, 0, 3])];
    joints.forEach((joint) => scene.addChild(joint));
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    const skin = document.createSkin().setInverseBindMatrices(floats([...identity, ...identity], "MAT4"));
    joints.forEach((joint) => skin.addJoint(joint));
    node.setSkin(skin).setTranslation([100, 0, 0]); // a skinned mesh does not follow its node
    const model = await readModel([await glb(document)]);
    expect([...model.positions]).toEqual([0, 0, 0, 1, 0, 3, 0, 1, 1.5]);
    expect(model.notes).toEqual(["This file already has a skeleton. We use its current pose and leave the bones out."]);
  });

  it("takes a morphed model in its current shape and says so", async () => {
    const { document, primitive, mesh, floats } = triangle();
    primitive.addTarget(document.createPrimitiveTarget().setAttribute("POSITION", floats([0, 0, 2, 0, 0, 2, 0, 0, 2])));
    mesh.setWeights([0.5]);
    const model = await readModel([await glb(document)]);
    expect([...model.positions]).toEqual([0, 0, 1, 1, 0, 1, 0, 1, 1]);
    expect(model.notes).toEqual(["This file has shape keys. We use its current shape."]);
  });

  it("says what is there instead of triangles", async () => {
    const { document } = triangle(Primitive.Mode.LINES, TRIANGLE);
    document.createCamera().setType("perspective");
    expect(await refusal(await glb(document, "curves.glb"))).toBe(
      "curves.glb has no triangles. It holds 1 set of lines or points and 1 camera.",
    );
  });

  it.each([5, 16, 40, 200])("refuses one that is cut %d bytes before its end", async (cut) => {
    const whole = await glb(triangle().document);
    expect(await refusal({ name: "cut.glb", bytes: whole.bytes.subarray(0, Math.max(8, whole.bytes.length - cut)) })).toMatch(/^cut\.glb /);
  });

  it("refuses compressed ones in words", async () => {
    const json = {
      asset: { version: "2.0" },
      extensionsRequired: ["KHR_draco_mesh_compression"],
      extensionsUsed: ["KHR_draco_mesh_compression"],
    };
    expect(await refusal({ name: "small.gltf", bytes: new TextEncoder().encode(JSON.stringify(json)) })).toBe(
      "small.gltf is compressed with Draco. Save it without compression.",
    );
  });

  it.each([
    ['{"asset":{"version":"1.0"}}', "x.gltf is not glTF 2.0."],
    ["{}", "x.gltf holds no glTF model."],
    ["hello", "x.gltf holds no glTF model."],
    ['{"asset":{"version":"2.0"}}', "x.gltf has no triangles."],
    [
      '{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":7}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]}',
      "x.gltf has no triangles. It holds 1 set of lines or points.",
    ],
  ])("refuses %s", async (text, message) => {
    expect(await refusal({ name: "x.gltf", bytes: new TextEncoder().encode(text) })).toBe(message);
  });
});

describe("glTF beside its files", () => {
  async function parts() {
    const { document, primitive, floats } = triangle();
    primitive.setAttribute("TEXCOORD_0", floats([0, 0, 1, 0, 0, 1], "VEC2"));
    const texture = document
      .createTexture("skin")
      .setImage(PNG as Uint8Array<ArrayBuffer>)
      .setMimeType("image/png")
      .setURI("tex/oak wood.png");
    primitive.setMaterial(document.createMaterial().setBaseColorTexture(texture));
    document.getRoot().listBuffers()[0].setURI("data.bin");
    const { json, resources } = await new WebIO().writeJSON(document);
    for (const image of json.images ?? []) image.uri = "tex/oak%20wood.png";
    const gltf = { name: "m/table.gltf", bytes: new TextEncoder().encode(JSON.stringify(json)) };
    return { gltf, bin: { name: "m/data.bin", bytes: resources["data.bin"] }, picture: { name: "m/tex/oak wood.png", bytes: PNG } };
  }

  it("finds them, by folder or by name", async () => {
    const { gltf, bin, picture } = await parts();
    expect((await readModel([picture, bin, gltf])).drawn.texture?.mime).toBe("image/png");
    const flat = [gltf, bin, picture].map(({ name, bytes }) => ({ name: name.slice(name.lastIndexOf("/") + 1), bytes }));
    expect((await readModel(flat)).drawn.texture?.mime).toBe("image/png");
  });

  it("names a file whose parts are not what they say", async () => {
    const { gltf, bin } = await parts();
    const text = new TextDecoder().decode(gltf.bytes);
    const odd = new TextEncoder().encode(text.replace(/"componentType": ?\d+/g, '"componentType":77'));
    expect(await refusal({ ...gltf, bytes: odd }, bin)).toBe("table.gltf is a broken glTF file: it ends early or its parts do not fit.");
    expect(await refusal({ ...gltf, bytes: new TextEncoder().encode('{"asset":{"version":2}}') })).toBe("table.gltf is not glTF 2.0.");
  });

  it("names what is missing", async () => {
    const { gltf, bin } = await parts();
    expect(await refusal(gltf)).toBe("table.gltf needs data.bin; drop both together.");
    expect((await readModel([gltf, bin])).notes).toEqual(["This model names oak wood.png; drop it too."]);
  });
});
