import { describe, expect, it } from "vitest";

import type { Built, BuiltPart } from "../../src/io/gltf/build";
import { ModelError, type NamedFile } from "../../src/io/named-file";
import { readClips } from "../../src/io/clips/read-clips";
import { readModel } from "../../src/io/read-model";
import { checkInstances } from "../../src/io/three-scene/check-instances";
import { read3mf } from "../../src/io/three-scene/read-3mf";
import { readDae } from "../../src/io/three-scene/read-dae";
import { readFbx } from "../../src/io/three-scene/read-fbx";
import type { BuiltScene, SceneSource } from "../../src/io/three-scene/read-scene";
import { readUsd } from "../../src/io/three-scene/read-usd";
import { inSurroundings } from "../../src/io/three-scene/surroundings";
import { parseXml } from "../../src/io/three-scene/xml";
import { hasShared, PNG, sharedFile, textFile } from "../support/files";
import {
  binaryFbx,
  dae,
  type FbxNode,
  fbxScene,
  INSTANCE,
  model3mf,
  painted,
  polygons,
  strips,
  tetra3mf,
  textFbx,
  threeMf,
  usda,
  zipped,
} from "../support/scenes";

function read(reader: (source: SceneSource) => BuiltScene, file: NamedFile, ...beside: NamedFile[]): BuiltScene & { notes: string[] } {
  const notes: string[] = [];
  return { ...reader({ name: file.name, file, files: [file, ...beside], notes }), notes };
}

const bytesFile = (name: string, bytes: Uint8Array): NamedFile => ({ name, bytes });
const PICTURE = bytesFile("elsewhere/fur.png", PNG);

async function refusal(file: NamedFile): Promise<string> {
  const error: unknown = await readModel([file]).catch((caught: unknown) => caught);
  expect(error).toBeInstanceOf(ModelError);
  return (error as ModelError).message;
}

/** Least and largest place that a triangle has. */
function box(...parts: readonly BuiltPart[]): number[][] {
  const used = parts.flatMap(({ positions, index }) => Array.from(index, (v) => [0, 1, 2].map((k) => positions[3 * v + k])));
  return [Math.min, Math.max].map((least) => [0, 1, 2].map((k) => least(...used.map((p) => p[k]))));
}

/** Six times the signed volume: tells that faces kept their turn. */
function volume({ positions: p, index }: BuiltPart): number {
  let sum = 0;
  for (let f = 0; f < index.length; f += 3) {
    const [a, b, c] = [3 * index[f], 3 * index[f + 1], 3 * index[f + 2]];
    sum += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]);
    sum += p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum;
}

const near = (values: number[], digits = 6): number[] => values.map((x) => expect.closeTo(x, digits) as number);
const baseColor = (built: Built, material: number): unknown => built.materials?.[material].pbrMetallicRoughness;

