// The one picture that a model is drawn with.

import type { Picture } from "./model";
import { baseName, findFile, type NamedFile } from "./named-file";

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

/** Null, with a note, for bytes that are not a PNG, JPEG or WebP. */
export function checkedPicture(name: string, bytes: Uint8Array, notes: string[]): Picture | null {
  const mime = mimeOf(bytes);
  if (mime) return { bytes, mime };
  notes.push(`${name} is not a PNG, JPEG or WebP picture; we show the model without it.`);
  return null;
}

function mimeOf(bytes: Uint8Array): string | null {
  const starts = (at: number, ...magic: number[]): boolean => magic.every((byte, i) => bytes[at + i] === byte);
  if (starts(0, 0x89, 0x50, 0x4e, 0x47)) return "image/png";
  if (starts(0, 0xff, 0xd8, 0xff)) return "image/jpeg";
  if (starts(0, 0x52, 0x49, 0x46, 0x46) && starts(8, 0x57, 0x45, 0x42, 0x50)) return "image/webp";
  return null;
}
