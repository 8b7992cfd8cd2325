// OBJ by three's OBJLoader. The loader leaves out what it cannot read without a word, and a line element turns the faces of
// its object into lines, so the text is looked through first: errors name the line, and only what makes faces goes on.

import { type Material, Mesh, type MeshPhongMaterial } from "three";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";

import { linear } from "./color";
import type { Picture } from "../gltf/document";
import { count } from "./count";
import type { Part } from "./model";
import { findFile, ModelError, type NamedFile } from "./named-file";
import { pictureOf } from "./picture";

/** Errors (ModelError) name the line: a coordinate that is no number, a face index without its vertex. */
export function readObj(
  name: string,
  path: string,
  text: string,
  files: readonly NamedFile[],
  notes: string[],
): { parts: Part[]; texture: Picture | null } {
  const lookedThrough = lookThrough(name, text);
  if (lookedThrough.loose > 0) notes.push(`Left out ${count(lookedThrough.loose, "loose point")} that no face uses.`);
  const materials = new Map<string, Mtl>();
  for (const library of lookedThrough.libraries) {
    const file = findFile(files, library, path);
    if (file) readMtl(new TextDecoder().decode(file.bytes)).forEach((mtl, key) => materials.set(key, mtl));
  }

  const group = new OBJLoader().parse(lookedThrough.text);
  const pictures = new Set<string>();
  const parts: Part[] = [];
  group.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { position, color, uv } = object.geometry.attributes;
    const used = groups(object);
    const rgb = color ? Float32Array.from(color.array) : new Float32Array(position.array.length).fill(1);
    for (const { material, start, size } of used) {
      const mtl = materials.get(material);
      if (mtl?.picture) pictures.add(mtl.picture);
      if (!mtl?.color || mtl.picture) continue;
      for (let i = start; i < start + size; i++) for (let k = 0; k < 3; k++) rgb[3 * i + k] *= mtl.color[k];
    }
    parts.push({
      positions: position.array,
      index: Uint32Array.from({ length: position.count }, (_, i) => i),
      colors: color || used.some(({ material }) => materials.get(material)?.color) ? rgb : null,
      uvs: uv ? Float32Array.from(uv.array as Float32Array, (x, i) => (i % 2 ? 1 - x : x)) : null,
    });
  });
  return { parts, texture: pictureOf([...pictures], files, path, notes) };
}

function groups(mesh: Mesh): { material: string; start: number; size: number }[] {
  const all = mesh.geometry.attributes.position.count;
  const list: Material[] = Array.isArray(mesh.material) ? mesh.material : [mesh.material as MeshPhongMaterial];
  if (list.length === 1) return [{ material: list[0].name, start: 0, size: all }];
  return mesh.geometry.groups.map((g) => ({ material: list[g.materialIndex ?? 0].name, start: g.start, size: g.count }));
}

interface LookedThrough {
  /** What the loader is to read. */
  text: string;
  libraries: string[];
  /** Vertices that no face uses. */
  loose: number;
}

function lookThrough(name: string, text: string): LookedThrough {
  const lines = text.split(/\r\n|\r|\n/);
  const error = (at: number, what: string): ModelError => new ModelError(`${name}, line ${at + 1}: ${what}.`);
  const kept: string[] = [];
  const libraries: string[] = [];
  let faces = 0;
  const used: boolean[] = [];
  for (let at = 0; at < lines.length; at++) {
    let line = lines[at].trim();
    const first = at;
    while (line.endsWith("\\") && at + 1 < lines.length) line = line.slice(0, -1) + " " + lines[++at].trim();
    const space = line.search(/\s/);
    const key = space < 0 ? line : line.slice(0, space);
    if (key === "v") {
      const row = line.split(/\s+/);
      for (let k = 1; k < 4; k++) {
        if (row[k] === undefined) throw error(first, "a vertex needs three numbers");
        if (!Number.isFinite(Math.fround(Number(row[k])))) throw error(first, `"${row[k].slice(0, 20)}" is not a number`);
      }
      used.push(false);
    } else if (key === "f") {
      const row = line.split(/\s+/);
      if (row.length < 4) throw error(first, "a face needs three corners");
      for (let k = 1; k < row.length; k++) {
        const i = Number(row[k].split("/", 1)[0]);
        const v = i < 0 ? used.length + i : i - 1;
        if (!Number.isInteger(i) || i === 0) throw error(first, `"${row[k].slice(0, 20)}" names no vertex`);
        if (v < 0 || v >= used.length) {
          throw error(
            first,
            `a face names vertex ${i}, but there ${used.length === 1 ? "is" : "are"} ${count(used.length, "vertex", "vertices")} above it`,
          );
        }
        used[v] = true;
      }
      faces++;
    } else if (key === "mtllib") {
      libraries.push(line.slice(space).trim());
      continue;
    } else if (key !== "vt" && key !== "vn" && key !== "usemtl" && key !== "o" && key !== "g") {
      continue;
    }
    kept.push(line);
  }
  if (faces === 0) {
    throw new ModelError(used.length ? `${name} has ${count(used.length, "point")} but no faces.` : `${name} holds no OBJ model.`);
  }
  return { text: kept.join("\n"), libraries, loose: used.reduce((sum, is) => sum + (is ? 0 : 1), 0) };
}

interface Mtl {
  /** Linear RGB. */
  color: number[] | null;
  picture: string | null;
}

function readMtl(text: string): Map<string, Mtl> {
  const materials = new Map<string, Mtl>();
  let mtl: Mtl = { color: null, picture: null };
  for (const line of text.split(/\r\n|\r|\n/)) {
    const [key, ...rest] = line.trim().split(/\s+/);
    if (key === "newmtl") materials.set(line.trim().slice(6).trim(), (mtl = { color: null, picture: null }));
    if (key === "Kd") {
      const color = rest.slice(0, 3).map((c) => linear(Number(c)));
      if (color.length === 3 && color.every(Number.isFinite)) mtl.color = color;
    }
    // Options such as "-s 1 1 1" stand before the name.
    if (key === "map_Kd") mtl.picture = line.trim().replace(/^map_Kd\s+(-\w+(\s+(-?[\d.]+|on|off))*\s+)*/, "");
  }
  return materials;
}