describe("FBX", () => {
  it("reads text and binary alike: where the node stands, its material, in metres", () => {
    for (const file of [textFile("t.fbx", textFbx(fbxScene())), bytesFile("t.fbx", binaryFbx(fbxScene()))]) {
      const built = read(readFbx, file);
      expect(built.parts).toHaveLength(1);
      expect(built.parts[0].name).toBe("Head");
      expect(box(...built.parts)).toEqual([near([0, 0.5, 0]), near([1, 1.5, 1])]);
      expect(volume(built.parts[0])).toBeCloseTo(1, 5);
      expect(baseColor(built, built.parts[0].material ?? -1)).toMatchObject({ baseColorFactor: [1, 0, 0, 1], metallicFactor: 0 });
    }
  });

  it("takes the file's unit and its axis", () => {
    const built = read(readFbx, bytesFile("t.fbx", binaryFbx(fbxScene({ unit: 100, up: 2 }))));
    expect(box(...built.parts)).toEqual([near([0, 0, -150], 4), near([100, 100, -50], 4)]);
  });

  it("finds the picture that it holds, and the one that it names on another machine", () => {
    const video = (content: FbxNode[], path: string): FbxNode[] => [
      { name: "Video", values: [40n, "V\u0000\u0001Video", "Clip"], nodes: [{ name: "RelativeFilename", values: [path] }, ...content] },
      { name: "Texture", values: [50n, "T\u0000\u0001Texture", ""], nodes: [{ name: "FileName", values: [path] }] },
    ];
    const links = [
      [40n, 50n],
      [50n, 30n, "DiffuseColor"],
    ] as const;
    const beside = read(readFbx, bytesFile("t.fbx", binaryFbx(fbxScene({ objects: video([], "C:\\art\\fur.png"), links }))), PICTURE);
    expect(beside.pictures).toMatchObject([{ name: "fur.png", picture: { bytes: PNG, mime: "image/png" } }]);
    expect(baseColor(beside, 0)).toMatchObject({ baseColorTexture: { index: 0 } });
    expect(beside.notes).toEqual([]);
    const text = btoa(String.fromCharCode(...PNG));
    const held = textFbx(fbxScene({ objects: video([{ name: "Content", values: [text] }], "fur.png"), links }));
    expect(read(readFbx, textFile("t.fbx", held)).pictures).toMatchObject([{ picture: { bytes: PNG, mime: "image/png" } }]);
    const alone = read(readFbx, textFile("t.fbx", textFbx(fbxScene({ objects: video([], "../fur.png"), links }))));
    expect(alone.pictures).toMatchObject([{ name: "fur.png", picture: null }]);
    expect(alone.notes).toEqual(["This model names fur.png; drop it too."]);
  });

  it("a motion without a mesh says so, and one that is broken does not take the mesh with it", async () => {
    const bone: FbxNode = {
      name: "Model",
      values: [60n, "Hips\u0000\u0001Model", "LimbNode"],
      nodes: [{ name: "Version", values: [232] }],
    };
    const curve: FbxNode = { name: "AnimationCurve", values: [70n, "C\u0000\u0001AnimCurve", ""] };
    const lone = binaryFbx(fbxScene({ mesh: false, objects: [bone], links: [[60n, 0n]] }));
    expect(await refusal(bytesFile("walk.fbx", lone))).toBe(
      "walk.fbx holds a skeleton of 1 joint, but no mesh. Motions are read from BVH, ASF with AMC, glTF, GLB or FBX.",
    );
    const links = [
      [60n, 0n],
      [70n, 60n],
    ] as const;
    for (const write of [binaryFbx, (nodes: FbxNode[]) => new TextEncoder().encode(textFbx(nodes))]) {
      const built = read(readFbx, bytesFile("t.fbx", write(fbxScene({ objects: [bone, curve], links }))));
      expect(built.parts).toHaveLength(1);
      expect(built.joints).toEqual([{ name: "Hips", parent: null, position: [0, 0, 0] }]);
    }
  });

  it.skipIf(!hasShared)("a motion of a stranger", async () => {
    const [clip] = await readClips([sharedFile("wild/91_50.fbx")]);
    expect([clip.name, clip.seconds.toFixed(2), clip.motion.input.text.match(/JOINT/g)?.length]).toEqual(["91_50 91_50", "5.50", 42]);
  });

  const sound = binaryFbx(fbxScene());
  const changed = (from: string, shift: number, value: number, file = sound): Uint8Array => {
    const out = file.slice();
    new DataView(out.buffer).setUint32(Buffer.from(out).indexOf(from) + shift, value, true);
    return out;
  };
  const broken =
    "t.fbx is a broken FBX file: it ends early or its parts do not fit. It may have been cut short: fetch or save it once more.";
  const bomb = fbxScene({
    objects: [{ name: "Bomb", values: [{ letter: "d", items: new Array<number>(200_000).fill(0), packed: true }] }],
  });
  it.each([
    ["is cut short", sound.subarray(0, -300), broken],
    ["has a node that ends before it begins", changed("Objects", -13, 5), broken],
    ["has a node beyond the end", changed("Objects", -13, 4e9), broken],
    ["has more values than it holds", changed("Objects", -9, 4e9), broken],
    ["has an array beyond the end", changed("PolygonVertexIndex", 19, 4e7), broken],
    ["unpacks to gigabytes", changed("PolygonVertexIndex", 19, 4e9), "t.fbx would unpack to more than 512 MB. We did not open it."],
    ["unpacks to more than it says", changed("Bomb", 5, 10, binaryFbx(bomb)), broken],
    [
      "is too old",
      binaryFbx(fbxScene(), 6100),
      "t.fbx is an FBX of version 6.1, which is too old to be read. " +
        "Open it in Blender or Autodesk's free FBX Converter, and save it as FBX 2013 or later, or as glTF.",
    ],
  ])("refuses one that %s", async (_, bytes, message) => {
    expect(await refusal(bytesFile("t.fbx", bytes))).toBe(message);
  });
});

