import { describe, expect, it } from "vitest";

import type { Gltf } from "../../src/gltf/document";
import { ModelError } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { PNG } from "../support/files";
import { type GltfMaker, TRIANGLE, triangle } from "../support/gltf";

/** What is said of a sound triangle once somebody has been at it; "" if it opens. */
async function said(change: (maker: GltfMaker, json: Gltf) => void): Promise<string> {
  const { maker } = triangle();
  change(maker, maker.json);
  // Numbers beyond what JSON may hold, as a file has them.
  const text = JSON.stringify(maker.document().json).replaceAll('"1e999"', "1e999");
  const { buffers } = maker.document();
  const bin = `data:;base64,${Buffer.from(buffers[0]).toString("base64")}`;
  const whole = text.replace('"buffers":[{', `"buffers":[{"uri":"${bin}",`);
  const error: unknown = await readModel([{ name: "evil.gltf", bytes: new TextEncoder().encode(whole) }]).then(
    () => null,
    (caught: unknown) => caught,
  );
  if (error === null) return "";
  expect(error).toBeInstanceOf(ModelError);
  return (error as ModelError).message.replace("evil.gltf is a broken glTF file: ", "");
}

const accessor = (maker: GltfMaker, change: object): void => void Object.assign(maker.packer.json().accessors![0], change);
const view = (maker: GltfMaker, change: object): void => void Object.assign(maker.packer.json().bufferViews![0], change);
const CUT = "it ends early or its parts do not fit.";

describe("files that were made to hurt", () => {
  it("a triangle that nobody touched opens", async () => {
    expect(await said(() => {})).toBe("");
  });

  it.each<[string, (maker: GltfMaker, json: Gltf) => void, string]>([
    ["a node inside itself", (_, json) => (json.nodes = [{ mesh: 0, children: [0] }]), "node 0 is inside itself."],
    [
      "a joint in a circle of nodes",
      (_, json) => Object.assign(json, { nodes: [{ mesh: 0, skin: 0 }, { children: [2] }, { children: [1] }], skins: [{ joints: [1] }] }),
      "node 1 is inside itself.",
    ],
    ["a hundred million corners without bytes", (m) => accessor(m, { bufferView: undefined, count: 1e8 }), CUT],
    ["a few million corners without bytes", (m) => accessor(m, { bufferView: undefined, count: 9e6 }), "accessor 0 has no bytes."],
    ["more corners than bytes", (m) => accessor(m, { count: 4 }), CUT],
    ["half a corner", (m) => accessor(m, { count: 2.5 }), CUT],
    ["bytes from before the view", (m) => accessor(m, { byteOffset: -12 }), CUT],
    ["bytes from before the file", (m) => view(m, { byteOffset: -12 }), "buffer view 0 is none."],
    ["bytes from after the file", (m) => view(m, { byteOffset: 4 }), CUT],
    ["a stride that is no step", (m) => view(m, { byteStride: 7 }), CUT],
    ["a kind of number that there is not", (m) => accessor(m, { componentType: 77 }), CUT],
    ["corners of four", (m) => accessor(m, { type: "VEC4", count: 2 }), "the positions of mesh 0 are not in threes."],
    [
      "two billion exceptions",
      (m) => accessor(m, { sparse: { count: 2 ** 31, indices: { bufferView: 0, componentType: 5125 }, values: { bufferView: 0 } } }),
      CUT,
    ],
    [
      "what says that it unpacks to a gigabyte",
      (m) =>
        view(m, {
          byteLength: 2 ** 30,
          extensions: {
            EXT_meshopt_compression: { buffer: 0, byteOffset: 0, byteLength: 36, byteStride: 16, count: 2 ** 26, mode: "ATTRIBUTES" },
          },
        }),
      "buffer view 0 does not hold 67108864 x 16 bytes.",
    ],
    [
      "as many copies as fit in a line",
      (m, json) => {
        json.meshes![0].primitives[0].indices = m.shorts(Array<number>(3 * 20_000).fill(0));
        json.nodes = Array.from({ length: 1000 }, () => ({ mesh: 0 }));
        json.scenes = [{ nodes: json.nodes.map((_, n) => n) }];
      },
      "evil.gltf holds 8,020,000 triangles, and we open 8,000,000 at most. Simplify it first.",
    ],
    [
      "a corner at infinity",
      (_, json) => (json.nodes = [{ mesh: 0, scale: ["1e999", 1, 1] as unknown as number[] }]),
      "the scale of node 0 is not 3 numbers.",
    ],
    [
      "a corner beyond all worlds",
      (_, json) => (json.nodes = [{ mesh: 0, scale: [1e30, 1, 1] }]),
      "evil.gltf: vertex 2 is too far away (1.00e+30).",
    ],
    ["lists that are none", (_, json) => (json.nodes = { length: 1e9 } as unknown as []), "its nodes are no list of objects."],
    ["a mesh of nothing", (_, json) => (json.meshes = [null] as unknown as []), "its meshes are no list of objects."],
    [
      "a material with a texture from nowhere",
      (_, json) => (json.materials = [{ extensions: { X: { someTexture: { index: 3 } } } }]),
      "material 0 names one of its textures that is not there.",
    ],
  ])("%s", async (_, change, message) => {
    expect(await said(change)).toBe(message);
  });

  it("opens what is nested two hundred thousand deep", async () => {
    const depth = 200_000;
    const deep = await said((_, json) => {
      json.nodes = Array.from({ length: depth }, (__, n) => (n + 1 < depth ? { children: [n + 1] } : { mesh: 0 }));
    });
    expect(deep).toBe("");
  });

  it("does not decode a picture of four gigapixels, but keeps it", async () => {
    const huge = PNG.slice();
    new DataView(huge.buffer).setUint32(16, 65536);
    new DataView(huge.buffer).setUint32(20, 65536);
    const { maker } = triangle(TRIANGLE);
    maker.picture(huge);
    const { document, notes } = await readModel([maker.glb()]);
    expect(document.images).toEqual([{ bytes: huge, mime: "image/png", drawn: false }]);
    expect(notes).toEqual(["picture 1 has 65,536 x 65,536 pixels, too many to be shown."]);
  });
});
