// The pictures that models are drawn with.

import { type Format, starts } from "./format";

/** The pictures that we show: rows of the table of formats. */
export const PICTURES: readonly (Format & Required<Pick<Format, "is">>)[] = [
  {
    id: "png",
    kind: "picture",
    words: "PNG",
    extensions: ["png"],
    mediaType: "image/png",
    is: ({ bytes }) => starts(bytes, 0, 0x89, 0x50, 0x4e, 0x47),
  },
  {
    id: "jpeg",
    kind: "picture",
    words: "JPEG",
    extensions: ["jpg", "jpeg"],
    mediaType: "image/jpeg",
    is: ({ bytes }) => starts(bytes, 0, 0xff, 0xd8, 0xff),
  },
  {
    id: "webp",
    kind: "picture",
    words: "WebP",
    extensions: ["webp"],
    mediaType: "image/webp",
    is: ({ bytes }) => starts(bytes, 0, 0x52, 0x49, 0x46, 0x46) && starts(bytes, 8, 0x57, 0x45, 0x42, 0x50),
  },
  {
    id: "ktx2",
    kind: "picture",
    words: "KTX2",
    extensions: ["ktx2"],
    mediaType: "image/ktx2",
    is: ({ bytes }) => starts(bytes, 0, 0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb),
  },
  { id: "bmp", kind: "picture", words: "BMP", extensions: ["bmp", "dib"], mediaType: "image/bmp", is: ({ bytes }) => isBmp(bytes) },
  { id: "tga", kind: "picture", words: "TGA", extensions: ["tga"], mediaType: "image/x-tga", is: ({ bytes }) => isTga(bytes) },
];

function isBmp(bytes: Uint8Array): boolean {
  return starts(bytes, 0, 0x42, 0x4d) && bytes.length >= 54 && starts(bytes, 6, 0, 0, 0, 0) && starts(bytes, 15, 0, 0, 0);
}

/** It has no mark at its beginning: a header in which everything makes sense is one. */
function isTga(bytes: Uint8Array): boolean {
  const [, map, kind] = bytes;
  const mapped = kind === 1 || kind === 9;
  const bits = mapped || kind === 3 || kind === 11 ? [8, 16] : [15, 16, 24, 32];
  const pixels = (bytes[12] + 256 * bytes[13]) * (bytes[14] + 256 * bytes[15]);
  const fits = kind > 8 || 18 + (pixels * bytes[16]) / 8 <= bytes.length;
  const known = (mapped && map === 1) || ([2, 3, 10, 11].includes(kind) && map === 0 && starts(bytes, 3, 0, 0, 0, 0, 0));
  return bytes.length > 18 && known && bits.includes(bytes[16]) && (bytes[17] & 0xc0) === 0 && pixels > 0 && fits;
}

/** What kind of picture some bytes are; undefined for one that we do not show. */
export function pictureFormat(bytes: Uint8Array): Format | undefined {
  return PICTURES.find(({ is }) => is({ bytes, head: "", text: "" }));
}

/** Whether a picture's name says that it holds normals: formats that know bump maps alone name these there. */
export function isNormalMap(name: string): boolean {
  return /norm|nrm|[_.-]n(or)?(\.\w+)?$/i.test(name);
}
