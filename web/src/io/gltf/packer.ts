// The one buffer of a document in the making: views of it, and accessors on these.

import type { Gltf, GltfAccessor, GltfBufferView } from "../../gltf/document";

type Values = Float32Array | Uint32Array | Uint16Array | Uint8Array;

const WIDTHS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** What a view is for, as WebGL counts it. */
export const VERTICES = 34962;
export const INDICES = 34963;

export class Packer {
  readonly views: GltfBufferView[] = [];
  readonly accessors: GltfAccessor[] = [];
  private readonly chunks: Uint8Array[] = [];
  private size = 0;

  /** A view of its own for some bytes; its number. They are not copied before `bytes`. */
  view(bytes: Uint8Array, rest: Partial<GltfBufferView> = {}): number {
    const view = { ...rest, buffer: 0, byteOffset: this.size, byteLength: bytes.length };
    const filled = (bytes.length + 3) & ~3;
    this.chunks.push(bytes, new Uint8Array(filled - bytes.length));
    this.size += filled;
    return this.views.push(view) - 1;
  }

  /** An accessor for all of `values`; its number. `bounded`: with its least and largest values, as glTF wants for positions and times. */
  accessor(values: Values, type: "SCALAR" | "VEC2" | "VEC3" | "VEC4", { target, bounded = false }: PackOptions = {}): number {
    const width = WIDTHS[type];
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    const bufferView = this.view(bytes, target === undefined ? {} : { target });
    const accessor: GltfAccessor = { bufferView, componentType: componentOf(values), count: values.length / width, type };
    if (bounded) Object.assign(accessor, boundsOf(values, width));
    return this.accessors.push(accessor) - 1;
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

interface PackOptions {
  readonly target?: number;
  readonly bounded?: boolean;
}

function componentOf(values: Values): number {
  if (values instanceof Float32Array) return 5126;
  if (values instanceof Uint32Array) return 5125;
  return values instanceof Uint16Array ? 5123 : 5121;
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
