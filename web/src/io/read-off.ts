// OFF, COFF, NOFF, STOFF and their mixtures: a header, V E F, vertices, polygons. three.js has no loader for it.

import { linearColors } from "./color";
import { count } from "./count";
import type { Built } from "./gltf/build";
import { CUT_SHORT, ModelError, type NamedFile } from "./named-file";
import { shortened, TextScanner } from "./text-scanner";
import { addPolygon } from "./triangulate";

/** Reads an ASCII OFF. Errors (ModelError) name the line. */
export function readOff(name: string, { bytes }: NamedFile, notes: string[], onProgress?: (done: number) => void): Built {
  const text = new TextScanner(name, bytes, "OFF", onProgress);
  const { colored, normals, textured } = readHeader(name, text);
  const [vertices, faces] = [whole(name, text, "its counts"), whole(name, text, "its counts")];
  // A vertex has three numbers and a face one, with something between them.
  if (5 * vertices > bytes.length || 2 * faces > bytes.length) {
    throw new ModelError(
      `${name} promises ${count(vertices, "vertex", "vertices")} and ${count(faces, "face")}, more than fit in it. ${CUT_SHORT}`,
    );
  }

  const positions = new Float64Array(3 * vertices);
  const colors: number[] = [];
  const skip = normals ? 3 : 0;
  for (let v = 0; v < vertices; v++) {
    if (!text.nextLine()) throw endsBefore(name, `vertex ${v + 1} of ${vertices}`);
    for (let k = 0; k < 3; k++) positions[3 * v + k] = number(text);
    const more: number[] = [];
    while (more.length < skip + 3 && text.next()) more.push(text.number());
    if ((colored || !textured) && more.length === skip + 3) for (let k = skip; k < skip + 3; k++) colors.push(more[k]);
  }

  const index: number[] = [];
  const used = new Uint8Array(vertices);
  let loop: number[] = [];
  for (let f = 0; f < faces; f++) {
    if (!text.nextLine()) throw endsBefore(name, `face ${f + 1} of ${faces}`);
    const corners = whole(name, text, "a face");
    loop = [];
    // A long face may go on in the next line.
    while (loop.length < corners && text.nextAnywhere()) {
      const v = wholeWord(text);
      if (v >= vertices) throw text.error(`a face names vertex ${v}, but the last one is ${vertices - 1}`);
      used[v] = 1;
      loop.push(v);
    }
    if (loop.length < corners) throw text.error(`a face of ${corners} corners names only ${loop.length}`);
    addPolygon(index, loop, loop, positions);
  }
  const loose = used.reduce((sum, is) => sum + 1 - is, 0);
  if (index.length === 0 && vertices > 0)
    throw new ModelError(`${name} has no triangles: it holds ${count(vertices, "point")} alone. Save it as a mesh.`);
  if (loose > 0) notes.push(`Left out ${count(loose, "loose point")} that no face uses.`);
  return { parts: [{ positions, index, colors: colors.length === 3 * vertices ? linearColors(colors) : null }] };
}

function readHeader(name: string, text: TextScanner): { colored: boolean; normals: boolean; textured: boolean } {
  if (!text.nextLine()) throw new ModelError(`${name} holds nothing but blanks.`);
  text.next();
  const header = /^(ST)?(C)?(N)?(4)?(n)?OFF$/.exec(text.word());
  if (!header) throw new ModelError(`${name} does not begin with OFF.`);
  const [first, st, c, normals, four, n] = header;
  if (four || n) throw new ModelError(`${name} is not three-dimensional (${first}).`);
  // The counts may stand on the header's line.
  if (!text.next() && !(text.nextLine() && text.next())) throw endsBefore(name, "its counts");
  if (text.is("binary", true)) throw new ModelError(`${name} is a binary OFF. Save it as text.`);
  text.again();
  return { colored: c !== undefined, normals: normals !== undefined, textured: st !== undefined };
}

function endsBefore(name: string, what: string): ModelError {
  return new ModelError(`${name} ends before ${what}. ${CUT_SHORT}`);
}

function number(text: TextScanner): number {
  if (!text.next()) throw text.error("a number is missing");
  const x = text.number();
  if (!Number.isFinite(x)) throw text.noNumber();
  return x;
}

function whole(name: string, text: TextScanner, what: string): number {
  if (!text.next()) throw text.line ? text.error("a number is missing") : endsBefore(name, what);
  return wholeWord(text);
}

function wholeWord(text: TextScanner): number {
  const x = text.number();
  if (Number.isNaN(x)) throw text.noNumber();
  if (!Number.isInteger(x) || x < 0) throw text.error(`${shortened(text.word())} should be a whole number from 0`);
  return x;
}
