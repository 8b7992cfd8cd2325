// A PLY's header, and the numbers behind it, one after the other.

import { CUT_SHORT, ModelError } from "./named-file";
import { shortened, TextScanner } from "./text-scanner";

export type Scalar = "int8" | "uint8" | "int16" | "uint16" | "int32" | "uint32" | "float32" | "float64";

interface Property {
  readonly name: string;
  readonly type: Scalar;
  /** Type of a list's length; null for a plain property. */
  readonly length: Scalar | null;
}

export interface Element {
  readonly name: string;
  readonly count: number;
  readonly properties: Property[];
}

export interface Header {
  readonly format: string;
  readonly elements: Element[];
  /** The picture that a comment names. */
  readonly texture: string | null;
  /** Bytes before the first row. */
  readonly size: number;
}

export interface Reader {
  readonly value: (type: Scalar) => number;
  /** The most values that can follow. */
  readonly left: () => number;
}

const SIZE: Record<Scalar, number> = { int8: 1, uint8: 1, int16: 2, uint16: 2, int32: 4, uint32: 4, float32: 4, float64: 8 };
const TYPES: Record<string, Scalar | undefined> = {
  char: "int8",
  uchar: "uint8",
  short: "int16",
  ushort: "uint16",
  int: "int32",
  uint: "uint32",
  float: "float32",
  double: "float64",
  int8: "int8",
  uint8: "uint8",
  int16: "int16",
  uint16: "uint16",
  int32: "int32",
  uint32: "uint32",
  float32: "float32",
  float64: "float64",
};

export function readHeader(name: string, bytes: Uint8Array): Header {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, 65536));
  const end = /end_header[ \t]*(\r\n|\n|\r)/.exec(text);
  if (!text.startsWith("ply") || !end) throw new ModelError(`${name} has no whole PLY header. ${CUT_SHORT}`);
  const elements: Element[] = [];
  let format = "";
  let texture: string | null = null;
  for (const line of text.slice(0, end.index).split(/\r\n|\n|\r/)) {
    const [key, ...rest] = line.trim().split(/\s+/);
    if (key === "format") format = rest[0] ?? "";
    if (key === "comment" && rest[0] === "TextureFile") texture = rest.slice(1).join(" ");
    if (key === "element") elements.push({ name: rest[0] ?? "", count: countIn(name, line, rest[1]), properties: [] });
    if (key === "property") elements.at(-1)?.properties.push(propertyIn(name, line, rest));
  }
  if (!["ascii", "binary_little_endian", "binary_big_endian"].includes(format)) {
    throw new ModelError(`${name} is a PLY of an unknown format "${shortened(format)}".`);
  }
  const size = end.index + end[0].length;
  const held = elements.filter((element) => element.properties.length > 0);
  checkCounts(name, held, bytes.length - size, format === "ascii");
  return { format, elements: held, texture, size };
}

function countIn(name: string, line: string, word: string | undefined): number {
  const n = Number(word);
  if (word !== undefined && Number.isInteger(n) && n >= 0) return n;
  throw new ModelError(`${name}: "${line.trim().slice(0, 40)}" in its header should end with a count from 0.`);
}

function propertyIn(name: string, line: string, words: string[]): Property {
  const list = words[0] === "list";
  const length = list ? TYPES[words[1]] : null;
  const type = TYPES[list ? words[2] : words[0]];
  if (!type || length === undefined) {
    throw new ModelError(`${name} has a property of an unknown type: "${line.trim().slice(0, 60)}".`);
  }
  return { name: words[list ? 3 : 1] ?? "", type, length };
}

/** Before anything is made for them: rows that the rest of the file cannot hold. */
function checkCounts(name: string, elements: readonly Element[], left: number, text: boolean): void {
  for (const { name: what, count, properties } of elements) {
    const least = properties.reduce((sum, { type, length }) => sum + (text ? 2 : SIZE[length ?? type]), 0);
    // The last number of a text needs no line end.
    if (count * least <= left + 1) continue;
    const [rows, one] = [count.toLocaleString("en-US"), Math.floor(left / least).toLocaleString("en-US")];
    throw new ModelError(`${name} promises ${rows} of "${shortened(what)}", but no more than ${one} fit in it. ${CUT_SHORT}`);
  }
}

export function endsEarly(name: string): ModelError {
  return new ModelError(`${name} ends before its last row. ${CUT_SHORT}`);
}

export function valuesOf(name: string, bytes: Uint8Array, { format, size }: Header, onProgress?: (done: number) => void): Reader {
  const body = bytes.subarray(size);
  return format === "ascii" ? textValues(name, body, onProgress) : binaryValues(name, body, format === "binary_little_endian");
}

function textValues(name: string, body: Uint8Array, onProgress?: (done: number) => void): Reader {
  const text = new TextScanner(name, body, "PLY", onProgress);
  return {
    left: () => text.left(),
    value: () => {
      if (!text.nextAnywhere()) throw endsEarly(name);
      const x = text.number();
      if (!Number.isFinite(x)) throw new ModelError(`${name}: "${shortened(text.word())}" should be a number.`);
      return x;
    },
  };
}

function binaryValues(name: string, body: Uint8Array, little: boolean): Reader {
  const view = new DataView(body.buffer, body.byteOffset, body.byteLength);
  let at = 0;
  const value = (type: Scalar): number => {
    const here = at;
    at += SIZE[type];
    if (at > view.byteLength) throw endsEarly(name);
    switch (type) {
      case "int8":
        return view.getInt8(here);
      case "uint8":
        return view.getUint8(here);
      case "int16":
        return view.getInt16(here, little);
      case "uint16":
        return view.getUint16(here, little);
      case "int32":
        return view.getInt32(here, little);
      case "uint32":
        return view.getUint32(here, little);
      case "float32":
        return view.getFloat32(here, little);
      case "float64":
        return view.getFloat64(here, little);
    }
  };
  return { value, left: () => view.byteLength - at };
}
