// A glTF document in hand: the file's own JSON, whatever it holds, and the bytes that it names. Every model is one, whatever format
// it came in, and nothing here is ever changed in place: what is drawn, solved and written are views on it.

/** Of one kind of thing: what we read. What we do not know stays in the object. */
interface Known {
  name?: string;
  extensions?: Record<string, unknown>;
  extras?: unknown;
}

export interface GltfAccessor extends Known {
  bufferView?: number;
  byteOffset?: number;
  componentType: number;
  normalized?: boolean;
  count: number;
  type: string;
  min?: number[];
  max?: number[];
  sparse?: {
    count: number;
    indices: { bufferView: number; byteOffset?: number; componentType: number };
    values: { bufferView: number; byteOffset?: number };
  };
}

export interface GltfBufferView extends Known {
  buffer: number;
  byteOffset?: number;
  byteLength: number;
  byteStride?: number;
  target?: number;
}

export interface GltfPrimitive extends Known {
  attributes: Record<string, number>;
  indices?: number;
  material?: number;
  mode?: number;
  targets?: Record<string, number>[];
}

export interface GltfMesh extends Known {
  primitives: GltfPrimitive[];
  weights?: number[];
}

export interface GltfNode extends Known {
  children?: number[];
  mesh?: number;
  skin?: number;
  camera?: number;
  matrix?: number[];
  translation?: number[];
  rotation?: number[];
  scale?: number[];
  weights?: number[];
}

export interface GltfSkin extends Known {
  skeleton?: number;
  joints: number[];
  inverseBindMatrices?: number;
}

export interface GltfTextureInfo {
  index: number;
  texCoord?: number;
  extensions?: Record<string, unknown>;
}

export interface GltfMaterial extends Known {
  pbrMetallicRoughness?: {
    baseColorFactor?: number[];
    baseColorTexture?: GltfTextureInfo;
    metallicFactor?: number;
    roughnessFactor?: number;
    metallicRoughnessTexture?: GltfTextureInfo;
  };
  normalTexture?: GltfTextureInfo & { scale?: number };
  occlusionTexture?: GltfTextureInfo & { strength?: number };
  emissiveTexture?: GltfTextureInfo;
  emissiveFactor?: number[];
  alphaMode?: string;
  alphaCutoff?: number;
  doubleSided?: boolean;
}

export interface GltfTexture extends Known {
  sampler?: number;
  source?: number;
}

export interface GltfImage extends Known {
  uri?: string;
  mimeType?: string;
  bufferView?: number;
}

export interface GltfSampler extends Known {
  magFilter?: number;
  minFilter?: number;
  wrapS?: number;
  wrapT?: number;
}

export interface GltfAnimation extends Known {
  channels: unknown[];
  samplers: { input: number; output: number; interpolation?: string }[];
}

export interface Gltf extends Known {
  asset: { version: string; generator?: string };
  extensionsUsed?: string[];
  extensionsRequired?: string[];
  accessors?: GltfAccessor[];
  animations?: GltfAnimation[];
  buffers?: ({ byteLength: number; uri?: string } & Known)[];
  bufferViews?: GltfBufferView[];
  cameras?: unknown[];
  images?: GltfImage[];
  materials?: GltfMaterial[];
  meshes?: GltfMesh[];
  nodes?: GltfNode[];
  samplers?: GltfSampler[];
  scene?: number;
  scenes?: ({ nodes?: number[] } & Known)[];
  skins?: GltfSkin[];
  textures?: GltfTexture[];
}

export interface Picture {
  readonly bytes: Uint8Array;
  readonly mime: string;
  /** Of a kind and a size that the page shows. */
  readonly drawn: boolean;
}

export interface GltfDocument {
  readonly json: Gltf;
  /** By json.buffers. */
  readonly buffers: readonly Uint8Array[];
  /** By json.images; null for one that is missing or that we cannot show. */
  readonly images: readonly (Picture | null)[];
}
