// A document with other geometry, and a document as one GLB. All that is not geometry stays, unknown extensions too, and keeps its
// number, because extensions name things by number.

import { COMPONENTS, WIDTHS } from "../../gltf/accessors";
import type { Gltf, GltfAccessor, GltfBufferView, GltfDocument, GltfMesh, GltfNode, GltfPrimitive } from "../../gltf/document";
import type { DrawnInstance } from "../../gltf/drawn";
import { STRONGEST } from "./strongest";
import { Numbered } from "./numbered";
import { type AccessorType, INDICES, packAccessor, type PackOptions, type Values, VERTICES } from "./packer";

/** What takes the place of a primitive's own geometry. */
export interface NewPrimitive {
  readonly instance: DrawnInstance;
  /** Over its own vertices. */
  readonly index: Uint32Array;
  /** N x 3. */
  readonly positions: Float32Array;
  /** N x 3; null where faces are flat. */
  readonly normals: Float32Array | null;
  /** N x 3 each: what to add. */
  readonly targets?: readonly { readonly positions: Float32Array; readonly normals: Float32Array | null }[];
  /** N x 4 each: what carries it. */
  readonly skin?: { readonly joints: Uint8Array; readonly weights: Uint16Array };
}

/** Packs numbers into the document; the accessor's number. */
export type Put = (values: Values, type: AccessorType, options?: PackOptions) => number;

/** How the geometry hangs in the scene, and what moves it. */
export interface NewMotion extends Pick<Gltf, "skins" | "animations"> {
  /** Numbered from the one that is handed in; the first shows mesh 0. */
  readonly nodes: GltfNode[];
  /** Numbers of those that hang in the scene itself. */
  readonly roots: number[];
}

export interface NewGeometry {
  /** The node's, the mesh's and the clip's. */
  readonly name: string;
  readonly primitives: readonly NewPrimitive[];
  /** What of the mesh is not its primitives. */
  readonly mesh?: Pick<GltfMesh, "weights" | "extras">;
  readonly motion: (put: Put, node: number) => NewMotion;
}

/** Skins, animations and cameras of the file go. Its nodes stay only where an extension of the whole file may name them. */
export function withGeometry(document: GltfDocument, { name, primitives, mesh, motion }: NewGeometry): GltfDocument {
  const { json } = document;
  const parts = new Parts(document);
  const made = primitives.map((primitive) => parts.primitive(primitive));
  const named = json.extensions && Object.keys(json.extensions).some((key) => !key.startsWith("KHR_"));
  const nodes = named ? (json.nodes ?? []).map(({ mesh: _m, skin: _s, camera: _c, weights: _w, ...node }) => node) : [];
  const roots = named ? (json.scenes?.[json.scene ?? 0]?.nodes ?? []) : [];
  const { scenes: _0, scene: _1, skins: _2, animations: _3, cameras: _4, extensionsUsed: _5, extensionsRequired: _6, ...rest } = json;
  const images = parts.images();
  const {
    skins = [],
    animations = [],
    ...hung
  } = motion((values, type, options = {}) => parts.put(packAccessor(values, type, options)), nodes.length);
  const next: Gltf = {
    ...rest,
    asset: { ...json.asset, version: "2.0", generator: "Rigless" },
    scene: 0,
    scenes: [{ name, nodes: [...hung.roots, ...roots] }],
    nodes: [...nodes, ...hung.nodes],
    meshes: [{ name, primitives: made, ...mesh }],
    ...(images.length > 0 && { images }),
    ...(skins.length > 0 && { skins }),
    ...(animations.length > 0 && { animations }),
    ...parts.json(),
  };
  const text = JSON.stringify({ ...next, accessors: [], bufferViews: [] });
  for (const list of ["extensionsUsed", "extensionsRequired"] as const) {
    const left = json[list]?.filter((used) => text.includes(`"${used}":`) || (used === QUANTIZATION && parts.quantized)) ?? [];
    if (left.length > 0) next[list] = left;
  }
  return { json: next, buffers: [parts.bytes()], images: document.images };
}

const QUANTIZATION = "KHR_mesh_quantization";

