// STL, text and binary. Ours, because three's STLLoader searches a text for facets in a time that grows with the square of those
// that are left open, and skips what it cannot read.

import { linear } from "./color";
import { count } from "./count";
import type { Built } from "./gltf/build";
import { CUT_SHORT, ModelError, type NamedFile } from "./named-file";
import { TextScanner } from "./text-scanner";

/** Errors (ModelError): a binary file shorter than its count of triangles; a corner of a text file that is not three numbers. */
export function readStl(name: string, { bytes }: NamedFile, onProgress?: (done: number) => void): Built {
  return { parts: [isText(bytes) ? textPart(name, bytes, onProgress) : binaryPart(name, bytes)] };
}

/** A binary STL may begin with "solid" too. */
function isText(bytes: Uint8Array): boolean {
  if (bytes.length >= 84 && bytes.length === 84 + 50 * trianglesOf(bytes)) return false;
  const head = new TextDecoder("latin1").decode(bytes.subarray(0, 1024));
  return /^\s*solid\b/i.test(head) && /\b(facet|endsolid)\b/i.test(head);
}

function trianglesOf(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength).getUint32(80, true);
}

function textPart(name: string, bytes: Uint8Array, onProgress?: (done: number) => void): Built["parts"][number] {
  const text = new TextScanner(name, bytes, "STL", onProgress);
  const positions: number[] = [];
  let corners = 0;
  let ended = false;
  const close = (): void => {
    if (corners !== 3) throw text.error(`a triangle needs three corners, but this one has ${corners}`);
    corners = 0;
  };
  while (text.nextLine()) {
    text.next();
    if (text.is("vertex", true)) {
      corners++;
      for (let k = 0; k < 3; k++) {
        if (!text.next()) throw text.error("a corner needs three numbers");
        const x = text.number();
        if (!Number.isFinite(x)) throw text.noNumber();
        positions.push(x);
      }
    } else if (text.is("endfacet", true) || (text.is("facet", true) && corners > 0)) close();
    else if (text.is("endsolid", true)) ended = true;
  }
  if (corners > 0 || !ended) throw new ModelError(`${name} ends before "endsolid". ${CUT_SHORT}`);
  return { positions, index: order(positions.length / 3) };
}

function binaryPart(name: string, bytes: Uint8Array): Built["parts"][number] {
  if (bytes.length < 84) throw new ModelError(`${name} holds no STL model.`);
  const triangles = trianglesOf(bytes);
  const whole = Math.floor((bytes.length - 84) / 50);
  if (whole < triangles) {
    throw new ModelError(`${name} promises ${count(triangles, "triangle")}, but it ends after ${count(whole, "triangle")}. ${CUT_SHORT}`);
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const positions = new Float32Array(9 * triangles);
  for (let t = 0; t < triangles; t++) {
    for (let k = 0; k < 9; k++) positions[9 * t + k] = view.getFloat32(84 + 50 * t + 12 + 4 * k, true);
  }
  return { positions, index: order(3 * triangles), colors: colorsOf(bytes, view, triangles) };
}

/** Fifteen bits a triangle, by a word in the header; null without it. */
function colorsOf(bytes: Uint8Array, view: DataView, triangles: number): Float32Array | null {
  const at = new TextDecoder("latin1").decode(bytes.subarray(0, 80)).indexOf("COLOR=");
  if (at < 0 || at > 70) return null;
  const usual = [0, 1, 2].map((k) => linear(bytes[at + 6 + k] / 255));
  const colors = new Float32Array(9 * triangles);
  for (let t = 0; t < triangles; t++) {
    const bits = view.getUint16(84 + 50 * t + 48, true);
    const own = (bits & 0x8000) === 0;
    for (let k = 0; k < 9; k++) colors[9 * t + k] = own ? linear(((bits >> (5 * (k % 3))) & 31) / 31) : usual[k % 3];
  }
  return colors;
}

function order(n: number): Uint32Array {
  return Uint32Array.from({ length: n }, (_, i) => i);
}
