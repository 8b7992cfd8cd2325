// OBJ. Ours, because three's OBJLoader leaves out what it cannot read without a word, turns an object with a line into lines and
// takes the square of a file's objects.

import type { GltfMaterial } from "../gltf/document";
import { linearColors } from "./color";
import { CornerTable } from "./corner-table";
import { count } from "./count";
import type { Built, BuiltPart } from "./gltf/build";
import { findFile, ModelError, type NamedFile } from "./named-file";
import { PictureShelf } from "./picture-shelf";
import { readMtl } from "./read-mtl";
import { shortened, TextScanner } from "./text-scanner";
import { addPolygon } from "./triangulate";

/** Objects keep their names, which say what they are, up to this many: each is drawn for itself. */
const MOST_OBJECTS = 200;

/** Errors (ModelError) name the line: a coordinate that is no number, a face index without its vertex. */
export function readObj(
  name: string,
  file: NamedFile,
  files: readonly NamedFile[],
  notes: string[],
  onProgress?: (done: number) => void,
): Built {
  const obj = new ObjFile(name, new TextScanner(name, file.bytes, "OBJ", onProgress));
  obj.read();
  const loose = obj.loose();
  if (loose > 0) notes.push(`Left out ${count(loose, "loose point")} that no face uses.`);
  const shelf = new PictureShelf(files, file.name, notes);
  const known = new Map<string, GltfMaterial>();
  for (const library of obj.libraries) {
    const beside = findFile(files, library, file.name);
    if (beside) readMtl(new TextDecoder().decode(beside.bytes), shelf).forEach((material, key) => known.set(key, material));
  }
  shelf.close();
  const materials: GltfMaterial[] = [];
  const rank = new Map<string, number>();
  const indexOf = (material: string): number | undefined => {
    const found = known.get(material);
    if (found && !rank.has(material)) rank.set(material, materials.push(found) - 1);
    return rank.get(material);
  };
  return { parts: obj.parts(indexOf), materials, pictures: shelf.pictures };
}

/** Faces of one object and material in a row. */
interface Run {
  readonly object: string;
  readonly material: string;
  /** Of the index. */
  readonly from: number;
}

class ObjFile {
  readonly libraries = new Set<string>();
  private readonly positions: number[] = [];
  /** As the file has them, x 3. */
  private readonly colors: number[] = [];
  private readonly uvs: number[] = [];
  private readonly normals: number[] = [];
  /** Vertex, place in the picture and normal; -1 for none. */
  private readonly corners = new CornerTable();
  /** Triangles over corners. */
  private readonly index: number[] = [];
  private readonly runs: Run[] = [];
  private faces = 0;
  private object = "";
  private material = "";

  constructor(
    private readonly name: string,
    private readonly text: TextScanner,
  ) {}

  read(): void {
    const { text } = this;
    while (text.nextLine()) {
      text.next();
      if (text.is("v")) this.vertex();
      else if (text.is("vt")) this.row(this.uvs, 2, "a place in a picture needs two numbers");
      else if (text.is("vn")) this.row(this.normals, 3, "a normal needs three numbers");
      else if (text.is("f") || text.is("fo")) this.face();
      else if (text.is("usemtl")) this.material = text.rest();
      else if (text.is("o") || text.is("g")) this.object = text.rest();
      else if (text.is("mtllib")) this.libraries.add(text.rest());
    }
    if (this.faces > 0) return;
    const vertices = this.positions.length / 3;
    throw new ModelError(
      vertices ? `${this.name} has ${count(vertices, "point")} but no faces: save it as a mesh.` : `${this.name} holds no OBJ model.`,
    );
  }

  loose(): number {
    const used = new Uint8Array(this.positions.length / 3);
    for (const vertex of this.corners.column(0)) used[vertex] = 1;
    return used.reduce((sum, is) => sum + 1 - is, 0);
  }

  parts(materialOf: (material: string) => number | undefined): BuiltPart[] {
    const [vertex, place, normal] = ([0, 1, 2] as const).map((which) => this.corners.column(which));
    const positions = gather(this.positions, vertex, 3, new Float64Array(3 * vertex.length));
    const uvs = this.uvs.length > 0 ? [flipped(gather(this.uvs, place, 2, new Float32Array(2 * place.length)))] : [];
    // Where one face has no normals, all are computed: nothing tells what the others would look like beside it.
    const whole = this.normals.length > 0 && !normal.includes(-1);
    const normals = whole ? gather(this.normals, normal, 3, new Float32Array(3 * normal.length)) : null;
    const colored = this.colors.length > 0 && this.colors.length === this.positions.length;
    const colors = colored ? gather(linearColors(this.colors), vertex, 3, new Float32Array(3 * vertex.length)) : null;
    const shared = { positions, normals, colors, uvs };
    return this.groups(materialOf).map(({ name, material, index }) => ({
      ...shared,
      ...(name !== "" && { name }),
      ...(material !== undefined && { material }),
      index,
    }));
  }