describe("DAE", () => {
  it("reads its mesh, the picture beside it, its unit and its axis", () => {
    const asset = '<unit meter="0.01" name="cm"/><up_axis>Z_UP</up_axis>';
    const built = read(readDae, textFile("t.dae", dae({ asset, libraries: painted("file:///C:/art/fur.png") })), PICTURE);
    expect(box(...built.parts)).toEqual([near([0, 0, -1]), near([1, 1, 0])]);
    expect(volume(built.parts[0])).toBeCloseTo(1, 5);
    expect(built.pictures).toMatchObject([{ name: "fur.png", picture: { bytes: PNG } }]);
    expect(built.materials).toMatchObject([{ name: "Fur", pbrMetallicRoughness: { baseColorTexture: { index: 0 }, roughnessFactor: 1 } }]);
    expect(Array.from(built.parts[0].uvs?.[0] ?? []).slice(0, 4)).toEqual([0, 1, 0, 0.75]);
  });

  it("a TGA beside it is no more fetched than any other picture", () => {
    const built = read(readDae, textFile("t.dae", dae({ libraries: painted("fur.tga") })));
    expect(built.notes).toEqual(["This model names fur.tga; drop it too."]);
  });

  it("strips are triangles, and a comma may be a point", () => {
    const strip = read(readDae, textFile("t.dae", dae({ primitives: strips("0 0 1 1 2 2 3 3") })));
    expect(strip.parts[0].index).toHaveLength(6);
    const comma = dae({ asset: '<unit meter="0,5"/>' }).replace("100 0 0", "100,0 0 0");
    expect(box(...read(readDae, textFile("t.dae", comma)).parts)).toEqual([near([0, 0, 0]), near([50, 50, 50])]);
  });

  it("what it names and does not hold is left out", () => {
    const nodes = `${INSTANCE}<node id="c"><instance_camera url="#gone"/><instance_geometry url="#gone"/></node>`;
    const built = read(readDae, textFile("t.dae", dae({ nodes }).replace(/<asset>.*<\/asset>|<scene>.*<\/scene>/g, "")));
    expect(built.parts).toHaveLength(1);
    expect(built.parts[0].material).toBeUndefined();
  });

  it.each([
    ["no XML", "hello", /^t\.dae is broken in line 1: /],
    ["an open tag", dae().slice(0, -10), /^t\.dae is broken in line \d+: .* It may have been cut short/],
    ["no COLLADA", "<svg/>", "t.dae holds no COLLADA scene."],
    ["no mesh", dae({ nodes: "" }), "t.dae holds no mesh. Save the model itself into it, not a camera or an empty scene."],
    [
      "more corners than indices",
      dae({ primitives: polygons("1000000000", "0 0 1 1 2 2") }),
      "t.dae promises 1,000,000,000 corners, more than it holds.",
    ],
    [
      "nodes in a circle",
      dae({ nodes: '<node id="a"><instance_node url="#b"/></node><node id="b"><instance_node url="#a"/></node>' }),
      't.dae is broken: "a" holds itself.',
    ],
    [
      "nodes that double forty times",
      dae({
        nodes:
          Array.from({ length: 40 }, (_, k) => `<node id="n${k + 1}">${`<instance_node url="#n${k}"/>`.repeat(2)}</node>`).join("") +
          INSTANCE.replace('id="n"', 'id="n0"'),
      }),
      "t.dae holds more than 20,000 copies of its parts, too many to be drawn.",
    ],
    ["elements in elements", `<COLLADA>${"<node>".repeat(200_000)}`, "t.dae puts more than 500 elements into each other."],
  ])("refuses %s", async (_, text, message) => {
    expect(await refusal(textFile("t.dae", text))).toMatch(message);
  });
});

