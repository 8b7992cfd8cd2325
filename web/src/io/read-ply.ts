// PLY, text and binary. Ours, because three's PLYLoader leaves out faces of more than four corners, and strips, without a word.

import type { GltfMaterial } from "../gltf/document";
import { linearColors } from "./color";
import { CornerTable } from "./corner-table";
import { count } from "./count";
import type { Built } from "./gltf/build";
import { ModelError, type NamedFile } from "./named-file";
import { PictureShelf } from "./picture-shelf";
import { type Element, endsEarly, readHeader, type Reader, type Scalar, valuesOf } from "./ply-file";
import { addPolygon } from "./triangulate";

/** Errors (ModelError): a header that makes no sense; a file that ends early; a vertex that is not there. */
export function readPly(
  name: string,
  file: NamedFile,
  files: readonly NamedFile[],
  notes: string[],
  onProgress?: (done: number) => void,
): Built {
  const header = readHeader(name, file.bytes);
  const mesh = new PlyMesh(name, valuesOf(name, file.bytes, header, onProgress));
  for (const element of header.elements) mesh.read(element);
  mesh.check();
  const loose = mesh.loose();
  if (loose > 0) notes.push(`Left out ${count(loose, "loose point")} that no face uses.`);
  const shelf = new PictureShelf(files, file.name, notes);
  const materials: GltfMaterial[] =
    header.texture === null
      ? []
      : [{ pbrMetallicRoughness: { baseColorTexture: shelf.texture(header.texture), metallicFactor: 0, roughnessFactor: 1 } }];
  shelf.close();
  return { parts: [mesh.part(materials.length > 0)], materials, pictures: shelf.pictures };
}

class PlyMesh {
  private vertices = 0;
  private positions = new Float64Array(0);
  private colors: Float64Array | null = null;
  private normals: Float32Array | null = null;
  private uvs: Float32Array | null = null;
  private readonly index: number[] = [];
  /** Of each corner of `index` where faces have places in the picture of their own. */
  private wedges: number[] | null = null;
  private splat = false;

  constructor(
    private readonly name: string,
    private readonly next: Reader,
  ) {}

  read(element: Element): void {
    if (element.name === "vertex") this.readVertices(element);
    else if (element.name === "face") this.readFaces(element);
    else if (element.name === "tristrips") this.readStrips(element);
    else this.skip(element);
  }

  check(): void {
    if (this.index.length > 0) return;
    const points = count(this.vertices, "point");
    if (this.splat) {
      throw new ModelError(`${this.name} is a cloud of Gaussian splats without a surface. Make a mesh of it, and save that as GLB or PLY.`);
    }
    throw new ModelError(`${this.name} has no triangles: it holds ${points} alone. Make a mesh of them (MeshLab: screened Poisson).`);
  }

  loose(): number {
    const used = new Uint8Array(this.vertices);
    for (const vertex of this.index) used[vertex] = 1;
    return used.reduce((sum, is) => sum + 1 - is, 0);
  }

  part(textured: boolean): Built["parts"][number] {
    const { positions, normals, index } = this;
    const colors = this.colors && linearColors(this.colors);
    const material = textured ? { material: 0 } : {};
    if (!this.wedges) return { positions, normals, colors, uvs: this.uvs ? [this.uvs] : [], index, ...material };
    const table = new CornerTable();
    const uv = Float32Array.from(this.wedges);
    const bits = new Int32Array(uv.buffer);
    const corners = Uint32Array.from(index, (vertex, k) => table.put(vertex, bits[2 * k], bits[2 * k + 1]));
    const rows = table.column(0);
    const places = new Float32Array(2 * rows.length);
    corners.forEach((corner, k) => places.set(uv.subarray(2 * k, 2 * k + 2), 2 * corner));
    return {
      positions: rowsOf(positions, rows),
      normals: normals && rowsOf(normals, rows),
      colors: colors && rowsOf(colors, rows),
      uvs: [places],
      index: corners,
      ...material,
    };
  }