/** Bytes of the parts that stay and of the new ones. */
class Parts {
  /** Some picture's place is held by a number that only KHR_mesh_quantization allows. */
  quantized = false;
  private readonly accessors: Numbered<GltfAccessor>;
  private readonly views: Numbered<GltfBufferView>;
  private readonly chunks = new Map<number, Uint8Array>();
  private readonly attributes = new Map<string, number>();

  constructor(private readonly document: GltfDocument) {
    const { json, buffers } = document;
    const gone = geometryOf(json);
    const left = (json.accessors ?? []).map((accessor, a) => (gone.has(a) ? null : accessor));
    const usedViews = new Set([...left.map((accessor) => accessor?.bufferView), ...(json.images ?? []).map((image) => image.bufferView)]);
    const goneViews = new Set([...gone].map((a) => json.accessors?.[a]?.bufferView));
    this.accessors = new Numbered(left, { componentType: 5121, count: 1, type: "SCALAR" });
    this.views = new Numbered(
      (json.bufferViews ?? []).map((view, v) => (goneViews.has(v) && !usedViews.has(v) ? null : view)),
      { buffer: 0, byteOffset: 0, byteLength: 1 },
    );
    this.views.each(({ buffer, byteOffset = 0, byteLength }, v) => {
      this.chunks.set(v, buffers[buffer].subarray(byteOffset, byteOffset + byteLength));
    });
  }

  primitive({ instance, index, positions, normals, targets = [], skin }: NewPrimitive): GltfPrimitive {
    const {
      attributes,
      indices: _0,
      targets: _1,
      mode: _2,
      ...rest
    } = this.document.json.meshes![instance.mesh].primitives[instance.primitive];
    const vec3 = (values: Float32Array, bounded = false): number => this.put(packAccessor(values, "VEC3", { target: VERTICES, bounded }));
    const kept = Object.entries(attributes).filter(([key]) => /^(TEXCOORD_|COLOR_|_)/.test(key) && key !== STRONGEST);
    const short = positions.length / 3 < 65535;
    return {
      ...rest,
      attributes: {
        POSITION: vec3(positions, true),
        ...(normals && { NORMAL: vec3(normals) }),
        ...(skin && {
          JOINTS_0: this.put(packAccessor(skin.joints, "VEC4", { target: VERTICES })),
          WEIGHTS_0: this.put(packAccessor(skin.weights, "VEC4", { target: VERTICES, normalized: true })),
        }),
        // Tangents would have to turn with the surface; without them viewers make their own.
        ...Object.fromEntries(kept.map(([key, accessor]) => [key, this.attribute(key, accessor, instance)])),
      },
      indices: this.put(packAccessor(short ? Uint16Array.from(index) : index, "SCALAR", { target: INDICES })),
      ...(targets.length > 0 && {
        targets: targets.map((target) => ({
          POSITION: vec3(target.positions, true),
          ...(target.normals && { NORMAL: vec3(target.normals) }),
        })),
      }),
    };
  }

  /** Pictures from beside the file and from addresses move into it. */
  images(): NonNullable<Gltf["images"]> {
    return (this.document.json.images ?? []).map((image, i) => {
      const picture = this.document.images[i];
      if (!picture || image.bufferView !== undefined) return image;
      const { uri: _, ...rest } = image;
      return { ...rest, mimeType: picture.mime, bufferView: this.view({ buffer: 0, byteLength: picture.bytes.length }, picture.bytes) };
    });
  }

  json(): Pick<Gltf, "accessors" | "bufferViews" | "buffers"> {
    let at = 0;
    const bufferViews = this.views.list().map((view, v) => {
      const bytes = this.chunks.get(v);
      if (!bytes) return view;
      const placed = { ...view, buffer: 0, byteOffset: at, byteLength: bytes.length };
      at += padded(bytes.length);
      return placed;
    });
    return { accessors: this.accessors.list(), bufferViews, buffers: [{ byteLength: at }] };
  }

  bytes(): Uint8Array<ArrayBuffer> {
    const chunks = this.views.list().map((_, v) => this.chunks.get(v) ?? new Uint8Array(0));
    const out = new Uint8Array(chunks.reduce((sum, chunk) => sum + padded(chunk.length), 0));
    let at = 0;
    for (const chunk of chunks) {
      out.set(chunk, at);
      at += padded(chunk.length);
    }
    return out;
  }

