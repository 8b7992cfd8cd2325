// Numbers as glTF holds them: accessors, views and the bytes of both.

import type { Gltf, GltfAccessor, GltfBufferView } from "../../gltf/document";
import { WIDTHS } from "../../gltf/accessors";

export type Values = Float32Array | Uint32Array | Uint16Array | Int16Array | Uint8Array;
export type AccessorType = "SCALAR" | "VEC2" | "VEC3" | "VEC4" | "MAT4";

/** What a view is for, as WebGL counts it. */
export const VERTICES = 34962;
export const INDICES = 34963;

export interface PackOptions {
  readonly target?: number;
  /** With its least and largest values, as glTF wants for positions and times. */
  readonly bounded?: boolean;
  /** Whole numbers that stand for 0 to 1, or -1 to 1. */
  readonly normalized?: boolean;
}

function componentOf(values: Values): number {
  if (values instanceof Float32Array) return 5126;
  if (values instanceof Uint32Array) return 5125;
  if (values instanceof Uint16Array) return 5123;
  return values instanceof Int16Array ? 5122 : 5121;
}

/** An accessor for all of `values`, which has a view of its own. */
export function packAccessor(
  values: Values,
  type: AccessorType,
  { target, bounded = false, normalized = false }: PackOptions,
): { accessor: GltfAccessor; view: GltfBufferView; bytes: Uint8Array } {
  const width = WIDTHS[type];
  const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  const count = values.length / width;
  const accessor: GltfAccessor = { componentType: componentOf(values), ...(normalized && { normalized }), count, type };
  if (bounded) Object.assign(accessor, boundsOf(values, width));
  return { accessor, view: { buffer: 0, byteLength: bytes.length, ...(target !== undefined && { target }) }, bytes };
}

function boundsOf(values: Values, width: number): { min: number[]; max: number[] } {
  const min = new Array<number>(width).fill(Infinity);
  const max = new Array<number>(width).fill(-Infinity);
  for (let i = 0; i < values.length; i++) {
    const k = i % width;
    if (values[i] < min[k]) min[k] = values[i];
    if (values[i] > max[k]) max[k] = values[i];
  }
  return { min, max };
}

/** The one buffer of a document in the making. */
export class Packer {
  private readonly views: GltfBufferView[] = [];
  private readonly accessors: GltfAccessor[] = [];
  private readonly chunks: Uint8Array[] = [];
  private size = 0;

  /** A view of its own for some bytes; its number. They are not copied before `bytes`. */
  view(bytes: Uint8Array, view?: GltfBufferView): number {
    const byteOffset = this.size;
    const filled = (bytes.length + 3) & ~3;
    this.chunks.push(bytes, new Uint8Array(filled - bytes.length));
    this.size += filled;
    return this.views.push({ ...view, buffer: 0, byteOffset, byteLength: bytes.length }) - 1;
  }

  /** An accessor for all of `values`; its number. */
  accessor(values: Values, type: AccessorType, options: PackOptions): number {
    const { accessor, view, bytes } = packAccessor(values, type, options);
    return this.accessors.push({ ...accessor, bufferView: this.view(bytes, view) }) - 1;
  }

  bytes(): Uint8Array<ArrayBuffer> {
    const out = new Uint8Array(this.size);
    let at = 0;
    for (const chunk of this.chunks) {
      out.set(chunk, at);
      at += chunk.length;
    }
    return out;
  }

  /** The JSON of what was packed. */
  json(): Pick<Gltf, "buffers" | "bufferViews" | "accessors"> {
    return { buffers: [{ byteLength: this.size }], bufferViews: this.views, accessors: this.accessors };
  }
}
