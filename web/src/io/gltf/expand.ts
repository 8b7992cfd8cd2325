// Nothing of a document stays packed: meshopt (EXT_ and KHR_meshopt_compression), Draco (KHR_draco_mesh_compression) and sparse
// accessors become plain ones. A decoder is loaded only for a file that needs it.

import { COMPONENTS, WIDTHS } from "../../gltf/accessors";
import type { Gltf, GltfBufferView, GltfDocument } from "../../gltf/document";
import { ModelError } from "../named-file";
import { broken, checkAccessors, MOST_UNPACKED } from "./check";

export const MESHOPT = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
export const DRACO = "KHR_draco_mesh_compression";
const MODES = ["ATTRIBUTES", "TRIANGLES", "INDICES"];
const FILTERS = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"];
/** What one byte of each mode can unpack to at most, in bytes: more is a lie, and lies would be paid in memory. */
const MOST_PER_BYTE = { ATTRIBUTES: 1024, TRIANGLES: 12, INDICES: 4 };

interface Packed {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride: number;
  count: number;
  mode: keyof typeof MOST_PER_BYTE;
  filter?: string;
}

function packedOf(view: GltfBufferView): Packed | null {
  for (const name of MESHOPT) {
    const packed: unknown = view.extensions?.[name];
    if (typeof packed === "object" && packed !== null) return packed as Packed;
  }
  return null;
}

export function isPacked(view: GltfBufferView): boolean {
  return packedOf(view) !== null;
}

/** Buffers that only stand in for what is packed need no file. */
export function forgetFallbacks(json: Gltf): void {
  for (const buffer of json.buffers ?? []) {
    if (MESHOPT.some((name) => (buffer.extensions?.[name] as { fallback?: boolean } | undefined)?.fallback === true)) delete buffer.uri;
  }
}

type Whole = Pick<GltfDocument, "json" | "buffers">;

/** Takes the JSON over. Errors (ModelError): sizes that do not fit; packed bytes that are none. */
export async function expand(name: string, json: Gltf, buffers: readonly Uint8Array[]): Promise<Whole> {
  const whole = { json, buffers: [...buffers] };
  if (json.bufferViews?.some(isPacked)) await unpackMeshopt(name, whole);
  if (json.meshes?.some(({ primitives }) => primitives.some(({ extensions }) => extensions?.[DRACO] !== undefined))) {
    const { unpackDraco } = await import("./unpack-draco");
    await unpackDraco(name, whole);
  }
  if (json.accessors?.some(({ sparse }) => sparse !== undefined)) {
    checkAccessors(name, json);
    fillSparse(whole);
  }
  for (const list of ["extensionsUsed", "extensionsRequired"] as const) {
    const left = json[list]?.filter((used) => used !== DRACO && !MESHOPT.includes(used)) ?? [];
    if (left.length > 0) json[list] = left;
    else delete json[list];
  }
  return whole;
}

interface Growing {
  readonly json: Gltf;
  readonly buffers: Uint8Array[];
}

/** A buffer of its own for some bytes; its number. */
export function addBuffer({ json, buffers }: Growing, bytes: Uint8Array): number {
  (json.buffers ??= []).push({ byteLength: bytes.length });
  return buffers.push(bytes) - 1;
}

async function unpackMeshopt(name: string, whole: Growing): Promise<void> {
  const { MeshoptDecoder } = await import("meshoptimizer/decoder");
  await MeshoptDecoder.ready;
  let total = 0;
  for (const [i, view] of (whole.json.bufferViews ?? []).entries()) {
    const packed = packedOf(view);
    if (!packed) continue;
    const { buffer, byteOffset = 0, byteLength, byteStride, count, mode, filter = "NONE" } = packed;
    const size = count * byteStride;
    total += size;
    const bytes = whole.buffers[buffer];
    const isWhole = [byteOffset, byteLength, byteStride, count].every((n) => Number.isInteger(n) && n >= 0);
    if (!bytes || !isWhole || !MODES.includes(mode) || !FILTERS.includes(filter) || byteOffset + byteLength > bytes.length) {
      throw broken(name, `buffer view ${i} is packed in an unknown way`);
    }
    if (!(size > 0) || size > view.byteLength || size > byteLength * MOST_PER_BYTE[mode]) {
      throw broken(name, `buffer view ${i} does not hold ${count} x ${byteStride} bytes`);
    }
    if (total > MOST_UNPACKED) throw new ModelError(`${name} would unpack to more than 256 MB. Simplify it first.`);
    const plain = new Uint8Array(size);
    try {
      MeshoptDecoder.decodeGltfBuffer(plain, count, byteStride, bytes.subarray(byteOffset, byteOffset + byteLength), mode, filter);
    } catch {
      throw broken(name, `what is packed in buffer view ${i} cannot be unpacked`);
    }
    view.buffer = addBuffer(whole, plain);
    view.byteOffset = 0;
    view.byteLength = size;
    for (const extension of MESHOPT) delete view.extensions?.[extension];
    if (Object.keys(view.extensions ?? {}).length === 0) delete view.extensions;
  }
}

/** Each gets bytes of its own, tightly packed. */
function fillSparse(whole: Growing): void {
  const { json, buffers } = whole;
  const views = (json.bufferViews ??= []);
  const bytesOf = (index: number, offset = 0): DataView => {
    const { buffer, byteOffset = 0, byteLength } = views[index];
    const bytes = buffers[buffer];
    return new DataView(bytes.buffer, bytes.byteOffset + byteOffset + offset, byteLength - offset);
  };
  for (const accessor of json.accessors ?? []) {
    const { sparse, componentType, type, count, bufferView, byteOffset } = accessor;
    if (!sparse) continue;
    const element = COMPONENTS[componentType].size * WIDTHS[type];
    const out = new Uint8Array(count * element);
    const copy = (from: DataView, at: number, to: number): void => {
      if (to < count) out.set(new Uint8Array(from.buffer, from.byteOffset + at, element), to * element);
    };
    if (bufferView !== undefined) {
      const from = bytesOf(bufferView, byteOffset);
      const stride = views[bufferView].byteStride || element;
      for (let i = 0; i < count; i++) copy(from, i * stride, i);
    }
    const { size, read } = COMPONENTS[sparse.indices.componentType];
    const indices = bytesOf(sparse.indices.bufferView, sparse.indices.byteOffset);
    const values = bytesOf(sparse.values.bufferView, sparse.values.byteOffset);
    for (let i = 0; i < sparse.count; i++) copy(values, i * element, read(indices, i * size));
    accessor.bufferView = views.push({ buffer: addBuffer(whole, out), byteOffset: 0, byteLength: out.length }) - 1;
    accessor.byteOffset = 0;
    delete accessor.sparse;
  }
}
