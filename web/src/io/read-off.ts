// OFF, COFF, NOFF, STOFF and their mixtures: a header, V E F, vertices, polygons. three.js has no loader for it.

import type { GltfDocument } from "../gltf/document";
import { count } from "./count";
import { buildDocument } from "./gltf/build";
import { ModelError } from "./named-file";
import { linear } from "./color";

/** Reads an ASCII OFF. Polygons become fans. Errors (ModelError) name the line. */
export function readOff(name: string, text: string, notes: string[]): GltfDocument {
  const lines = new Lines(name, text);
  const header = /^(ST)?(C)?(N)?(4)?(n)?OFF\b\s*(BINARY)?/.exec(lines.next("its header").join(" "));
  if (!header) throw new ModelError(`${name} does not begin with OFF.`);
  const [first, st, colored, normals, four, n, binary] = header;
  if (four || n) throw new ModelError(`${name} is not three-dimensional (${first.trim()}).`);
  if (binary) throw new ModelError(`${name} is a binary OFF. Save it as text.`);

  // The counts may stand on the header's line.
  let counts = lines.present.slice(1);
  if (counts.length === 0) counts = lines.next("its counts");
  const [vertices, faces] = [lines.whole(counts[0]), lines.whole(counts[1])];
  if (vertices > text.length || faces > text.length) {
    throw new ModelError(`${name} promises ${count(vertices, "vertex", "vertices")} and ${count(faces, "face")}, more than it can hold.`);
  }

  const positions = new Float64Array(3 * vertices);
  const skip = 3 + (normals ? 3 : 0);
  const colors: number[] = [];
  for (let v = 0; v < vertices; v++) {
    const row = lines.next(`vertex ${v + 1} of ${vertices}`);
    for (let k = 0; k < 3; k++) positions[3 * v + k] = lines.number(row[k]);
    const rgb = row.slice(skip, skip + 3);
    if ((colored || (!st && row.length > skip)) && rgb.length === 3) colors.push(...rgb.map(Number));
  }

  const index: number[] = [];
  for (let f = 0; f < faces; f++) {
    const row = lines.next(`face ${f + 1} of ${faces}`);
    const corners = lines.whole(row[0]);
    if (row.length <= corners) throw lines.error(`a face of ${corners} corners names only ${row.length - 1}`);
    const loop = row.slice(1, corners + 1).map((token) => {
      const v = lines.whole(token);
      if (v >= vertices) throw lines.error(`a face names vertex ${v}, but the last one is ${vertices - 1}`);
      return v;
    });
    for (let k = 1; k + 1 < loop.length; k++) index.push(loop[0], loop[k], loop[k + 1]);
  }
  const loose = vertices - new Set(index).size;
  if (loose > 0 && index.length > 0) notes.push(`Left out ${count(loose, "loose point")} that no face uses.`);
  return buildDocument(name, { parts: [{ positions, index, colors: colors.length === 3 * vertices ? toLinear(colors) : null }] });
}

/** Bytes or fractions of sRGB. */
function toLinear(colors: number[]): Float32Array {
  const scale = colors.some((c) => c > 1) ? 1 / 255 : 1;
  return Float32Array.from(colors, (c) => linear(c * scale));
}

/** Rows of tokens without comments and empty lines; remembers where it is. */
class Lines {
  present: string[] = [];
  private readonly lines: string[];
  private at = 0;

  constructor(
    private readonly name: string,
    text: string,
  ) {
    this.lines = text.split(/\r\n|\r|\n/);
  }

  next(what: string): string[] {
    while (this.at < this.lines.length) {
      const line = this.lines[this.at++].replace(/#.*/, "").trim();
      if (line !== "") return (this.present = line.split(/\s+/));
    }
    throw new ModelError(`${this.name} ends before ${what}.`);
  }

  number(token: string | undefined): number {
    const x = token === undefined ? NaN : Number(token);
    if (Number.isFinite(x)) return x;
    throw this.error(token === undefined ? "a number is missing" : `"${token.slice(0, 20)}" is not a number`);
  }

  whole(token: string | undefined): number {
    const x = this.number(token);
    if (Number.isInteger(x) && x >= 0) return x;
    throw this.error(`${x} should be a whole number from 0`);
  }

  error(what: string): ModelError {
    return new ModelError(`${this.name}, line ${this.at}: ${what}.`);
  }
}
