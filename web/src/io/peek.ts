// What binary files say of themselves without being read.

import { starts } from "./format";

const latin1 = new TextDecoder("latin1");

/** Whether a zip's first file has such a name. */
export function isArchiveStartingWith(bytes: Uint8Array, name: RegExp): boolean {
  if (!starts(bytes, 0, 0x50, 0x4b, 0x03, 0x04) || bytes.length < 30) return false;
  const length = bytes[26] + 256 * bytes[27];
  return name.test(latin1.decode(bytes.subarray(30, 30 + length)));
}

/** Whether a zip's table of contents, which stands at its end, has such a name. */
export function isArchiveWith(bytes: Uint8Array, name: RegExp): boolean {
  return starts(bytes, 0, 0x50, 0x4b, 0x03, 0x04) && name.test(latin1.decode(bytes.subarray(Math.max(0, bytes.length - 65536))));
}

/** The pictures that a binary FBX names, as one that is text would. */
export function fbxPictures(bytes: Uint8Array): string {
  const key = new TextEncoder().encode("RelativeFilenameS");
  const found: string[] = [];
  for (let at = bytes.indexOf(key[0]); at >= 0; at = bytes.indexOf(key[0], at + 1)) {
    if (!starts(bytes, at, ...key)) continue;
    const from = at + key.length + 4;
    const length = bytes[from - 4] + 256 * bytes[from - 3];
    found.push(`RelativeFilename: "${new TextDecoder().decode(bytes.subarray(from, from + length))}"`);
  }
  return found.join("\n");
}
