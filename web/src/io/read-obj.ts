// OBJ by three's OBJLoader. The loader leaves out what it cannot read without a word, and a line element turns the faces of
// its object into lines, so the text is looked through first: errors name the line, and only what makes faces goes on.

import { type Material, Mesh, type MeshPhongMaterial } from "three";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";

import type { GltfDocument, GltfMaterial } from "../gltf/document";
import { linear } from "./color";
import { count } from "./count";
import { type BuiltPart, type BuiltPicture, buildDocument } from "./gltf/build";
import { baseName, findFile, ModelError, type NamedFile } from "./named-file";
import { namedPicture } from "./take-picture";

/** Errors (ModelError) name the line: a coordinate that is no number, a face index without its vertex. */
export function readObj(name: string, path: string, text: string, files: readonly NamedFile[], notes: string[]): GltfDocument {
  const lookedThrough = lookThrough(name, text);
  if (lookedThrough.loose > 0) notes.push(`Left out ${count(lookedThrough.loose, "loose point")} that no face uses.`);
  const library = new Map<string, Mtl>();
  for (const named of lookedThrough.libraries) {
    const file = findFile(files, named, path);
    if (file) readMtl(new TextDecoder().decode(file.bytes)).forEach((mtl, key) => library.set(key, mtl));
  }
  const materials: GltfMaterial[] = [];
  const pictures: BuiltPicture[] = [];
  const numbers = new Map<string, number>();
  const materialOf = (key: string): number | undefined => {
    const mtl = library.get(key);
    if (!mtl) return undefined;
    const known = numbers.get(key) ?? materials.push(dressed(key, mtl, (picture) => addPicture(pictures, picture, files, path, notes))) - 1;
    numbers.set(key, known);
    return known;
  };

  const parts: BuiltPart[] = [];
  new OBJLoader().parse(lookedThrough.text).traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { position, color, uv, normal } = object.geometry.attributes;
    const arrays = {
      positions: position.array,
      normals: lookedThrough.normals ? normal.array : null,
      colors: color ? color.array : null,
      uvs: uv ? [Float32Array.from(uv.array as Float32Array, (x, i) => (i % 2 ? 1 - x : x))] : [],
    };
    for (const { material, start, size } of groups(object)) {
      const index = Uint32Array.from({ length: size }, (_, i) => start + i);
      const number = materialOf(material);
      parts.push({ name: object.name, index, ...arrays, ...(number !== undefined && { material: number }) });
    }
  });
  return buildDocument(name, { parts, materials, pictures });
}

function addPicture(pictures: BuiltPicture[], named: string, files: readonly NamedFile[], path: string, notes: string[]): number {
  const known = pictures.findIndex(({ name }) => name === baseName(named));
  return known < 0 ? pictures.push(namedPicture(named, files, path, notes)) - 1 : known;
}

/** A matt material with what the MTL says of it; both sides show, for nobody knows how the faces are wound. */
function dressed(name: string, mtl: Mtl, pictureOf: (name: string) => number): GltfMaterial {
  const [r, g, b] = mtl.picture === null && mtl.color ? mtl.color : [1, 1, 1];
  const { emission } = mtl;
  return {
    name,
    pbrMetallicRoughness: {
      baseColorFactor: [r, g, b, mtl.alpha],
      ...(mtl.picture !== null && { baseColorTexture: { index: pictureOf(mtl.picture) } }),
      metallicFactor: mtl.metal,
      roughnessFactor: mtl.roughness,
    },
    ...(mtl.normals !== null && { normalTexture: { index: pictureOf(mtl.normals) } }),
    ...(mtl.glow !== null && { emissiveTexture: { index: pictureOf(mtl.glow) } }),
    ...((emission ?? mtl.glow) !== null && { emissiveFactor: emission ?? [1, 1, 1] }),
    ...(mtl.alpha < 1 ? { alphaMode: "BLEND" } : mtl.cut ? { alphaMode: "MASK" } : {}),
    doubleSided: true,
  };
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
  /** Every corner of a face names one. */
  normals: boolean;
}

function lookThrough(name: string, text: string): LookedThrough {
  const lines = text.split(/\r\n|\r|\n/);
  const error = (at: number, what: string): ModelError => new ModelError(`${name}, line ${at + 1}: ${what}.`);
  const kept: string[] = [];
  const libraries: string[] = [];
  let faces = 0;
  let normals = true;
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
        normals &&= /^[^/]*\/[^/]*\/./.test(row[k]);
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
  return { text: kept.join("\n"), libraries, normals, loose: used.reduce((sum, is) => sum + (is ? 0 : 1), 0) };
}

interface Mtl {
  /** Linear RGB. */
  color: number[] | null;
  picture: string | null;
  alpha: number;
  /** A picture says where it is cut out. */
  cut: boolean;
  metal: number;
  roughness: number;
  normals: string | null;
  /** Linear RGB. */
  emission: number[] | null;
  glow: string | null;
}

const PLAIN: Mtl = {
  ...{ color: null, picture: null, alpha: 1, cut: false, metal: 0, roughness: 0.8 },
  ...{ normals: null, emission: null, glow: null },
};

function readMtl(text: string): Map<string, Mtl> {
  const materials = new Map<string, Mtl>();
  let mtl: Mtl = { ...PLAIN };
  for (const raw of text.split(/\r\n|\r|\n/)) {
    const line = raw.trim();
    const [key, ...rest] = line.split(/\s+/);
    const numbers = rest.map(Number);
    const one = Number.isFinite(numbers[0]) ? Math.min(1, Math.max(0, numbers[0])) : null;
    const color = numbers.length >= 3 && numbers.slice(0, 3).every(Number.isFinite) ? numbers.slice(0, 3).map(linear) : null;
    if (key === "newmtl") materials.set(line.slice(6).trim(), (mtl = { ...PLAIN }));
    if (key === "Kd" && color) mtl.color = color;
    if (key === "Ke" && color?.some((c) => c > 0)) mtl.emission = color;
    // Exporters disagree on what Tr counts; a model that nobody sees is not meant.
    if (key === "d" && one) mtl.alpha = one;
    if (key === "Tr" && one !== null && one < 1) mtl.alpha = 1 - one;
    if (key === "Pm" && one !== null) mtl.metal = one;
    if (key === "Pr" && one !== null) mtl.roughness = one;
    if (key === "map_Kd") mtl.picture = pictureName(line);
    if (key === "map_Ke") mtl.glow = pictureName(line);
    if (key === "map_d") mtl.cut = true;
    if (key === "norm") mtl.normals = pictureName(line);
  }
  return materials;
}

/** Options such as "-s 1 1 1" stand before the name. */
function pictureName(line: string): string {
  return line.replace(/^\w+\s+(-\w+(\s+(-?[\d.]+|on|off))*\s+)*/, "");
}
