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
];

/** What kind of picture some bytes are; undefined for one that we do not show. */
export function pictureFormat(bytes: Uint8Array): Format | undefined {
  return PICTURES.find(({ is }) => is({ bytes, head: "", text: "" }));
}
