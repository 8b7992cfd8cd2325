// PLY, text and binary. Ours, because three's PLYLoader leaves out faces of more than four corners without a word.

import { linear } from "./color";
import type { GltfDocument } from "../gltf/document";
import { count } from "./count";
import { buildDocument } from "./gltf/build";
import { ModelError } from "./named-file";

type Scalar = "int8" | "uint8" | "int16" | "uint16" | "int32" | "uint32" | "float32" | "float64";

interface Property {
  name: string;
  type: Scalar;
  /** Type of a list's length; null for a plain property. */
  length: Scalar | null;
}

interface Element {
  name: string;
  count: number;
  properties: Property[];
}

interface Header {
  format: string;
  elements: Element[];
  /** Bytes before the first row. */
  size: number;
}

type Next = (type: Scalar) => number;

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

/** Polygons become fans. Errors (ModelError): a header that makes no sense; a file that ends early; a vertex that is not there. */
export function readPly(name: string, bytes: Uint8Array, notes: string[]): GltfDocument {
  const header = readHeader(name, bytes);
  const body = bytes.subarray(header.size);
  const next = header.format === "ascii" ? textValues(name, body) : binaryValues(name, body, header.format === "binary_little_endian");

  let vertices = 0;
  const positions: number[] = [];
  const colors: number[] = [];
  const uvs: number[] = [];
  const index: number[] = [];
  for (const element of header.elements) {
    const column = columns(element);
    for (let row = 0; row < element.count; row++) {
      const values = readRow(element, next);
      if (element.name === "vertex") {
        positions.push(...column.position.map((k) => values[k][0]));
        colors.push(...column.color.map((k) => linear(values[k][0] * column.colorScale)));
        if (column.uv.length === 2) uvs.push(values[column.uv[0]][0], 1 - values[column.uv[1]][0]);
      } else if (element.name === "face" && column.loop >= 0) {
        const loop = values[column.loop];
        const wrong = loop.find((v) => !(v >= 0 && v < vertices));
        if (wrong !== undefined) {
          throw new ModelError(`${name}: face ${row + 1} names vertex ${wrong}, but there are ${count(vertices, "vertex", "vertices")}.`);
        }
        for (let k = 1; k + 1 < loop.length; k++) index.push(loop[0], loop[k], loop[k + 1]);
      }
    }
    if (element.name === "vertex") {
      if (column.position.length < 3) throw new ModelError(`${name} has vertices without x, y and z.`);
      vertices = element.count;
    }
  }
  const loose = vertices - new Set(index).size;
  if (loose > 0 && index.length > 0) notes.push(`Left out ${count(loose, "loose point")} that no face uses.`);
  return buildDocument(name, { parts: [{ positions, index, colors: colors.length ? colors : null, uvs: uvs.length ? [uvs] : [] }] });
}

function readHeader(name: string, bytes: Uint8Array): Header {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, 65536));
  const end = /end_header[ \t]*(\r\n|\n|\r)/.exec(text);
  if (!text.startsWith("ply") || !end) throw new ModelError(`${name} has no whole PLY header.`);
  const header: Header = { format: "", elements: [], size: end.index + end[0].length };
  for (const line of text.slice(0, end.index).split(/\r\n|\n|\r/)) {
    const [key, ...rest] = line.trim().split(/\s+/);
    const element = header.elements.at(-1);
    if (key === "format") header.format = rest[0];
    if (key === "element") header.elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
    if (key === "property" && element) {
      const list = rest[0] === "list";
      const length = list ? TYPES[rest[1]] : null;
      const type = TYPES[list ? rest[2] : rest[0]];
      if (!type || length === undefined) throw new ModelError(`${name} has a property of an unknown type: "${line.trim()}".`);
      element.properties.push({ name: rest[list ? 3 : 1], type, length });
    }
  }
  if (!["ascii", "binary_little_endian", "binary_big_endian"].includes(header.format)) {
    throw new ModelError(`${name} is a PLY of an unknown format "${header.format}".`);
  }
  const wrong = header.elements.find(
    (e) => !(Number.isInteger(e.count) && e.count >= 0 && (e.properties.length === 0 || e.count <= bytes.length)),
  );
  if (wrong) throw new ModelError(`${name} promises ${wrong.count} of "${wrong.name}", which cannot be.`);
  header.elements = header.elements.filter((e) => e.properties.length > 0);
  return header;
}

/** Where a row keeps what we want: positions in its list of properties; empty or -1 where it has none. */
function columns(element: Element): { position: number[]; color: number[]; colorScale: number; uv: number[]; loop: number } {
  const find = (...names: string[]): number => element.properties.findIndex((p) => names.includes(p.name));
  const all = (...found: number[]): number[] => (found.includes(-1) ? [] : found);
  const color = all(find("red", "r", "diffuse_red"), find("green", "g", "diffuse_green"), find("blue", "b", "diffuse_blue"));
  const type = color.length ? element.properties[color[0]].type : "float32";
  return {
    position: all(find("x"), find("y"), find("z")),
    color,
    colorScale: type.startsWith("float") ? 1 : type === "uint16" ? 1 / 65535 : 1 / 255,
    uv: all(find("s", "u", "texture_u"), find("t", "v", "texture_v")),
    loop: find("vertex_indices", "vertex_index"),
  };
}

function readRow(element: Element, next: Next): number[][] {
  return element.properties.map(({ type, length }) => {
    const row: number[] = [];
    for (let n = length ? next(length) : 1; n > 0; n--) row.push(next(type));
    return row;
  });
}

function textValues(name: string, body: Uint8Array): Next {
  const tokens = new TextDecoder("latin1").decode(body).match(/\S+/g) ?? [];
  let at = 0;
  return (type) => {
    if (at >= tokens.length) throw new ModelError(`${name} ends before its last row.`);
    const token = tokens[at++];
    const x = Number(token);
    if (!Number.isFinite(x) || (!type.startsWith("float") && !Number.isInteger(x))) {
      throw new ModelError(`${name}: "${token.slice(0, 20)}" should be a ${type.startsWith("float") ? "number" : "whole number"}.`);
    }
    return x;
  };
}

function binaryValues(name: string, body: Uint8Array, little: boolean): Next {
  const view = new DataView(body.buffer, body.byteOffset, body.byteLength);
  let at = 0;
  return (type) => {
    const here = at;
    at += SIZE[type];
    if (at > view.byteLength) throw new ModelError(`${name} ends before its last row.`);
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
}
