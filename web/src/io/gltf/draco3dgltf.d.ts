// What we use of Draco's decoder, which brings no types.

declare module "draco3dgltf/draco_decoder_gltf.wasm?inline" {
  const address: string;
  export { address as default };
}

declare module "draco3dgltf/draco_decoder_gltf_nodejs.js" {
  interface Held {
    readonly ptr: number;
  }
  interface Mesh extends Held {
    num_points(): number;
    num_faces(): number;
  }
  interface Attribute extends Held {
    num_components(): number;
  }
  interface Decoder extends Held {
    DecodeArrayToMesh(bytes: Int8Array, size: number, out: Mesh): { ok(): boolean; error_msg(): string };
    GetAttributeByUniqueId(mesh: Mesh, id: number): Attribute;
    GetAttributeDataArrayForAllPoints(mesh: Mesh, attribute: Attribute, kind: number, size: number, pointer: number): boolean;
    GetTrianglesUInt32Array(mesh: Mesh, size: number, pointer: number): boolean;
  }
  interface Draco {
    readonly Decoder: new () => Decoder;
    readonly Mesh: new () => Mesh;
    readonly HEAPU8: Uint8Array;
    readonly DT_INT8: number;
    readonly DT_UINT8: number;
    readonly DT_INT16: number;
    readonly DT_UINT16: number;
    readonly DT_UINT32: number;
    readonly DT_FLOAT32: number;
    _malloc(size: number): number;
    _free(pointer: number): void;
    destroy(held: Held): void;
  }
  const createDecoder: (options: { wasmBinary: Uint8Array }) => Promise<Draco>;
  export { createDecoder as default };
}
