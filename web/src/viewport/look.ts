// What a document's surfaces look like, by three's GLTFLoader: it makes materials, textures and what else lies on vertices. Nothing is
// fetched and no scene is walked; where vertices are is the stage's own.

import {
  type BufferAttribute,
  DoubleSide,
  FrontSide,
  type InterleavedBufferAttribute,
  type Material,
  Mesh,
  MeshStandardMaterial,
  ReplaceStencilOp,
  Texture,
  type WebGLRenderer,
} from "three";
import { type GLTFLoaderPlugin, GLTFLoader, type GLTFParser } from "three/examples/jsm/loaders/GLTFLoader.js";
import { dressBare } from "../gltf/bare";
import type { Gltf, GltfDocument, GltfPrimitive } from "../gltf/document";
import type { DrawnInstance } from "../gltf/drawn";

type Attribute = BufferAttribute | InterleavedBufferAttribute;

export interface Look {
  /** By instance. */
  readonly materials: readonly Material[];
  /** By instance: uv, color and their like, over the accessors' vertices. */
  readonly attributes: readonly Readonly<Record<string, Attribute>>[];
  dispose(): void;
}

/** Mirrors enough that it would be dark without surroundings. */
const LEAST_METAL = 0.2;

/** With a renderer, metal mirrors a room. Errors: three's own, for what it cannot make sense of. */
export async function loadLook(document: GltfDocument, instances: readonly DrawnInstance[], renderer?: WebGLRenderer): Promise<Look> {
  const json = dressOnly(dressBare(document.json));
  const textures = new Set<Texture>();
  const loader = new GLTFLoader().register((parser) => fromDocument(document, parser, textures));
  const { parser } = await loader.parseAsync(json as unknown as ArrayBuffer, ""); // takes JSON too, though its types do not say so
  const meshes = await Promise.all(
    instances.map(async ({ mesh, primitive }) => {
      const made = await parser.getDependency("mesh", mesh);
      return (made instanceof Mesh ? made : made.children[primitive]) as Mesh;
    }),
  );
  const bothSides = new Map<Material, Material>();
  const materials = meshes.map((mesh, i) => {
    const material = mesh.material as Material;
    const made = instances[i]!.open && material.side === FrontSide ? (bothSides.get(material) ?? twoSided(material)) : material;
    if (made !== material) bothSides.set(material, made);
    marked(made);
    return made;
  });
  const metal = [...new Set(materials)].filter((material) => material instanceof MeshStandardMaterial && material.metalness > LEAST_METAL);
  const room = renderer && metal.length > 0 ? (await import("./reflections")).reflect(metal, renderer) : null;
  return {
    materials,
    attributes: meshes.map(({ geometry: { attributes } }) => {
      const { normal: _, ...others } = attributes;
      return others;
    }),
    dispose: () => {
      for (const made of [...materials, ...textures]) made.dispose();
      for (const { geometry } of meshes) geometry.dispose();
      room?.dispose();
    },
  };
}

function twoSided(material: Material): Material {
  const clone = material.clone();
  clone.side = DoubleSide;
  return clone;
}

/** Its pixels carry a mark, so that the ghost stays behind. */
function marked(material: Material): void {
  material.stencilWrite = true;
  material.stencilRef = 1;
  material.stencilZPass = ReplaceStencilOp;
}

/** The JSON without what moves and where it is: meshes that hold materials and what lies on vertices. */
function dressOnly(json: Gltf): Gltf {
  const {
    scenes: _0,
    scene: _1,
    nodes: _2,
    skins: _3,
    animations: _4,
    cameras: _5,
    extensionsRequired: _6,
    accessors = [],
    ...rest
  } = json;
  // Whether there are normals decides how it is shaded; which ones it does not need to know.
  const normal = accessors.length;
  const bare = ({ attributes, material }: GltfPrimitive): GltfPrimitive => ({
    attributes: {
      ...Object.fromEntries(Object.entries(attributes).filter(([key]) => /^(TEXCOORD_[0-3]|COLOR_0)$/.test(key))),
      ...(attributes.NORMAL !== undefined && { NORMAL: normal }),
    },
    ...(material !== undefined && { material }),
  });
  return {
    ...rest,
    accessors: [...accessors, { componentType: 5126, type: "VEC3", count: 1 }],
    meshes: (json.meshes ?? []).map(({ primitives }) => ({ primitives: primitives.map(bare) })),
  };
}

/** Bytes and pictures come from the document in hand; a picture that cannot be shown leaves its material without. */
function fromDocument({ json, buffers, images }: GltfDocument, parser: GLTFParser, textures: Set<Texture>): GLTFLoaderPlugin {
  const made = new Map<number, Promise<Texture>>();
  parser.loadImageSource = async (source) => {
    const known = made.get(source);
    if (known) {
      const clone = (await known).clone();
      textures.add(clone);
      return clone;
    }
    const { bytes, mime } = images[source]!;
    const texture = decoded(bytes, mime);
    made.set(source, texture);
    textures.add(await texture);
    return texture;
  };
  const plugin: GLTFLoaderPlugin & { loadBufferView(index: number): Promise<ArrayBuffer> } = {
    name: "document",
    loadBufferView: async (index) => {
      const { buffer, byteOffset = 0, byteLength, byteStride = 0 } = json.bufferViews![index]!;
      // Interleaved values end before their last stride does, and three looks at whole strides.
      const out = new Uint8Array(byteLength + byteStride);
      out.set(buffers[buffer]!.subarray(byteOffset, byteOffset + byteLength));
      return out.buffer;
    },
    loadTexture: async (index) => {
      const { source, extensions } = json.textures![index]!;
      const webp = extensions?.["EXT_texture_webp"] as { source?: number } | undefined;
      const basis = extensions?.["KHR_texture_basisu"] as { source?: number } | undefined;
      const shown = [basis?.source, webp?.source, source].find((image) => image !== undefined && images[image]?.drawn === true);
      // GLTFLoader goes on without a texture that is null, though its types do not say so.
      if (shown === undefined) return null as unknown as Texture;
      return parser.loadTextureImage(index, shown, parser.textureLoader) as Promise<Texture>;
    },
  };
  return plugin;
}

async function decoded(bytes: Uint8Array, mime: string): Promise<Texture> {
  const image =
    mime === "image/ktx2" ? await (await import("./ktx2")).decodeKtx2(bytes) : new Blob([bytes as Uint8Array<ArrayBuffer>], { type: mime });
  const texture = new Texture(await createImageBitmap(image, { premultiplyAlpha: "none", colorSpaceConversion: "none" }));
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
