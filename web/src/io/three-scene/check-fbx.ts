// A binary FBX is walked before the loader does: it believes every length.

import { Unzlib } from "fflate";

import { CUT_SHORT, ModelError } from "../named-file";

const DEEPEST = 64;
/** Bytes that all arrays together may unpack to. */
const MOST_BYTES = 512 * 1024 * 1024;
/** By an array's letter. */
const ITEM: Readonly<Record<string, number>> = { b: 1, c: 1, i: 4, f: 4, d: 8, l: 8 };
/** By a value's letter. */
const VALUE: Readonly<Record<string, number>> = { C: 1, B: 1, Y: 2, I: 4, F: 4, D: 8, L: 8 };

/** Answers the version. Errors (ModelError): nodes or values that lead out of the file or into each other; it unpacks to too much. */
export function checkBinaryFbx(name: string, bytes: Uint8Array): number {
  const broken = (): ModelError => new ModelError(`${name} is a broken FBX file: it ends early or its parts do not fit. ${CUT_SHORT}`);
  if (bytes.length < 27) throw broken();
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const version = view.getUint32(23, true);
  const wide = version >= 7500;
  const word = wide ? 8 : 4;
  const read = (at: number): number => (wide ? Number(view.getBigUint64(at, true)) : view.getUint32(at, true));
  let unpacked = 0;

  const array = (at: number, letter: string): number => {
    const [length, encoding, size] = [0, 4, 8].map((k) => view.getUint32(at + k, true));
    const declared = length * ITEM[letter];
    unpacked += declared;
    if (unpacked > MOST_BYTES) throw new ModelError(`${name} would unpack to more than 512 MB. We did not open it.`);
    const stored = encoding === 1 ? size : declared;
    if (at + 12 + stored > bytes.length) throw broken();
    if (encoding === 1 && inflatedSize(bytes.subarray(at + 12, at + 12 + size), declared) !== declared) throw broken();
    return at + 12 + stored;
  };

  /** Where the value ends. */
  const value = (at: number): number => {
    const letter = String.fromCharCode(bytes[at]);
    if (letter in ITEM) return array(at + 1, letter);
    if (letter in VALUE) return at + 1 + VALUE[letter];
    if (letter === "S" || letter === "R") return at + 5 + view.getUint32(at + 1, true);
    throw broken();
  };

  /** Walks the nodes from here to `to`; answers where they end. */
  const nodes = (from: number, to: number, depth: number): number => {
    if (depth > DEEPEST) throw broken();
    for (let at = from; at + 3 * word + 1 <= to; ) {
      const [end, values, size] = [0, 1, 2].map((k) => read(at + k * word));
      if (end === 0) return at + 3 * word + 1;
      let inside = at + 3 * word + 1 + bytes[at + 3 * word];
      const last = inside + size;
      if (end <= at || end > to || last > end) throw broken();
      for (let k = 0; k < values; k++) {
        if (inside >= last) throw broken();
        inside = value(inside);
      }
      if (inside !== last) throw broken();
      nodes(last, end, depth + 1);
      at = end;
    }
    return to;
  };
  try {
    nodes(27, bytes.length, 0);
  } catch (error) {
    throw error instanceof RangeError ? broken() : error;
  }
  return version;
}

/** How much a stream unpacks to; more than `most` once that is passed, -1 if it is broken. */
function inflatedSize(packed: Uint8Array, most: number): number {
  let size = 0;
  const inflate = new Unzlib((chunk) => {
    size += chunk.length;
  });
  try {
    for (let at = 0; at < packed.length && size <= most; at += 65536)
      inflate.push(packed.subarray(at, at + 65536), at + 65536 >= packed.length);
  } catch {
    return -1;
  }
  return size;
}