  put({ accessor, view, bytes }: ReturnType<typeof packAccessor>): number {
    return this.accessors.add({ ...accessor, bufferView: this.view(view, bytes) });
  }

  private view(view: GltfBufferView, bytes: Uint8Array): number {
    const number = this.views.add(view);
    this.chunks.set(number, bytes);
    return number;
  }

  /** The values of an attribute for the vertices that are drawn, as they are in the file. */
  private attribute(key: string, index: number, { vertices, mesh, primitive }: DrawnInstance): number {
    const memo = vertices ? `${index} of ${mesh}.${primitive}` : String(index);
    const known = this.attributes.get(memo);
    if (known !== undefined) return known;
    const { json, buffers } = this.document;
    const { bufferView, byteOffset = 0, min: _0, max: _1, ...accessor } = json.accessors![index];
    const element = COMPONENTS[accessor.componentType].size * WIDTHS[accessor.type];
    const stride = padded(element);
    const count = vertices?.length ?? accessor.count;
    const out = new Uint8Array(count * stride);
    const view = bufferView === undefined ? undefined : json.bufferViews![bufferView];
    if (view) {
      const from = (view.byteOffset ?? 0) + byteOffset;
      const step = view.byteStride || element;
      const bytes = buffers[view.buffer];
      for (let v = 0; v < count; v++) {
        const start = from + (vertices ? vertices[v] : v) * step;
        out.set(bytes.subarray(start, start + element), v * stride);
      }
    }
    const isCore = accessor.componentType === 5126 || (accessor.normalized === true && [5121, 5123].includes(accessor.componentType));
    if (key.startsWith("TEXCOORD_") && !isCore) this.quantized = true;
    const packed = { buffer: 0, byteLength: out.length, target: VERTICES, ...(stride !== element && { byteStride: stride }) };
    const number = this.accessors.add({ ...accessor, count, bufferView: this.view(packed, out) });
    this.attributes.set(memo, number);
    return number;
  }
}

/** Accessors that only what goes away is known to use. */
function geometryOf({ meshes = [], skins = [], animations = [], nodes = [] }: Gltf): Set<number> {
  const gone = new Set<number>();
  const add = (index: number | undefined): void => void (index !== undefined && gone.add(index));
  for (const { attributes, indices, targets = [] } of meshes.flatMap(({ primitives }) => primitives)) {
    add(indices);
    for (const map of [attributes, ...targets]) Object.values(map).forEach(add);
  }
  skins.forEach(({ inverseBindMatrices }) => add(inverseBindMatrices));
  for (const { input, output } of animations.flatMap(({ samplers }) => (Array.isArray(samplers) ? samplers : []))) {
    add(input);
    add(output);
  }
  for (const { extensions } of nodes) {
    const instancing = extensions?.["EXT_mesh_gpu_instancing"] as { attributes?: Record<string, number> } | undefined;
    Object.values(instancing?.attributes ?? {}).forEach(add);
  }
  return gone;
}

const padded = (n: number): number => (n + 3) & ~3;

/** A document of one buffer as one file. */
export function packGlb({ json, buffers: [bin = new Uint8Array(0)] }: GltfDocument): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const chunks = [
    { kind: 0x4e4f534a, bytes: text, fill: 0x20 },
    { kind: 0x004e4942, bytes: bin, fill: 0 },
  ];
  const out = new Uint8Array(12 + chunks.reduce((sum, { bytes }) => sum + 8 + padded(bytes.length), 0));
  const view = new DataView(out.buffer);
  [0x46546c67, 2, out.length].forEach((word, k) => view.setUint32(4 * k, word, true));
  let at = 12;
  for (const { kind, bytes, fill } of chunks) {
    view.setUint32(at, padded(bytes.length), true);
    view.setUint32(at + 4, kind, true);
    out.set(bytes, at + 8);
    out.fill(fill, at + 8 + bytes.length, at + 8 + padded(bytes.length));
    at += 8 + padded(bytes.length);
  }
  return out;
}