  /** Runs of one object and one material together. */
  private groups(materialOf: (material: string) => number | undefined): { name: string; material: number | undefined; index: number[] }[] {
    const named = new Set(this.runs.map(({ object }) => object)).size <= MOST_OBJECTS;
    const groups = new Map<string, { name: string; material: number | undefined; index: number[] }>();
    this.runs.forEach(({ object, material: called, from }, r) => {
      const material = materialOf(called);
      const name = named ? object : "";
      const key = JSON.stringify([name, material]);
      const group = groups.get(key) ?? { name, material, index: [] };
      groups.set(key, group);
      const to = this.runs[r + 1]?.from ?? this.index.length;
      for (let k = from; k < to; k++) group.index.push(this.index[k]);
    });
    const order = [...new Set([...groups.values()].map(({ name }) => name))];
    const rank = new Map(order.map((name, k) => [name, k]));
    return [...groups.values()].sort((a, b) => (rank.get(a.name) ?? 0) - (rank.get(b.name) ?? 0));
  }

  private vertex(): void {
    const { text } = this;
    this.row(this.positions, 3, "a vertex needs three numbers");
    const more: number[] = [];
    while (more.length < 4 && text.next()) more.push(text.number());
    // r g b, perhaps a; one alone is a weight.
    const rgb = more.slice(0, 3);
    if (rgb.length === 3 && rgb.every(Number.isFinite)) this.colors.push(...rgb);
  }

  private row(out: number[], width: number, missing: string): void {
    const { text } = this;
    for (let k = 0; k < width; k++) {
      if (!text.next()) {
        // A place on a line of a picture has one number.
        if (out === this.uvs && k === 1) {
          out.push(0);
          return;
        }
        throw text.error(missing);
      }
      const x = text.number();
      if (!Number.isFinite(x) || !Number.isFinite(Math.fround(x))) throw text.noNumber();
      out.push(x);
    }
  }

  private face(): void {
    const { text } = this;
    const loop: number[] = [];
    const vertices: number[] = [];
    const parts = new Float64Array(3);
    while (text.next()) {
      parts.fill(0);
      text.indices(parts);
      const v = this.vertexOf(parts[0]);
      const vt = within(parts[1], this.uvs.length / 2);
      const vn = within(parts[2], this.normals.length / 3);
      vertices.push(v);
      loop.push(this.corners.put(v, vt, vn));
    }
    if (loop.length < 3) throw text.error("a face needs three corners");
    const last = this.runs.at(-1);
    if (!last || last.object !== this.object || last.material !== this.material) {
      this.runs.push({ object: this.object, material: this.material, from: this.index.length });
    }
    addPolygon(this.index, loop, vertices, this.positions);
    this.faces++;
  }

  private vertexOf(i: number): number {
    const { text } = this;
    const n = this.positions.length / 3;
    if (!Number.isInteger(i) || i === 0) throw text.error(`"${shortened(text.word())}" names no vertex`);
    const v = i < 0 ? n + i : i - 1;
    if (v >= 0 && v < n) return v;
    throw text.error(`a face names vertex ${i}, but there ${n === 1 ? "is" : "are"} ${count(n, "vertex", "vertices")} above it`);
  }
}

/** The row of a face's index, which counts from 1 or from the end; -1 for none or one that is not there. */
function within(i: number, n: number): number {
  const row = i < 0 ? n + i : i - 1;
  return Number.isInteger(row) && row >= 0 && row < n ? row : -1;
}

/** Rows of `values`; zeros for row -1. */
function gather<T extends Float32Array | Float64Array>(values: ArrayLike<number>, rows: Int32Array, width: number, out: T): T {
  for (let r = 0; r < rows.length; r++) {
    if (rows[r] >= 0) for (let k = 0; k < width; k++) out[width * r + k] = values[width * rows[r] + k];
  }
  return out;
}

/** v down, as in glTF. */
function flipped(uvs: Float32Array): Float32Array {
  for (let k = 1; k < uvs.length; k += 2) uvs[k] = 1 - uvs[k];
  return uvs;
}
