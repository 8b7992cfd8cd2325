// The one picture that a model is drawn with.

import { type Format, starts, wordList } from "./format";
import type { Picture } from "../gltf/document";
import { baseName, findFile, type NamedFile } from "./named-file";

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

/** The picture of these names; null, with a note, if it is missing, of a kind we cannot show, or one of several. */
export function pictureOf(names: readonly string[], files: readonly NamedFile[], from: string, notes: string[]): Picture | null {
  if (names.length === 0) return null;
  if (names.length > 1) {
    notes.push(`This model has ${names.length} pictures; we show its plain colours.`);
    return null;
  }
  const file = findFile(files, names[0], from);
  if (!file) {
    notes.push(`This model names ${baseName(names[0])}; drop it too.`);
    return null;
  }
  return checkedPicture(baseName(file.name), file.bytes, notes);
}

/** Null, with a note, for bytes that are none of the pictures that we show. */
export function checkedPicture(name: string, bytes: Uint8Array, notes: string[]): Picture | null {
  const format = PICTURES.find(({ is }) => is({ bytes, head: "", text: "" }));
  if (format) return { bytes, mime: format.mediaType };
  notes.push(
    `${name} is not a ${wordList(
      PICTURES.map(({ words }) => words),
      "or",
    )} picture; we show the model without it.`,
  );
  return null;
}

/** Whether a picture's name says that it holds normals: formats that know bump maps alone name these there. */
export function isNormalMap(name: string): boolean {
  return /norm|nrm|[_.-]n(or)?(\.\w+)?$/i.test(name);
}
