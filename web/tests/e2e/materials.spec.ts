import { deflateSync } from "node:zlib";
import { expect, type Page, test } from "@playwright/test";
import { buildDocument, type BuiltPart } from "../../src/io/gltf/build";
import { packGlb } from "../../src/io/gltf/write";
import { drop, open, pause, watchErrors } from "./page";

/** A PNG of one pixel; readers do not ask for its checksums, but browsers do. */
function onePixel(rgb: readonly number[]): Uint8Array {
  const chunk = (kind: string, data: Uint8Array): Buffer => {
    const body = Buffer.concat([Buffer.from(kind, "latin1"), data]);
    let crc = -1;
    for (const byte of body) {
      crc ^= byte;
      for (let k = 0; k < 8; k++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
    const [size, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
    size.writeUInt32BE(data.length);
    sum.writeInt32BE(~crc);
    return Buffer.concat([size, body, sum]);
  };
  const head = Uint8Array.of(0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0);
  const sign = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
  return Buffer.concat([sign, chunk("IHDR", head), chunk("IDAT", deflateSync(Uint8Array.of(0, ...rgb))), chunk("IEND", new Uint8Array(0))]);
}

/** A tower of three boxes, red and green by pictures, blue by a factor. */
function tower(): Buffer {
  const part = (material: number): BuiltPart => {
    const positions = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((c) => [c & 1 ? 0.5 : -0.5, material + (c & 2 ? 1 : 0), c & 4 ? 0.5 : -0.5]);
    const quads = [
      [4, 5, 7, 6],
      [1, 0, 2, 3],
      [5, 1, 3, 7],
      [0, 4, 6, 2],
      [6, 7, 3, 2],
      [0, 1, 5, 4],
    ]; // prettier-ignore
    return {
      positions,
      index: quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]),
      uvs: [positions.flatMap(() => 0).slice(0, 16)],
      material,
    };
  };
  const matt = { metallicFactor: 0, roughnessFactor: 1 };
  const document = buildDocument("tower", {
    parts: [0, 1, 2].map(part),
    materials: [
      { pbrMetallicRoughness: { ...matt, baseColorTexture: { index: 0 } } },
      { pbrMetallicRoughness: { ...matt, baseColorTexture: { index: 1 } } },
      { pbrMetallicRoughness: { ...matt, baseColorFactor: [0.01, 0.02, 0.8, 1] } },
    ],
    pictures: [
      [230, 20, 20],
      [20, 200, 20],
    ].map((rgb, k) => ({ name: `${k}.png`, picture: { bytes: onePixel(rgb), mime: "image/png", drawn: true } })),
  });
  return Buffer.from(packGlb(document));
}

/** How many pixels of the page are mostly red, green and blue. */
async function pixels(page: Page): Promise<number[]> {
  const shot = (await page.screenshot({ path: test.info().outputPath("tower.png") })).toString("base64");
  return page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const brush = new OffscreenCanvas(picture.width, picture.height).getContext("2d")!;
    brush.drawImage(picture, 0, 0);
    const rgba = brush.getImageData(0, 0, picture.width, picture.height).data;
    const counts = [0, 0, 0];
    for (let i = 0; i < rgba.length; i += 4) {
      for (let k = 0; k < 3; k++) {
        if (rgba[i + k]! > 90 && rgba[i + k]! > 2.2 * rgba[i + ((k + 1) % 3)]! && rgba[i + k]! > 2.2 * rgba[i + ((k + 2) % 3)]!)
          counts[k]!++;
      }
    }
    return counts;
  }, shot);
}

test("three materials and two pictures are three colours", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  const before = await pixels(page);
  await drop(page, [{ name: "tower.glb", bytes: tower() }]);
  await expect.poll(async () => page.evaluate(() => rigless?.document.mesh.file), { timeout: 60_000 }).toBe("tower.glb");
  await pause(page);
  await expect.poll(async () => (await pixels(page)).every((count, k) => count > (before[k] ?? 0) + 1500), { timeout: 30_000 }).toBe(true);
  expect(errors).toEqual([]);
});
