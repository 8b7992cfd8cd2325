// Where an FBX, text or binary, has nodes of a name, without being read.

import { starts } from "./format";

const COLON = 58;

export function isBinaryFbx(bytes: Uint8Array): boolean {
  return new TextDecoder("latin1").decode(bytes.subarray(0, 20)) === "Kaydara FBX Binary  ";
}

/** Where their names begin. */
export function* fbxNodes(bytes: Uint8Array, name: string): Generator<number> {
  const binary = isBinaryFbx(bytes);
  const letters = new TextEncoder().encode(name);
  for (let at = bytes.indexOf(letters[0]); at >= 0; at = bytes.indexOf(letters[0], at + 1)) {
    const named = binary ? bytes[at - 1] === letters.length : bytes[at + letters.length] === COLON;
    if (named && starts(bytes, at, ...letters)) yield at;
  }
}
