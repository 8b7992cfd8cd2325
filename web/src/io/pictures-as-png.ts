// TGA and BMP pictures as PNG: no browser shows the one, and a GLB may hold neither.

import { TGALoader } from "three/examples/jsm/loaders/TGALoader.js";

import type { Picture } from "../gltf/document";
import { type Pixels, readBmp } from "./read-bmp";
import { writePng } from "./write-png";

/** The same picture as PNG, pixel for pixel; one that is broken is kept as it is and not drawn. */
export function asPng(name: string, picture: Picture, notes: string[]): Picture {
  const pixels = picture.mime === "image/bmp" ? readBmp(picture.bytes) : readTga(picture.bytes);
  if (pixels) return { ...picture, bytes: writePng(pixels.width, pixels.height, pixels.rgba), mime: "image/png" };
  notes.push(`${name} is of a kind that we cannot show. Save it as a PNG picture to see it.`);
  return { ...picture, drawn: false };
}

function readTga(bytes: Uint8Array): Pixels | null {
  try {
    const { width = 0, height = 0, data } = new TGALoader().parse(bytes.slice().buffer);
    return data instanceof Uint8Array && data.length === 4 * width * height ? { width, height, rgba: data } : null;
  } catch {
    return null;
  }
}
