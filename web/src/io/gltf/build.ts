// A document of what another format's reader found: parts, their materials and pictures.

import type { Gltf, GltfDocument, GltfMaterial, GltfMesh, GltfNode, GltfPrimitive, GltfSampler, Picture } from "../../gltf/document";
import { count } from "../count";
import { ModelError } from "../named-file";
import { TupleTable } from "../../util/tuple-table";
import { creasedNormals } from "./creased-normals";
import { STRONGEST } from "./strongest";
import { INDICES, Packer, VERTICES } from "./packer";

/** Triangles of one material as a file holds them. Parts may share arrays. */
export interface BuiltPart {
  /** Of the object that it belongs to; neighbours of one name become one node. */
  readonly name?: string;
  /** N x 3; doubles keep what is far away exact. */
  readonly positions: ArrayLike<number>;
  /** Triangles over N. */
  readonly index: ArrayLike<number>;
  /** N x 3; without them faces meet smoothly but for creases. */
  readonly normals?: ArrayLike<number> | null;
  /** N x 3 linear RGB, or N x 4 with alpha. */
  readonly colors?: ArrayLike<number> | null;
  /** Sets of N x 2, v down as in glTF. */
  readonly uvs?: readonly ArrayLike<number>[];
  /** N: which of the joints that the file brings moves a vertex most. */
  readonly joints?: ArrayLike<number> | null;
  /** Which of the materials; without one it is clay. */
  readonly material?: number;
}

/** A picture as a texture shows it. */
export interface BuiltPicture {
  readonly name: string;
  /** Null for one that is missing: its place in the material stays. */
  readonly picture: Picture | null;
  readonly sampler?: GltfSampler;
}

export interface Built {
  readonly parts: readonly BuiltPart[];
  /** As in glTF; a texture's index counts `pictures`. */
  readonly materials?: readonly GltfMaterial[];
  readonly pictures?: readonly BuiltPicture[];
}

/**
 * Corners that agree in everything become one vertex, in the order in which triangles name them. Coordinates far from the origin
 * are kept exact by a node that moves them there. Errors (ModelError): no triangles; a corner that does not exist.
 */
export function buildDocument(name: string, { parts, materials = [], pictures = [] }: Built): GltfDocument {
  checkParts(name, parts);
  const centre = farCentre(parts);
  const normals = creasedNormals(parts);
  const packer = new Packer();
  const nodes: GltfNode[] = [];
  const meshes: GltfMesh[] = [];
  parts.forEach((part, p) => {
    if (part.index.length === 0) return;
    const primitive = packPart(packer, part, normals[p], centre);
    const last = meshes.at(-1);
    if (last && last.name === part.name) {
      last.primitives.push(primitive);
      return;
    }
    const named = part.name === undefined ? {} : { name: part.name };
    meshes.push({ ...named, primitives: [primitive] });
    nodes.push({ ...named, mesh: meshes.length - 1, ...(centre && { translation: centre }) });
  });
  const json: Gltf = {
    asset: { version: "2.0", generator: "Rigless" },
    scene: 0,
    scenes: [{ nodes: nodes.map((_, n) => n) }],
    nodes,
    meshes,
    ...(materials.length > 0 && { materials: [...materials] }),
    ...packPictures(packer, pictures),
    ...packer.json(),
  };
  const extensions = extensionsOf(materials, pictures);
  if (extensions.length > 0) json.extensionsUsed = extensions;
  return { json, buffers: [packer.bytes()], images: pictures.map(({ picture }) => picture) };
}

function checkParts(name: string, parts: readonly BuiltPart[]): void {
  if (parts.every(({ index }) => index.length === 0)) throw new ModelError(`${name} has no triangles.`);
  for (const { positions, index } of parts) {
    const n = positions.length / 3;
    for (let k = 0; k < index.length; k++) {
      if (index[k] >= 0 && index[k] < n) continue;
      throw new ModelError(`${name}: a face names vertex ${index[k] + 1}, but there are ${count(n, "vertex", "vertices")}.`);
    }
  }
}

/** Diagonals from the origin beyond which single precision would show. */
const FAR = 50;

/** The middle of all corners that triangles use, where it is far away for their size; null where it is not. */
function farCentre(parts: readonly BuiltPart[]): number[] | null {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const { positions, index } of parts) {
    for (let i = 0; i < index.length; i++) {
      for (let k = 0; k < 3; k++) {
        const x = positions[3 * index[i] + k];
        if (x < min[k]) min[k] = x;
        if (x > max[k]) max[k] = x;
      }
    }
  }
  const centre = min.map((low, k) => (low + max[k]) / 2);
  const diagonal = Math.hypot(...min.map((low, k) => max[k] - low));
  return Math.hypot(...centre) > FAR * diagonal ? centre : null;
}

