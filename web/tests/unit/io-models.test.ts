import { describe, expect, it } from "vitest";

import { ModelError } from "../../src/io/named-file";
import { type Model, readModel } from "../../src/io/read-model";
import { PNG, TETRAHEDRON, textFile } from "../support/files";
import { laidOn } from "../support/gltf";

const read = (name: string, text: string, ...beside: Parameters<typeof readModel>[0]): Promise<Model> =>
  readModel([textFile(name, text), ...beside]);

async function refusal(name: string, content: string | Uint8Array): Promise<string> {
  const file = typeof content === "string" ? textFile(name, content) : { name, bytes: content };
  const error: unknown = await readModel([file]).then(
    () => null,
    (caught: unknown) => caught,
  );
  expect(error).toBeInstanceOf(ModelError);
  return (error as ModelError).message;
}

/** Solver vertices, faces, and render vertices, which creases split. */
const sizes = (model: Model): number[] => [model.positions.length / 3, model.faces.length / 3, model.drawn.toVertex.length];

/** Twice the signed volume: tells that faces kept their turn. */
function volume({ positions: p, faces }: Model): number {
  let sum = 0;
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]];
    sum +=
      p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) +
      p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
      p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return sum / 6;
}

const CUBE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
const CUBE_FACES = [
  [1, 4, 3, 2],
  [5, 6, 7, 8],
  [1, 2, 6, 5],
  [2, 3, 7, 6],
  [3, 4, 8, 7],
  [4, 1, 5, 8],
];

