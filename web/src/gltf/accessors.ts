// The values of an accessor that was checked and is neither sparse nor packed.

import type { GltfDocument } from "./document";

export const WIDTHS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };

interface Component {
  readonly size: number;
  /** What a normalised value is divided by. */
  readonly one: number;
  readonly read: (view: DataView, at: number) => number;
}

export const COMPONENTS: Readonly<Record<number, Component>> = {
  5120: { size: 1, one: 127, read: (view, at) => view.getInt8(at) },
  5121: { size: 1, one: 255, read: (view, at) => view.getUint8(at) },
  5122: { size: 2, one: 32767, read: (view, at) => view.getInt16(at, true) },
  5123: { size: 2, one: 65535, read: (view, at) => view.getUint16(at, true) },
  5125: { size: 4, one: 4294967295, read: (view, at) => view.getUint32(at, true) },
  5126: { size: 4, one: 1, read: (view, at) => view.getFloat32(at, true) },
};

/** Count x width numbers, normalised ones from 0 or -1 to 1. Zeros where the accessor has no bytes. */
export function accessorValues({ json, buffers }: GltfDocument, index: number): Float64Array | Float32Array {
  const accessor = json.accessors![index];
  const width = WIDTHS[accessor.type];
  const out = new (accessor.componentType === 5126 ? Float32Array : Float64Array)(accessor.count * width);
  const view = accessor.bufferView === undefined ? undefined : json.bufferViews![accessor.bufferView];
  if (!view) return out;
  const { size, one, read } = COMPONENTS[accessor.componentType];
  const bytes = buffers[view.buffer];
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const stride = view.byteStride || size * width;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const scale = accessor.normalized ? one : 1;
  for (let i = 0, o = 0; i < accessor.count; i++) {
    for (let k = 0, at = start + i * stride; k < width; k++, at += size) {
      const x = read(data, at);
      out[o++] = scale === 1 ? x : Math.max(-1, x / scale);
    }
  }
  return out;
}
