import { unzlibSync } from "fflate";
import { describe, expect, it, vi } from "vitest";

import type { NamedFile } from "../../src/io/named-file";
import { pictureFormat } from "../../src/io/picture";
import { readModel } from "../../src/io/read-model";
import { textFile } from "../support/files";

vi.setConfig({ testTimeout: 120_000 }); // loads three.js first

const WIDTH = 3;
/** Two rows, the top one first: red, green, blue; white, black, grey. */
const RGB = [255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 128, 128, 128];
const pixel = (x: number, y: number): number[] => RGB.slice(3 * (WIDTH * y + x), 3 * (WIDTH * y + x) + 3);
const rgba = Array.from({ length: 6 }, (_, i) => [...RGB.slice(3 * i, 3 * i + 3), 255]).flat();

function tga(topFirst: boolean, packed: boolean): Uint8Array {
  const rows = (topFirst ? [0, 1] : [1, 0]).map((y) => [0, 1, 2].map((x) => pixel(x, y).toReversed()));
  const body = rows.flatMap((row) => (packed ? [2, ...row.flat()] : row.flat()));
  return Uint8Array.of(0, 0, packed ? 10 : 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, WIDTH, 0, 2, 0, 24, topFirst ? 0x20 : 0, ...body);
}

function bmp(bits: 8 | 24 | 32, topFirst = false): Uint8Array {
  const colors = Array.from({ length: 6 }, (_, i) => pixel(i % WIDTH, Math.floor(i / WIDTH)).toReversed());
  const palette = bits === 8 ? colors.flatMap((color) => [...color, 0]) : [];
  const row = (y: number): number[] => {
    const bytes = [0, 1, 2].flatMap((x) => (bits === 8 ? [WIDTH * y + x] : [...colors[WIDTH * y + x], ...(bits === 32 ? [0] : [])]));
    return [...bytes, ...Array<number>((4 - (bytes.length % 4)) % 4).fill(0)];
  };
  const body = (topFirst ? [0, 1] : [1, 0]).flatMap(row);
  const out = new Uint8Array(54 + palette.length + body.length);
  const view = new DataView(out.buffer);
  out.set([0x42, 0x4d]);
  view.setUint32(2, out.length, true);
  view.setUint32(10, 54 + palette.length, true);
  view.setUint32(14, 40, true);
  view.setInt32(18, WIDTH, true);
  view.setInt32(22, topFirst ? -2 : 2, true);
  view.setUint16(26, 1, true);
  view.setUint16(28, bits, true);
  out.set([...palette, ...body], 54);
  return out;
}

/** Of a PNG as we write it: each row behind a filter that is none. */
function pixelsOf(png: Uint8Array): number[] {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  expect([view.getUint32(16), view.getUint32(20)]).toEqual([WIDTH, 2]);
  const rows = unzlibSync(png.subarray(41, 41 + view.getUint32(33)));
  return [...rows.subarray(1, 13), ...rows.subarray(14, 26)];
}

const obj = (picture: NamedFile, named = picture.name) =>
  readModel([
    textFile(
      "a.obj",
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nusemtl m\nf 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2/1 3/1 4/1\n",
    ),
    textFile("a.mtl", `newmtl m\nmap_Kd ${named}\n`),
    picture,
  ]);

describe("pictures that a GLB may not hold", () => {
  it.each([
    ["tga from below", "fur.tga", tga(false, false)],
    ["tga from above", "fur.tga", tga(true, false)],
    ["packed tga", "fur.tga", tga(false, true)],
    ["bmp", "fur.bmp", bmp(24)],
    ["bmp from above", "fur.bmp", bmp(24, true)],
    ["bmp of a palette", "fur.bmp", bmp(8)],
    ["bmp whose alpha is not used", "fur.bmp", bmp(32)],
  ])("%s becomes the same picture as PNG, found by its last name", async (_, name, bytes) => {
    const { document, notes } = await obj({ name, bytes }, `C:\\art\\${name}`);
    expect(notes.filter((note) => note.includes("fur"))).toEqual([]);
    expect(document.json.images).toMatchObject([{ name, mimeType: "image/png" }]);
    const [picture] = document.images;
    expect(picture).toMatchObject({ mime: "image/png", drawn: true });
    expect(pixelsOf(picture!.bytes)).toEqual(rgba);
  });

  it("one that is cut short is kept, not drawn, and said", async () => {
    const whole = bmp(24);
    const { document, notes } = await obj({ name: "fur.bmp", bytes: whole.subarray(0, whole.length - 4) });
    expect(document.images).toMatchObject([{ mime: "image/bmp", drawn: false }]);
    expect(notes).toContain("fur.bmp is of a kind that we cannot show. Save it as a PNG picture to see it.");
  });

  it("numbers are no TGA", () => {
    for (const words of [
      [0, 1, 2, 0, 2, 3, 4, 5, 16, 6, 7, 8, 9],
      [0, 2, 1, 3, 2, 1, 5, 6, 24, 1, 1, 1, 1],
    ]) {
      expect(pictureFormat(new Uint8Array(Uint16Array.from(words).buffer))).toBeUndefined();
    }
  });
});

describe("KTX2", () => {
  /** Only what is looked at before a worker decodes it. */
  function ktx2(vkFormat: number): Uint8Array {
    const out = new Uint8Array(160);
    const view = new DataView(out.buffer);
    out.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]);
    [vkFormat, 1, 8, 4].forEach((word, k) => view.setUint32(12 + 4 * k, word, true));
    return out;
  }

  it("is drawn where it is for any graphics card, and kept in a model that is built as glTF names it", async () => {
    const { document, notes } = await obj({ name: "fur.ktx2", bytes: ktx2(0) });
    expect(notes).toEqual([]);
    expect(document.images).toMatchObject([{ mime: "image/ktx2", drawn: true }]);
    expect(document.json.textures).toEqual([{ extensions: { KHR_texture_basisu: { source: 0 } } }]);
    expect(document.json.extensionsUsed).toEqual(["KHR_texture_basisu"]);
  });

  it("is kept and said where it is for one kind of card", async () => {
    const { document, notes } = await obj({ name: "fur.ktx2", bytes: ktx2(145) }); // BC7
    expect(document.images).toMatchObject([{ bytes: ktx2(145), drawn: false }]);
    expect(notes).toEqual([expect.stringMatching(/^fur\.ktx2 is a KTX2 picture for one kind of graphics card, kept but not shown\./)]);
  });
});
