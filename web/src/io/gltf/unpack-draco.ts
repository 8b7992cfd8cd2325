// Primitives packed by Draco become plain ones. The decoder is in the chunk itself: one way for a page, its worker and Node.

/// <reference path="./draco3dgltf.d.ts" />

import wasm from "draco3dgltf/draco_decoder_gltf.wasm?inline";
import createDecoder from "draco3dgltf/draco_decoder_gltf_nodejs.js";

import { COMPONENTS, WIDTHS } from "../../gltf/accessors";
import type { Gltf, GltfPrimitive } from "../../gltf/document";
import { broken } from "./check";

const DRACO = "KHR_draco_mesh_compression";

interface Whole {
  readonly json: Gltf;
  readonly buffers: Uint8Array[];
}

/** Takes the JSON over. Errors (ModelError): packed bytes that are none, or are not what the primitive says. */
export async function unpackDraco(name: string, whole: Whole): Promise<void> {
  const draco = await createDecoder({
    wasmBinary: Uint8Array.from(atob(wasm.slice(wasm.indexOf(",") + 1)), (letter) => letter.charCodeAt(0)),
  });
  const decoder = new draco.Decoder();
  for (const [m, { primitives }] of (whole.json.meshes ?? []).entries()) {
    for (const primitive of primitives) {
      const packed: unknown = primitive.extensions?.[DRACO];
      if (packed === undefined) continue;
      const geometry = new draco.Mesh();
      try {
        unpack(draco, decoder, geometry, whole, primitive, packed as Packed);
      } catch {
        throw broken(name, `what is packed in mesh ${m} cannot be unpacked`);
      } finally {
        draco.destroy(geometry);
      }
      delete primitive.extensions![DRACO];
      if (Object.keys(primitive.extensions!).length === 0) delete primitive.extensions;
    }
  }
  draco.destroy(decoder);
}

interface Packed {
  bufferView: number;
  attributes: Record<string, number>;
}

type Draco = Awaited<ReturnType<typeof createDecoder>>;
type Decoder = InstanceType<Draco["Decoder"]>;
type Geometry = InstanceType<Draco["Mesh"]>;

function unpack(draco: Draco, decoder: Decoder, geometry: Geometry, whole: Whole, primitive: GltfPrimitive, packed: Packed): void {
  const { json, buffers } = whole;
  const accessors = (json.accessors ??= []);
  const view = json.bufferViews?.[packed.bufferView];
  if (!view) throw new RangeError("no such view");
  const start = view.byteOffset ?? 0;
  const bytes = buffers[view.buffer].slice(start, start + view.byteLength);
  const status = decoder.DecodeArrayToMesh(new Int8Array(bytes.buffer), bytes.length, geometry);
  if (!status.ok() || geometry.ptr === 0) throw new RangeError(status.error_msg());

  const put = (values: Uint8Array): number => {
    buffers.push(values);
    (json.buffers ??= []).push({ byteLength: values.length });
    return (json.bufferViews ??= []).push({ buffer: buffers.length - 1, byteOffset: 0, byteLength: values.length }) - 1;
  };
  const taken = (size: number, take: (pointer: number) => boolean): Uint8Array => {
    const pointer = draco._malloc(size);
    try {
      if (!take(pointer)) throw new RangeError("no values");
      return draco.HEAPU8.slice(pointer, pointer + size);
    } finally {
      draco._free(pointer);
    }
  };
  for (const [key, id] of Object.entries(packed.attributes)) {
    const accessor = accessors[primitive.attributes[key]];
    const attribute = decoder.GetAttributeByUniqueId(geometry, id);
    const { size } = COMPONENTS[accessor.componentType];
    const count = geometry.num_points();
    if (attribute.ptr === 0 || attribute.num_components() !== WIDTHS[accessor.type]) throw new RangeError(key);
    const length = count * WIDTHS[accessor.type] * size;
    const values = taken(length, (pointer) =>
      decoder.GetAttributeDataArrayForAllPoints(geometry, attribute, KINDS[accessor.componentType](draco), length, pointer),
    );
    Object.assign(accessor, { bufferView: put(values), byteOffset: 0, count });
  }
  const corners = 3 * geometry.num_faces();
  const index = taken(4 * corners, (pointer) => decoder.GetTrianglesUInt32Array(geometry, 4 * corners, pointer));
  primitive.indices = accessors.push({ bufferView: put(index), componentType: 5125, count: corners, type: "SCALAR" }) - 1;
  primitive.mode = 4;
}

const KINDS: Readonly<Record<number, (draco: Draco) => number>> = {
  5120: (draco) => draco.DT_INT8,
  5121: (draco) => draco.DT_UINT8,
  5122: (draco) => draco.DT_INT16,
  5123: (draco) => draco.DT_UINT16,
  5125: (draco) => draco.DT_UINT32,
  5126: (draco) => draco.DT_FLOAT32,
};