/** All that a corner of a part holds, one after the other. */
interface Row {
  readonly key: string;
  readonly width: number;
  readonly values: ArrayLike<number>;
  /** Values are by corner of the index, not by vertex. */
  readonly byCorner?: true;
}

function packPart(packer: Packer, part: BuiltPart, creased: Float32Array | null, centre: readonly number[] | null): GltfPrimitive {
  const { positions, index, colors, uvs = [], material } = part;
  const n = positions.length / 3;
  const rows: Row[] = [{ key: "POSITION", width: 3, values: positions }];
  if (creased) rows.push({ key: "NORMAL", width: 3, values: creased, byCorner: true });
  else if (part.normals) rows.push({ key: "NORMAL", width: 3, values: part.normals });
  uvs.forEach((values, set) => rows.push({ key: `TEXCOORD_${set}`, width: 2, values }));
  if (part.joints) rows.push({ key: STRONGEST, width: 1, values: part.joints });
  if (colors) rows.push({ key: "COLOR_0", width: colors.length / n, values: colors });

  const width = rows.reduce((sum, row) => sum + row.width, 0);
  const table = new TupleTable(index.length, width);
  const tuple = new Float32Array(width);
  const bits = new Int32Array(tuple.buffer);
  const kept = new Float32Array(index.length * width);
  const corners = new Uint32Array(index.length);
  for (let i = 0; i < index.length; i++) {
    let at = 0;
    for (const row of rows) {
      const from = row.width * (row.byCorner ? i : index[i]);
      for (let k = 0; k < row.width; k++) tuple[at++] = row.values[from + k];
    }
    if (centre) for (let k = 0; k < 3; k++) tuple[k] = positions[3 * index[i] + k] - centre[k];
    for (let k = 0; k < width; k++) tuple[k] += 0; // -0 is 0
    const known = table.size;
    corners[i] = table.put(bits);
    if (corners[i] === known) kept.set(tuple, known * width);
  }
  const primitive: GltfPrimitive = {
    attributes: packRows(packer, rows, kept, table.size, width),
    indices: packer.accessor(table.size < 65535 ? Uint16Array.from(corners) : corners, "SCALAR", { target: INDICES }),
  };
  if (material !== undefined) primitive.material = material;
  return primitive;
}

function packRows(packer: Packer, rows: readonly Row[], kept: Float32Array, vertices: number, width: number): Record<string, number> {
  const attributes: Record<string, number> = {};
  let from = 0;
  for (const row of rows) {
    const values = new Float32Array(vertices * row.width);
    for (let v = 0; v < vertices; v++) {
      values.set(kept.subarray(v * width + from, v * width + from + row.width), v * row.width);
    }
    from += row.width;
    if (row.key !== "POSITION" && !values.every(Number.isFinite)) continue; // nobody could draw it
    const type = row.width === 1 ? "SCALAR" : row.width === 2 ? "VEC2" : row.width === 3 ? "VEC3" : "VEC4";
    attributes[row.key] = packer.accessor(values, type, { target: VERTICES, bounded: row.key === "POSITION" });
  }
  return attributes;
}

/** A texture for each picture; one picture's bytes are packed once. */
/** Pictures that a texture names in an extension. */
const BY_EXTENSION: Readonly<Record<string, string>> = { "image/webp": "EXT_texture_webp", "image/ktx2": "KHR_texture_basisu" };

function packPictures(packer: Packer, pictures: readonly BuiltPicture[]): Pick<Gltf, "textures" | "images" | "samplers"> {
  if (pictures.length === 0) return {};
  const views = new Map<Uint8Array, number>();
  const viewOf = ({ bytes }: Picture): number => {
    const view = views.get(bytes) ?? packer.view(bytes);
    views.set(bytes, view);
    return view;
  };
  const samplers = pictures.flatMap(({ sampler }) => sampler ?? []);
  return {
    images: pictures.map(({ name, picture }) =>
      picture ? { name, mimeType: picture.mime, bufferView: viewOf(picture) } : { name, uri: encodeURI(name) },
    ),
    textures: pictures.map(({ picture, sampler }, source) => ({
      ...(picture && BY_EXTENSION[picture.mime] ? { extensions: { [BY_EXTENSION[picture.mime]]: { source } } } : { source }),
      ...(sampler && { sampler: samplers.indexOf(sampler) }),
    })),
    ...(samplers.length > 0 && { samplers }),
  };
}

/** All that materials name, their textures' too. */
function extensionsOf(materials: readonly GltfMaterial[], pictures: readonly BuiltPicture[]): string[] {
  const names = new Set(pictures.flatMap(({ picture }) => BY_EXTENSION[picture?.mime ?? ""] ?? []));
  JSON.stringify(materials, (key, value: unknown) => {
    if (key === "extensions" && typeof value === "object" && value) for (const name of Object.keys(value)) names.add(name);
    return value;
  });
  return [...names];
}
