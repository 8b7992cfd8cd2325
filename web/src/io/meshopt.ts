// Buffers packed by meshopt (EXT_ and KHR_meshopt_compression) become plain ones. The decoder is loaded only for a file that has some.

import type { GLTF, JSONDocument } from "@gltf-transform/core";

const NAMES = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
const MODES = ["ATTRIBUTES", "TRIANGLES", "INDICES"];
const FILTERS = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"];
/** The most that one file may unpack to, in bytes: about ten million vertices. */
const MOST = 2 ** 30;

interface Packed {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride: number;
  count: number;
  mode: string;
  filter?: string;
}

function packedOf(view: GLTF.IBufferView): Packed | null {
  for (const name of NAMES) {
    const packed: unknown = view.extensions?.[name];
    if (typeof packed === "object" && packed !== null) return packed as Packed;
  }
  return null;
}

/** True if a buffer view of the file is packed. */
export function hasMeshopt(json: GLTF.IGLTF): boolean {
  return json.bufferViews?.some((view) => packedOf(view)) ?? false;
}

/** Buffers that only stand in for what is packed need no file. */
export function forgetFallbacks(json: GLTF.IGLTF): void {
  for (const buffer of json.buffers ?? []) {
    if (NAMES.some((name) => (buffer.extensions?.[name] as { fallback?: boolean } | undefined)?.fallback === true)) delete buffer.uri;
  }
}

/**
 * Unpacks every packed buffer view into a buffer of its own. `bytesOf` gives a buffer's bytes. Errors (RangeError): sizes that do
 * not fit; the decoder's own Error, where the packed bytes are no such thing.
 */
export async function unpackMeshopt(source: JSONDocument, bytesOf: (buffer: number) => Uint8Array): Promise<void> {
  const { json } = source;
  const { MeshoptDecoder } = await import("meshoptimizer/decoder");
  await MeshoptDecoder.ready;
  const buffers = (json.buffers ??= []);
  let total = 0;
  for (const [i, view] of (json.bufferViews ?? []).entries()) {
    const packed = packedOf(view);
    if (!packed) continue;
    const { byteOffset = 0, byteLength, byteStride, count, mode, filter = "NONE" } = packed;
    const size = count * byteStride;
    total += size;
    if (!Number.isInteger(count) || !Number.isInteger(byteStride) || !(size > 0) || size > view.byteLength || total > MOST) {
      throw new RangeError(`buffer view ${i} does not hold ${count} x ${byteStride} bytes`);
    }
    const bytes = bytesOf(packed.buffer);
    if (!MODES.includes(mode) || !FILTERS.includes(filter) || byteOffset + byteLength > bytes.length) {
      throw new RangeError(`buffer view ${i} is packed in an unknown way`);
    }
    const plain = new Uint8Array(size);
    MeshoptDecoder.decodeGltfBuffer(plain, count, byteStride, bytes.subarray(byteOffset, byteOffset + byteLength), mode, filter);
    const uri = `unpacked-${i}.bin`;
    view.buffer = buffers.push({ byteLength: size, uri }) - 1;
    view.byteOffset = 0;
    view.byteLength = size;
    delete view.extensions;
    source.resources[uri] = plain;
  }
}
