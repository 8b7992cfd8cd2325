// STL by three's STLLoader, which skips what it cannot read; a text STL is looked through first.

import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";

import type { GltfDocument } from "../gltf/document";
import { count } from "./count";
import { buildDocument } from "./gltf/build";
import { ModelError } from "./named-file";

/** Errors (ModelError): a binary file shorter than its count of triangles; a corner of a text file that is not three numbers. */
export function readStl(name: string, bytes: Uint8Array): GltfDocument {
  const { position, color } = new STLLoader().parse(isText(bytes) ? checkedText(name, bytes) : checkedBinary(name, bytes)).attributes;
  if (position.count % 3 !== 0) throw new ModelError(`${name} has a triangle without three corners.`);
  const index = Uint32Array.from({ length: position.count }, (_, i) => i);
  return buildDocument(name, { parts: [{ positions: position.array, index, colors: color ? color.array : null }] });
}

/** A binary STL may begin with "solid" too. */
function isText(bytes: Uint8Array): boolean {
  const head = new TextDecoder("latin1").decode(bytes.subarray(0, 1024));
  return /^\s*solid\b/.test(head) && /\b(facet|endsolid)\b/.test(head);
}

/** Exactly the bytes that the count of triangles promises: by their number the loader knows a binary file. */
function checkedBinary(name: string, bytes: Uint8Array): ArrayBuffer {
  if (bytes.length < 84) throw new ModelError(`${name} holds no STL model.`);
  const triangles = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const size = 84 + 50 * triangles;
  if (bytes.length < size) {
    const whole = Math.floor((bytes.length - 84) / 50);
    throw new ModelError(`${name} promises ${count(triangles, "triangle")}, but it ends after ${count(whole, "triangle")}.`);
  }
  return new Uint8Array(bytes.subarray(0, size)).buffer;
}

function checkedText(name: string, bytes: Uint8Array): string {
  const text = new TextDecoder().decode(bytes).trimStart();
  const wrong = (at: number, what: string): ModelError => new ModelError(`${name}, line ${at + 1}: ${what}.`);
  let corners = 0;
  text.split(/\r\n|\r|\n/).forEach((line, at) => {
    const row = line.trim().split(/\s+/);
    if (row[0] === "facet") corners = 0;
    if (row[0] === "endfacet" && corners !== 3) throw wrong(at, `a triangle needs three corners, but this one has ${corners}`);
    if (row[0] !== "vertex") return;
    corners++;
    if (row.length < 4) throw wrong(at, "a corner needs three numbers");
    const odd = row.slice(1, 4).find((token) => !Number.isFinite(Number(token)));
    if (odd !== undefined) throw wrong(at, `"${odd.slice(0, 20)}" is not a number`);
  });
  if (!/\bendsolid\b/.test(text)) throw new ModelError(`${name} ends before "endsolid".`);
  return text.padEnd(84);
}
