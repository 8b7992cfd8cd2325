import { expect, it } from "vitest";

import type { NamedFile } from "../../src/io/named-file";
import { isNormalMap } from "../../src/io/picture";
import { readObj } from "../../src/io/read-obj";
import { readOff } from "../../src/io/read-off";
import { readPly } from "../../src/io/read-ply";
import { readStl } from "../../src/io/read-stl";
import { PNG, textFile } from "../support/files";

const FACES = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 .25\n";
const png = (name: string): NamedFile => ({ name, bytes: PNG });

function obj(text: string, mtl = "", ...beside: NamedFile[]) {
  const file = textFile("m/a.obj", `mtllib a.mtl\n${FACES}${text}`);
  const notes: string[] = [];
  return { ...readObj("a.obj", file, [file, textFile("m/a.mtl", mtl), ...beside], notes), notes };
}

it("faces of one object and one material are one part, with the object's name", () => {
  const built = obj(
    "o head\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\nusemtl red\nf 2 3 4\no hand\nf 1 3 4\n",
    "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nd .5\n",
  );
  expect(built.parts.map(({ name, material, index }) => [name, material, index.length / 3])).toEqual([
    ["head", 0, 2],
    ["head", 1, 1],
    ["hand", 0, 1],
  ]);
  expect(built.materials?.map(({ pbrMetallicRoughness, alphaMode }) => [pbrMetallicRoughness?.baseColorFactor, alphaMode])).toEqual([
    [[1, 0, 0, 1], undefined],
    [[0, 0, 1, 0.5], "BLEND"],
  ]);
});

it("what an MTL says becomes what glTF says", () => {
  const built = obj(
    "usemtl skin\nf 1/1 2/2 3/3\n",
    "newmtl skin\nKd .1 .1 .1\nKe 0 1 0\nNs 250\nmap_Kd -s 2 4 1 -o .5 0 skin color.png\n" +
      "map_Bump -bm 1 skin_normal.png\nmap_Ks -clamp on gloss.png\n",
    png("m/skin color.png"),
    png("elsewhere/skin_normal.png"),
  );
  expect(built.materials).toEqual([
    {
      name: "skin",
      pbrMetallicRoughness: {
        baseColorTexture: { index: 2, extensions: { KHR_texture_transform: { offset: [0.5, -3], scale: [2, 4] } } },
        metallicFactor: 0,
        roughnessFactor: 0.5,
      },
      doubleSided: true,
      normalTexture: { index: 1 },
      emissiveFactor: [0, 1, 0],
      extensions: { KHR_materials_specular: { specularColorTexture: { index: 0 } } },
    },
  ]);
  expect(built.pictures?.map(({ name, picture, sampler }) => [name, picture?.mime ?? null, sampler])).toEqual([
    ["gloss.png", null, { wrapS: 33071, wrapT: 33071 }],
    ["skin_normal.png", "image/png", undefined],
    ["skin color.png", "image/png", undefined],
  ]);
  expect(built.notes).toEqual(["Left out 1 loose point that no face uses.", "This model names gloss.png; drop it too."]);
  expect([...(built.parts[0].uvs?.[0] as Float32Array)]).toEqual([0, 1, 1, 1, 0, 0.75]);
});

it("a height map is no normal map", () => {
  expect(["a_normal.png", "a_n.png", "NRM.png", "body-nor.tga"].map(isNormalMap)).toEqual([true, true, true, true]);
  expect(["bump.png", "skin.png", "height.png"].map(isNormalMap)).toEqual([false, false, false]);
  expect(obj("usemtl a\nf 1 2 3\n", "newmtl a\nmap_Bump bump.png\n").pictures).toEqual([]);
});

it("colours of vertices stay, far places stay exact", () => {
  const file = textFile("a.obj", "v 500000.125 0 0 1 0 0 .5\nv 500001 0 0 1 0 0 .5\nv 500000 1 0 1 0 0 .5\nf 1 2 3\n");
  const { parts } = readObj("a.obj", file, [file], []);
  expect(parts[0].positions[0]).toBe(500000.125);
  expect(Array.from(parts[0].colors ?? []).slice(0, 3)).toEqual([1, 0, 0]);
});

it("OFF: a face may go on in the next line", () => {
  const { parts } = readOff("a.off", textFile("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1\n2 3\n3 0\n1\n2\n"), []);
  expect(parts[0].index).toEqual([0, 1, 2, 0, 2, 3, 0, 1, 2]);
});

const XYZ = "property float x\nproperty float y\nproperty float z\n";
const ply = (elements: string, rows: string, comment = ""): NamedFile =>
  textFile("a.ply", `ply\nformat ascii 1.0\n${comment}element vertex 4\n${XYZ}${elements}end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n${rows}`);

it("PLY: strips, each third triangle turned, -1 begins another", () => {
  const file = ply("element tristrips 1\nproperty list int int vertex_indices\n", "8 0 1 2 3 -1 3 2 1\n");
  expect(readPly("a.ply", file, [file], []).parts[0].index).toEqual([0, 1, 2, 2, 1, 3, 3, 2, 1]);
});

it("PLY: corners with places of their own in the picture that a comment names", () => {
  const file = ply(
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n",
    "3 0 1 2 6 0 0 1 0 0 1\n3 1 3 2 6 .5 0 1 1 0 1\n",
    "comment TextureFile skin.png\n",
  );
  const built = readPly("a.ply", file, [file, png("skin.png")], []);
  // Vertex 1 is there twice, vertex 2 once.
  expect(Array.from(built.parts[0].index)).toEqual([0, 1, 2, 3, 4, 2]);
  expect(Array.from(built.parts[0].uvs?.[0] ?? [])).toEqual([0, 1, 1, 1, 0, 0, 0.5, 1, 1, 0]);
  expect(built.materials).toMatchObject([{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }]);
  expect(built.pictures).toMatchObject([{ picture: { bytes: PNG } }]);
});

it("PLY: splats and points say what they are", () => {
  const splat = textFile("a.ply", `ply\nformat ascii 1.0\nelement vertex 1\n${XYZ}property float f_dc_0\nend_header\n0 0 0 1\n`);
  expect(() => readPly("a.ply", splat, [splat], [])).toThrow("a.ply is a cloud of Gaussian splats without a surface.");
  const points = ply("", "");
  expect(() => readPly("a.ply", points, [points], [])).toThrow("a.ply has no triangles: it holds 4 points alone. Make a mesh of them");
});

it("STL: colours of triangles, by the word in its header", () => {
  const view = new DataView(new ArrayBuffer(84 + 100));
  new Uint8Array(view.buffer).set(new TextEncoder().encode("COLOR="));
  new Uint8Array(view.buffer).set([0, 0, 255, 255], 6);
  view.setUint32(80, 2, true);
  view.setUint16(84 + 48, 31, true);
  view.setUint16(84 + 98, 0x8000, true);
  const { parts } = readStl("a.stl", { name: "a.stl", bytes: new Uint8Array(view.buffer) });
  expect(Array.from(parts[0].colors ?? [])).toEqual([...[1, 0, 0, 1, 0, 0, 1, 0, 0], ...[0, 0, 1, 0, 0, 1, 0, 0, 1]]);
});