  private readVertices(element: Element): void {
    const { name } = this;
    const { properties } = element;
    const find = (...names: string[]): number => properties.findIndex((p) => names.includes(p.name) && !p.length);
    const all = (...found: number[]): number[] => (found.includes(-1) ? [] : found);
    const position = all(find("x"), find("y"), find("z"));
    if (position.length < 3) throw new ModelError(`${name} has vertices without x, y and z.`);
    const color = all(find("red", "r", "diffuse_red"), find("green", "g", "diffuse_green"), find("blue", "b", "diffuse_blue"));
    const normal = all(find("nx"), find("ny"), find("nz"));
    const uv = all(find("s", "u", "texture_u", "texture_s"), find("t", "v", "texture_v", "texture_t"));
    const n = element.count;
    this.vertices = n;
    this.splat = find("f_dc_0") >= 0;
    this.positions = new Float64Array(3 * n);
    if (color.length) this.colors = new Float64Array(3 * n);
    if (normal.length) this.normals = new Float32Array(3 * n);
    if (uv.length) this.uvs = new Float32Array(2 * n);
    const scale = color.length ? brightness(properties[color[0]].type) : 1;
    const row = new Float64Array(properties.length);
    for (let v = 0; v < n; v++) {
      this.readRow(element, row);
      for (let k = 0; k < 3; k++) {
        this.positions[3 * v + k] = row[position[k]];
        if (this.colors) this.colors[3 * v + k] = Math.min(Math.max(row[color[k]] * scale, 0), 1);
        if (this.normals) this.normals[3 * v + k] = row[normal[k]];
      }
      if (this.uvs) {
        this.uvs[2 * v] = row[uv[0]];
        this.uvs[2 * v + 1] = 1 - row[uv[1]];
      }
    }
    // Many writers leave normals at zero.
    if (this.normals?.every((x) => x === 0)) this.normals = null;
  }

  private readFaces(element: Element): void {
    const { properties } = element;
    const loopAt = properties.findIndex((p) => p.name === "vertex_indices" || p.name === "vertex_index");
    const wedgeAt = properties.findIndex((p) => p.name === "texcoord" && p.length);
    if (loopAt < 0) return this.skip(element);
    if (wedgeAt >= 0) this.wedges = [];
    const corners: number[] = [];
    const triangles: number[] = [];
    for (let f = 0; f < element.count; f++) {
      let loop: number[] = [];
      let wedge: number[] = [];
      properties.forEach((property, k) => {
        const values = this.readValues(property.type, property.length);
        if (k === loopAt) loop = values;
        if (k === wedgeAt) wedge = values;
      });
      for (const v of loop) if (!(Number.isInteger(v) && v >= 0 && v < this.vertices)) throw this.noVertex(`face ${f + 1}`, v);
      if (!this.wedges) {
        addPolygon(this.index, loop, loop, this.positions);
        continue;
      }
      corners.length = 0;
      triangles.length = 0;
      for (let k = 0; k < loop.length; k++) corners.push(k);
      addPolygon(triangles, corners, loop, this.positions);
      for (const k of triangles) {
        this.index.push(loop[k]);
        this.wedges.push(wedge[2 * k] ?? 0, 1 - (wedge[2 * k + 1] ?? 0));
      }
    }
  }

  /** Each a row of vertices; -1 begins another strip. */
  private readStrips(element: Element): void {
    const { properties } = element;
    const at = properties.findIndex((p) => p.name === "vertex_indices" || p.name === "vertex_index");
    for (let row = 0; row < element.count; row++) {
      properties.forEach((property, k) => {
        const values = this.readValues(property.type, property.length);
        if (k !== at) return;
        let from = 0;
        values.forEach((v, i) => {
          if (v === -1) from = i + 1;
          else if (!(Number.isInteger(v) && v >= 0 && v < this.vertices)) throw this.noVertex(`strip ${row + 1}`, v);
          else if (i - from >= 2) {
            if ((i - from) % 2 === 0) this.index.push(values[i - 2], values[i - 1], v);
            else this.index.push(values[i - 1], values[i - 2], v);
          }
        });
      });
    }
  }

  private skip(element: Element): void {
    for (let row = 0; row < element.count; row++) for (const { type, length } of element.properties) this.readValues(type, length);
  }

  /** Plain properties only; lists are passed. */
  private readRow({ properties }: Element, row: Float64Array): void {
    for (let k = 0; k < properties.length; k++) {
      const { type, length } = properties[k];
      if (length) this.readValues(type, length);
      else row[k] = this.next.value(type);
    }
  }

  private readValues(type: Scalar, length: Scalar | null): number[] {
    const values: number[] = [];
    const n = length ? this.next.value(length) : 1;
    if (!(Number.isInteger(n) && n >= 0)) throw new ModelError(`${this.name}: ${n} should be a whole number, how many values follow.`);
    if (n > this.next.left()) throw endsEarly(this.name);
    for (let k = 0; k < n; k++) values.push(this.next.value(type));
    return values;
  }

  private noVertex(what: string, vertex: number): ModelError {
    return new ModelError(`${this.name}: ${what} names vertex ${vertex}, but there are ${count(this.vertices, "vertex", "vertices")}.`);
  }
}

/** What a colour's largest value is multiplied by to be 1. */
function brightness(type: Scalar): number {
  if (type.startsWith("float")) return 1;
  return type === "uint16" ? 1 / 65535 : 1 / 255;
}

function rowsOf<T extends Float32Array | Float64Array>(values: T, rows: Int32Array): Float64Array {
  const out = new Float64Array(3 * rows.length);
  for (let r = 0; r < rows.length; r++) for (let k = 0; k < 3; k++) out[3 * r + k] = values[3 * rows[r] + k];
  return out;
}