describe("OBJ", () => {
  it("reads polygons", async () => {
    const model = await read("cube.obj", CUBE + CUBE_FACES.map((f) => `f ${f.join(" ")}`).join("\n"));
    expect(sizes(model)).toEqual([8, 12, 24]);
    expect(volume(model)).toBeCloseTo(1, 6);
  });

  it("reads a pentagon and negative indices", async () => {
    const model = await read("house.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf -5 -4 -3 -2 -1\n");
    expect(sizes(model)).toEqual([5, 3, 5]);
  });

  it("keeps seams: one vertex, two places in the picture; v is turned down", async () => {
    const model = await read(
      "seam.obj",
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 .25\nvt .5 .5\nf 1/1 2/2 3/3\nf 1/4 3/3 4/2\n",
    );
    expect(sizes(model)).toEqual([4, 2, 5]);
    expect(laidOn(model, "TEXCOORD_0", 2)?.slice(0, 6)).toEqual([0, 1, 1, 1, 1, 0.75]);
  });

  it("keeps vertex colours, linear", async () => {
    const model = await read("rgb.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    expect(laidOn(model, "COLOR_0", 3)).toEqual([1, 0, 0, 0, expect.closeTo(0.214, 4), 0, 0, 0, 1]);
  });

  it("takes colours and the picture from the material file beside it", async () => {
    const mtl = textFile("m/wood.mtl", "newmtl oak\nKd 1 1 1\nmap_Kd -s 1 1 1 tex/wood grain.png\n");
    const text = "mtllib m/wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl oak\nf 1/1 2/1 3/1\n";
    const dressed = await read("table.obj", text, mtl, { name: "m/tex/wood grain.png", bytes: PNG });
    expect(dressed.document.images).toEqual([{ bytes: PNG, mime: "image/png", drawn: true }]);
    expect(dressed.document.json.materials?.[0].pbrMetallicRoughness?.baseColorTexture).toEqual({ index: 0 });
    expect(dressed.notes).toEqual([]);
    const plain = await read("table.obj", text, mtl);
    expect(plain.document.images).toEqual([null]);
    expect(plain.notes).toEqual(["This model names wood grain.png; drop it too."]);
    const red = await read("table.obj", text, textFile("wood.mtl", "newmtl oak\nKd 1 0 0\n"));
    expect(red.document.json.materials?.[0].pbrMetallicRoughness?.baseColorFactor).toEqual([1, 0, 0, 1]);
  });

  it("leaves out lines, loose points, faces without area and faces that are there twice, and says so", async () => {
    const model = await read("mess.obj", `${TETRAHEDRON}v 9 9 9\nv 8 8 8\nl 1 2\np 5\nf 1 3 2\nf 3 2 1\nf 1 1 2\nf 2 3 1\n`);
    expect(sizes(model)).toEqual([4, 5, 11]); // the fifth face is the first one turned over: another side
    expect(model.notes).toEqual(["Left out 2 loose points that no face uses.", "Left out 3 triangles without area or there twice."]);
  });

  it("reads every kind of line end, continued lines and tabs", async () => {
    for (const end of ["\r\n", "\r"]) expect(sizes(await read("t.obj", TETRAHEDRON.replaceAll("\n", end)))).toEqual([4, 4, 12]);
    expect(sizes(await read("t.obj", TETRAHEDRON.replace("f 1 3 2", "f\t1 \\\n 3 2")))).toEqual([4, 4, 12]);
  });

  it.each([
    ["f 1 2 9", "bad.obj, line 9: a face names vertex 9, but there are 4 vertices above it."],
    ["f 1 2 -5", "bad.obj, line 9: a face names vertex -5, but there are 4 vertices above it."],
    ["f 1 2 0", 'bad.obj, line 9: "0" names no vertex.'],
    ["f 1 2 x", 'bad.obj, line 9: "x" names no vertex.'],
    ["f 1 2", "bad.obj, line 9: a face needs three corners."],
    ["v 0 nan 0", 'bad.obj, line 9: "nan" is not a number.'],
    ["v 0 inf 0", 'bad.obj, line 9: "inf" is not a number.'],
    ["v 1,5 0 0", 'bad.obj, line 9: "1,5" is not a number.'],
    ["v 1 0", "bad.obj, line 9: a vertex needs three numbers."],
  ])("names the line of %s", async (line, message) => {
    expect(await refusal("bad.obj", TETRAHEDRON + line + "\n")).toBe(message);
  });

  it.each([
    ["", "bad.obj is empty."],
    ["v 0 0 0\nv 1 0 0\nv 0 1 0\n", "bad.obj has 3 points but no faces."],
    ["Dear diary, today I saw a cow.\n", "bad.obj holds no OBJ model."],
    ["\u0000\u0001\u0002binary", "bad.obj is not text, so it is no OBJ model."],
    ["v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "bad.obj has all its corners on one spot."],
    ["v 0 0 0\nv 1 0 0\nf 1 2 1\n", "bad.obj has no triangle with an area."],
    [TETRAHEDRON.replace("v 1 0 0", "v 1e300 0 0"), 'bad.obj, line 2: "1e300" is not a number.'],
  ])("refuses %j", async (text, message) => {
    expect(await refusal("bad.obj", text)).toBe(message);
  });
});

describe("OFF", () => {
  const off = "# a comment\nOFF # kind\n4 4 6\n\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2 255 0 0\n3 1 2 3 # last\n";

  it("reads comments, counts on the first line, face colours and polygons", async () => {
    expect(sizes(await read("t.off", off))).toEqual([4, 4, 12]);
    expect(volume(await read("t.off", off))).toBeCloseTo(1 / 6, 6);
    expect(sizes(await read("q.off", "OFF 4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"))).toEqual([4, 2, 4]);
  });

  it("reads colours and normals of vertices", async () => {
    const bytes = await read("c.off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n");
    expect(laidOn(bytes, "COLOR_0", 3)).toEqual([1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const both = await read("cn.off", "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n0 1 0 0 0 1 1 0 0 1\n3 0 1 2\n");
    expect(laidOn(both, "COLOR_0", 3)).toEqual([1, 0, 0, 1, 0, 0, 1, 0, 0]);
  });

  it.each([
    [off.replace("3 1 2 3", "3 1 2 4"), "t.off, line 12: a face names vertex 4, but the last one is 3."],
    [off.replace("3 1 2 3", "4 1 2 3"), "t.off, line 12: a face of 4 corners names only 3."],
    [off.replace("0 1 0", "0 nan 0"), 't.off, line 7: "nan" is not a number.'],
    [off.replace("0 1 0", "0 1"), "t.off, line 7: a number is missing."],
    [off.replace("4 4 6", "4 5 6"), "t.off ends before face 5 of 5."],
    [off.replace("4 4 6", "999999999 4 6"), "t.off promises 999,999,999 vertices and 4 faces, more than it can hold."],
    [off.replace("4 4 6", "-4 4 6"), "t.off, line 3: -4 should be a whole number from 0."],
    ["OFF BINARY\n", "t.off is a binary OFF. Save it as text."],
    ["4OFF\n1 1 1\n", "t.off is not three-dimensional (4OFF)."],
    ["intro\n", "t.off does not begin with OFF."],
    ["OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "t.off has no triangles."],
  ])("refuses %j", async (text, message) => {
    expect(await refusal("t.off", text)).toBe(message);
  });
});

describe("PLY", () => {
  const header = (format: string): string =>
    `ply\nformat ${format} 1.0\ncomment made by hand\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n` +
    "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\n" +
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  const rows = [
    [0, 0, 0],
    [2, 0, 0],
    [2, 1, 0],
    [1, 2, 0],
    [0, 1, 0],
  ];
  const ascii = header("ascii") + rows.map((row) => `${row.join(" ")} 255 0 0\n`).join("") + "5 0 1 2 3 4\n0 1\n";

  function binary(little: boolean): Uint8Array {
    const view = new DataView(new ArrayBuffer(5 * 15 + 21 + 8));
    rows.forEach((row, v) => {
      row.forEach((x, k) => view.setFloat32(15 * v + 4 * k, x, little));
      view.setUint8(15 * v + 12, 255);
    });
    view.setUint8(75, 5);
    for (let k = 0; k < 5; k++) view.setInt32(76 + 4 * k, k, little);
    return Buffer.concat([Buffer.from(header(little ? "binary_little_endian" : "binary_big_endian")), new Uint8Array(view.buffer)]);
  }

  it("reads text and both binary kinds, with a face of five corners", async () => {
    for (const bytes of [Buffer.from(ascii), binary(true), binary(false)]) {
      const model = await readModel([{ name: "house.ply", bytes }]);
      expect(sizes(model)).toEqual([5, 3, 5]);
      expect([...model.positions]).toEqual(rows.flat());
      expect(laidOn(model, "COLOR_0", 3)?.slice(0, 3)).toEqual([1, 0, 0]);
    }
  });

  it.each([
    [ascii.replace("5 0 1 2 3 4", "5 0 1 2 3 5"), "house.ply: face 1 names vertex 5, but there are 5 vertices."],
    [ascii.replace("5 0 1 2 3 4", "5 0 1 2 3 -1"), "house.ply: face 1 names vertex -1, but there are 5 vertices."],
    [ascii.replace("2 1 0 255", "2 nan 0 255"), 'house.ply: "nan" should be a number.'],
    [ascii.slice(0, -20), "house.ply ends before its last row."],
    [ascii.replace("vertex 5", "vertex 5000000"), 'house.ply promises 5000000 of "vertex", which cannot be.'],
    [ascii.replace("end_header", ""), "house.ply has no whole PLY header."],
    [ascii.replace("ascii", "utf"), 'house.ply is a PLY of an unknown format "utf".'],
    [ascii.replace("float x", "real x"), 'house.ply has a property of an unknown type: "property real x".'],
  ])("refuses a broken one: %#", async (text, message) => {
    expect(await refusal("house.ply", text)).toBe(message);
  });

  it("refuses a binary one that is cut short", async () => {
    expect(await refusal("house.ply", binary(true).subarray(0, -20))).toBe("house.ply ends before its last row.");
  });
});

describe("STL", () => {
  const corners = [
    [0, 2, 1],
    [0, 1, 3],
    [0, 3, 2],
    [1, 2, 3],
  ].map((f) =>
    f.map(
      (v) =>
        [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
        ][v],
    ),
  );
  const facets = corners.map((f) => `outer loop\n${f.map((v) => `vertex ${v.join(" ")}\n`).join("")}endloop\n`);
  const ascii = `solid t\n${facets.map((loop) => `facet normal 0 0 0\n${loop}endfacet\n`).join("")}endsolid t\n`;

  function binary(title: string): Uint8Array {
    const view = new DataView(new ArrayBuffer(84 + 50 * corners.length));
    [...title].forEach((letter, k) => view.setUint8(k, letter.charCodeAt(0)));
    view.setUint32(80, corners.length, true);
    corners.flat(2).forEach((x, k) => view.setFloat32(84 + 50 * Math.floor(k / 9) + 12 + 4 * (k % 9), x, true));
    return new Uint8Array(view.buffer);
  }

  it("welds triangles that know nothing of each other", async () => {
    for (const bytes of [
      Buffer.from(ascii),
      binary("by hand"),
      binary("solid but binary"),
      Buffer.concat([binary("solid"), Buffer.from("more")]),
    ]) {
      const model = await readModel([{ name: "t.stl", bytes }]);
      expect(sizes(model)).toEqual([4, 4, 12]);
      expect(volume(model)).toBeCloseTo(1 / 6, 6);
    }
  });

  it("welds corners that differ by rounding, not by more", async () => {
    const nearly = ascii.replace("vertex 1 0 0", "vertex 1.0000008 -0.0000007 0");
    expect(sizes(await read("t.stl", nearly))).toEqual([4, 4, 12]);
    expect(sizes(await read("t.stl", ascii.replace("vertex 1 0 0", "vertex 1.0001 0 0")))).toEqual([5, 4, 12]);
  });

  it.each<[string, string | Uint8Array]>([
    ["t.stl promises 4 triangles, but it ends after 3 triangles.", binary("cut").subarray(0, -10)],
    ['t.stl, line 5: "nan" is not a number.', ascii.replace("vertex 0 1 0", "vertex nan 1 0")],
    ["t.stl, line 5: a corner needs three numbers.", ascii.replace("vertex 0 1 0", "vertex 0 1")],
    ["t.stl, line 7: a triangle needs three corners, but this one has 2.", ascii.replace("vertex 0 1 0\n", "")],
    ['t.stl ends before "endsolid".', ascii.slice(0, -15)],
    ["t.stl has no triangles.", "solid nothing\nendsolid nothing\n"],
    ["t.stl holds no STL model.", "hello"],
    [
      "t.stl: the place of vertex 1 is not a number.",
      (() => {
        const b = binary("nan");
        new DataView(b.buffer).setFloat32(96, NaN, true);
        return b;
      })(),
    ],
  ])("%s", async (message, content) => {
    expect(await refusal("t.stl", content)).toBe(message);
  });
});

it("tells a model by what it holds when its name is wrong", async () => {
  expect(sizes(await read("t.obj", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))).toEqual([3, 1, 3]);
});

it("refuses coordinates that no number on the stage can hold", async () => {
  expect(await refusal("t.off", "OFF\n3 1 0\n0 0 0\n3e38 0 0\n0 1 0\n3 0 1 2\n")).toBe("t.off: vertex 2 is too far away (3.00e+38).");
});

it("names what is no model", async () => {
  expect(await refusal("letter.docx", "hello")).toBe("letter.docx is not a model that we read (OBJ, OFF, PLY, STL, glTF, GLB).");
});