describe("3MF", () => {
  const object = (id: string, inside: string): string => `<object id="${id}" type="model">${inside}</object>`;

  it("stands up, in metres, each copy in its place", () => {
    const items = '<item objectid="1"/><item objectid="1" transform="1 0 0 0 1 0 0 0 1 20 0 0"/>';
    const built = read(read3mf, threeMf(object("1", tetra3mf(10)), items));
    expect(built.parts).toHaveLength(2);
    expect(box(...built.parts)).toEqual([near([0, 0, -0.01]), near([0.03, 0.01, 0])]);
    expect(volume(built.parts[0])).toBeGreaterThan(0);
    const inches = read(read3mf, threeMf(object("1", tetra3mf(10)), '<item objectid="1"/>', {}, "inch"));
    expect(box(...inches.parts)[1]).toEqual(near([0.254, 0.254, 0]));
  });

  it("parts count their objects for themselves", () => {
    const part = (size: number): string => model3mf(object("1", tetra3mf(size)), "");
    const component = (path: string): string => `<component p:path="/3D/Objects/${path}" objectid="1"/>`;
    const built = read(
      read3mf,
      threeMf(object("7", `<components>${component("a.model")}${component("b.model")}</components>`), '<item objectid="7"/>', {
        "3D/Objects/a.model": part(10),
        "3D/Objects/b.model": part(30),
      }),
    );
    expect(built.parts.map((one) => box(one)[1][0])).toEqual([expect.closeTo(0.01), expect.closeTo(0.03)]);
  });

  it("keeps colours, and the picture that it holds", () => {
    const colors = '<m:colorgroup id="5"><m:color color="#FF0000"/></m:colorgroup>';
    const red = read(read3mf, threeMf(colors + object("1", tetra3mf(10, 'pid="5" p1="0"')), '<item objectid="1"/>'));
    expect(Array.from(red.parts[0].colors ?? []).slice(0, 3)).toEqual([1, 0, 0]);
    const texture =
      '<m:texture2d id="5" path="/3D/Textures/fur.png" contenttype="image/png"/>' +
      '<m:texture2dgroup id="6" texid="5"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/>' +
      '<m:tex2coord u="0" v="1"/></m:texture2dgroup>';
    const rels = '<Relationships><Relationship Target="/3D/Textures/fur.png" Id="r" Type="texture"/></Relationships>';
    const mapped = threeMf(texture + object("1", tetra3mf(10, 'pid="6" p1="0" p2="1" p3="2"')), '<item objectid="1"/>', {
      "3D/Textures/fur.png": PNG,
      "3D/_rels/3dmodel.model.rels": rels,
    });
    const built = read(read3mf, mapped);
    expect(built.pictures).toMatchObject([{ picture: { bytes: PNG, mime: "image/png" } }]);
    expect(baseColor(built, built.parts[0].material ?? -1)).toMatchObject({ baseColorTexture: { index: 0 } });
  });

  const doubled = Array.from({ length: 40 }, (_, k) =>
    object(String(k + 1), `<components>${`<component objectid="${k}"/>`.repeat(2)}</components>`),
  );
  it.each([
    [
      "an object in itself",
      threeMf(object("1", '<components><component objectid="1"/></components>'), '<item objectid="1"/>'),
      /holds itself\.$/,
    ],
    [
      "objects that double forty times",
      threeMf(object("0", tetra3mf(1)) + doubled.join(""), '<item objectid="40"/>'),
      "t.3mf holds more than 20,000 copies of its parts, too many to be drawn.",
    ],
    ["an empty build", threeMf(object("1", tetra3mf(1)), ""), /^t\.3mf (holds no mesh|is a broken 3MF file)/],
    ["a broken archive", bytesFile("t.3mf", threeMf(object("1", tetra3mf(1)), "").bytes.subarray(0, 300)), /^t\.3mf is a broken zip/],
    ["no model", bytesFile("t.3mf", zipped("x.zip", { "a.txt": "hello" }).bytes), "t.3mf holds no 3D model."],
  ])("refuses %s", async (_, file, message) => {
    const named = { ...file, name: "t.3mf" };
    await expect(Promise.resolve().then(() => read(read3mf, named))).rejects.toThrow(message);
  });
});

/** A binary USD that promises tokens. */
function crate(tokens: bigint): Uint8Array {
  const bytes = new Uint8Array(200);
  const view = new DataView(bytes.buffer);
  bytes.set(new TextEncoder().encode("PXR-USDC"));
  bytes[9] = 8;
  view.setBigUint64(16, 32n, true);
  view.setBigUint64(32, 1n, true);
  bytes.set(new TextEncoder().encode("TOKENS"), 40);
  view.setBigUint64(56, 80n, true);
  view.setBigUint64(80, tokens, true);
  return bytes;
}

