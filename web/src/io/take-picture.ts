// A model's picture, looked at before anybody decodes it: a few bytes can promise gigabytes of pixels.

import type { Picture } from "../gltf/document";
import { type Format, starts, wordList } from "./format";
import type { BuiltPicture } from "./gltf/build";
import { baseName, findFile, type NamedFile } from "./named-file";
import { PICTURES, pictureFormat } from "./picture";

/** Pixels of one picture: 8,192 x 8,192. */
const MOST_PIXELS = 2 ** 26;

/** What lies beside a model and is no picture is none of its business, nor of whoever gets the dance. */
export function takeOutside(name: string, bytes: Uint8Array, notes: string[]): Picture | null {
  const picture = takePicture(name, bytes, undefined, notes);
  return pictureFormat(bytes) ? picture : null;
}

/** Its bytes are kept whatever they are; a note says why a picture is not drawn. `mime`: what its file says it is. */
export function takePicture(name: string, bytes: Uint8Array, mime: string | undefined, notes: string[]): Picture {
  const format = pictureFormat(bytes);
  const [width, height] = pictureSize(bytes);
  const words = wordList(
    PICTURES.map((known) => known.words),
    "or",
  );
  if (!format) notes.push(`${name} is not a ${words} picture; we show the model without it.`);
  else if (width * height > MOST_PIXELS) {
    notes.push(`${name} has ${width.toLocaleString("en-US")} x ${height.toLocaleString("en-US")} pixels, too many to be shown.`);
  } else if (width * height === 0) notes.push(`${name} is a broken ${format.words} picture; we show the model without it.`);
  else if (isForOneCard(format, bytes)) {
    notes.push(`${name} is a KTX2 picture for one kind of graphics card, kept but not shown. Save it as Basis Universal, PNG or WebP.`);
    return { bytes, mime: format.mediaType, drawn: false };
  }
  const drawn = format !== undefined && width * height > 0 && width * height <= MOST_PIXELS;
  return { bytes, mime: format?.mediaType ?? mime ?? "application/octet-stream", drawn };
}

/** The picture that a material names, as a texture shows it; a note where it is missing. */
export function namedPicture(path: string, files: readonly NamedFile[], from: string, notes: string[]): BuiltPicture {
  const name = baseName(path);
  const file = findFile(files, path, from);
  if (file) return { name, picture: takeOutside(baseName(file.name), file.bytes, notes) };
  notes.push(`This model names ${name}; drop it too.`);
  return { name, picture: null };
}

/** A KTX2 that names the card's own format; one that names none is for any. */
function isForOneCard({ id }: Format, bytes: Uint8Array): boolean {
  return id === "ktx2" && !starts(bytes, 12, 0, 0, 0, 0);
}

/** Pictures as they are shown and written: those that a GLB may not hold become PNG. */
export async function presentable(pictures: readonly BuiltPicture[], notes: string[]): Promise<BuiltPicture[]> {
  const foreign = ({ picture }: BuiltPicture): boolean => picture?.drawn === true && ["image/bmp", "image/x-tga"].includes(picture.mime);
  if (!pictures.some(foreign)) return [...pictures];
  const { asPng } = await import("./pictures-as-png");
  const made = new Map<Picture, Picture>(); // several textures may show one picture
  return pictures.map((built) => {
    const { name, picture } = built;
    if (!picture || !foreign(built)) return built;
    const png = made.get(picture) ?? asPng(name, picture, notes);
    made.set(picture, png);
    return { ...built, picture: png };
  });
}

/** Width and height of a picture that we show; zeros where they cannot be told. */
function pictureSize(bytes: Uint8Array): [number, number] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 30 || !pictureFormat(bytes)) return [0, 0];
  if (bytes[0] === 0x89) return [view.getUint32(16), view.getUint32(20)];
  if (bytes[0] === 0x52) return webpSize(view);
  if (bytes[0] === 0xab) return [view.getUint32(20, true), view.getUint32(24, true)];
  if (bytes[0] === 0x42) return [Math.abs(view.getInt32(18, true)), Math.abs(view.getInt32(22, true))];
  if (bytes[0] !== 0xff) return [view.getUint16(12, true), view.getUint16(14, true)]; // TGA
  // JPEG: segments until the one that begins a frame.
  for (let at = 2; at + 9 < bytes.length; ) {
    if (bytes[at] !== 0xff) return [0, 0];
    const marker = bytes[at + 1];
    if (marker === 0xff) at++;
    else if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker))
      return [view.getUint16(at + 7), view.getUint16(at + 5)];
    else at += 2 + Math.max(2, view.getUint16(at + 2));
  }
  return [0, 0];
}

function webpSize(view: DataView): [number, number] {
  const kind = view.getUint32(12);
  const three = (at: number): number => 1 + (view.getUint16(at, true) | (view.getUint8(at + 2) << 16));
  if (kind === 0x56503858) return [three(24), three(27)]; // VP8X
  if (kind === 0x5650384c) {
    const bits = view.getUint32(21, true); // VP8L
    return [1 + (bits & 0x3fff), 1 + ((bits >>> 14) & 0x3fff)];
  }
  return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
}