describe("USDZ", () => {
  it("reads the scene, its material and the picture in it", () => {
    const built = read(readUsd, zipped("t.usdz", { "t.usda": usda(), "tex/fur.png": PNG }));
    expect(box(...built.parts)).toEqual([near([0, 0, 0]), near([1, 1, 1])]);
    expect(volume(built.parts[0])).toBeCloseTo(1, 5);
    expect(built.pictures).toMatchObject([{ picture: { bytes: PNG } }]);
    expect(built.materials).toMatchObject([
      { pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0.2, roughnessFactor: 0.3 } },
    ]);
  });

  it("reads a bare layer with the picture beside it, and its axis", () => {
    const built = read(readUsd, textFile("t.usda", usda('upAxis = "Z"')), PICTURE);
    expect(box(...built.parts)).toEqual([near([0, 0, -1]), near([1, 1, 0])]);
    expect(built.pictures).toMatchObject([{ name: "fur.png", picture: { bytes: PNG } }]);
  });

  it.each([
    ["no scene in it", bytesFile("t.usdz", zipped("t.usdz", { "a.txt": "x" }).bytes), "t.usdz holds no USD scene."],
    ["no mesh", textFile("t.usda", "#usda 1.0\n"), "t.usda holds no mesh. Save the model itself into it, not a camera or an empty scene."],
    [
      "faces of more corners than indices",
      textFile("t.usda", usda('upAxis = "Y"', "[(0,0,0),(1,0,0),(0,1,0),(0,0,1)]", "[3,999999999,3,3]")),
      "t.usda promises more than it holds: it is broken. Save it once more, or as GLB.",
    ],
    ["a crate of 2^60 tokens", bytesFile("t.usdc", crate(1n << 60n)), "t.usdc promises more than it holds"],
    ["a cut crate", bytesFile("t.usdc", new TextEncoder().encode("PXR-USDC\u0000\u0007")), /^t\.usdc is a broken USD file/],
  ])("refuses %s", (_, file, message) => {
    expect(() => read(readUsd, file)).toThrow(message);
  });
});

describe("what loaders expect around them", () => {
  it("is there while they parse and gone after it, also when they fail", () => {
    const keys = ["document", "window", "DOMParser", "fetch", "Request", "Blob", "console"] as const;
    const before = keys.map((key) => (globalThis as Record<string, unknown>)[key]);
    const [make, had] = [URL.createObjectURL, keys.map((key) => key in globalThis)];
    expect(inSurroundings("t", () => typeof (globalThis as Record<string, unknown>).document)).toBe("object");
    expect(() =>
      inSurroundings("t", () => {
        throw new RangeError("no");
      }),
    ).toThrow(RangeError);
    expect(keys.map((key) => (globalThis as Record<string, unknown>)[key])).toEqual(before);
    expect(keys.map((key) => key in globalThis)).toEqual(had);
    expect(URL.createObjectURL).toBe(make);
  });

  it("XML: text, names, prefixes and selectors", () => {
    const document = parseXml("t", '<a xmlns:m="x"><b id="1">one &amp; <![CDATA[<two>]]></b><m:c k="v"><b/></m:c></a>');
    expect(document.documentElement.nodeName).toBe("a");
    expect(document.querySelector("b")?.textContent).toBe("one & <two>");
    expect(document.querySelectorAll("c b")).toHaveLength(1);
    expect(document.querySelectorAll("a b")).toHaveLength(2);
    expect(document.querySelector('[id="1"]')?.nodeName).toBe("b");
    expect(document.getElementsByTagNameNS("x", "c")[0].getAttribute("k")).toBe("v");
    expect(document.getElementsByTagName("c")).toEqual([]);
    expect(document.getElementsByTagName("b")[0].getAttribute("none")).toBeNull();
  });

  it("copies are counted without being made", () => {
    checkInstances("t", new Map([["a", Array.from({ length: 19_000 }, () => "b")]]));
    expect(() => checkInstances("t", new Map([["a", Array.from({ length: 21_000 }, () => "b")]]))).toThrow("20,000 copies");
  });
});
