// Materials of three.js objects as those of glTF.

import {
  type Color,
  type Material,
  type MeshPhongMaterial,
  type MeshPhysicalMaterial,
  type MeshStandardMaterial,
  ClampToEdgeWrapping,
  DoubleSide,
  MirroredRepeatWrapping,
  NearestFilter,
  type Texture,
} from "three";

import type { GltfMaterial, GltfSampler, GltfTextureInfo } from "../../gltf/document";
import { isNormalMap } from "../picture";
import type { PictureShelf } from "../picture-shelf";
import type { LoadedPicture } from "./surroundings";

/** What a material may have, whichever kind it is. */
type Any = Material & Partial<Omit<MeshPhysicalMaterial & MeshPhongMaterial, keyof Material>>;

export class SceneMaterials {
  readonly materials: GltfMaterial[] = [];
  private readonly known = new Map<Material, number | null>();

  constructor(private readonly shelf: PictureShelf) {}

  /** Its number; null for the one that loaders put where none was named. */
  indexOf(material: Material): number | null {
    const known = this.known.get(material);
    if (known !== undefined) return known;
    const index = material.name === "__DEFAULT" ? null : this.materials.push(this.converted(material as Any)) - 1;
    this.known.set(material, index);
    return index;
  }

  private converted(material: Any): GltfMaterial {
    const { map, emissiveMap, aoMap } = material;
    const baseColorTexture = this.texture(map);
    const emissiveTexture = this.texture(emissiveMap);
    const normalTexture = this.texture(material.normalMap ?? (isNamedNormals(material.bumpMap) ? material.bumpMap : null));
    const occlusionTexture = this.texture(aoMap);
    const specularColorTexture = this.texture(material.specularMap ?? material.specularColorMap);
    const opacity = material.opacity > 0 ? Math.min(material.opacity, 1) : 1; // a body that cannot be seen is a mistake of its writer
    const color = [...(map && !isStandard(material) ? [1, 1, 1] : rgb(material.color)), opacity];
    const emissive = emissiveMap ? [1, 1, 1] : rgb(material.emissive, material.emissiveIntensity, 0);
    const alphaMode = material.alphaTest > 0 || (material.transparent && opacity === 1 && map) ? "MASK" : opacity < 1 ? "BLEND" : null;
    return {
      ...(material.name && { name: material.name }),
      pbrMetallicRoughness: {
        ...(color.some((c) => c !== 1) && { baseColorFactor: color }),
        ...(baseColorTexture && { baseColorTexture }),
        ...this.surfaceOf(material),
      },
      ...(normalTexture && { normalTexture }),
      ...(occlusionTexture && { occlusionTexture }),
      ...(emissiveTexture && { emissiveTexture }),
      ...(emissive.some((c) => c > 0) && { emissiveFactor: emissive }),
      ...(alphaMode && { alphaMode }),
      ...(material.alphaTest > 0 && { alphaCutoff: material.alphaTest }),
      ...(material.side === DoubleSide && { doubleSided: true }),
      ...(specularColorTexture && { extensions: { KHR_materials_specular: { specularColorTexture } } }),
    };
  }

  private surfaceOf(material: Any): NonNullable<GltfMaterial["pbrMetallicRoughness"]> {
    if (!isStandard(material)) return { metallicFactor: 0, roughnessFactor: roughness(material) };
    const { metalness, metalnessMap, roughnessMap } = material;
    const together = metalnessMap && addressOf(metalnessMap) === addressOf(roughnessMap) ? this.texture(metalnessMap) : null;
    if (together) return { metallicFactor: metalness, roughnessFactor: material.roughness, metallicRoughnessTexture: together };
    // glTF has both in one picture: of two, what they usually say.
    return { metallicFactor: metalnessMap ? 0 : metalness, roughnessFactor: roughnessMap ? 0.7 : material.roughness };
  }

  private texture(texture: Texture | null | undefined): GltfTextureInfo | null {
    const image = texture?.image as LoadedPicture | undefined;
    if (!texture || !image?.src) return null;
    const [{ x: su, y: sv }, { x: ou, y: ov }] = [texture.repeat, texture.offset];
    const moved = su !== 1 || sv !== 1 || ou !== 0 || ov !== 0;
    const frame = moved ? { offset: [ou, 1 - sv - ov], scale: [su, sv] } : null; // v is turned down
    const { src, bytes } = image;
    const sampler = samplerOf(texture);
    if (!bytes) return this.shelf.texture(src, sampler, frame, texture.channel);
    return this.shelf.held(src, texture.name, bytes, sampler, frame, texture.channel);
  }
}

function isStandard(material: Any): material is Any & MeshStandardMaterial {
  return "isMeshStandardMaterial" in material;
}

function addressOf(texture: Texture | null | undefined): string | undefined {
  return (texture?.image as LoadedPicture | undefined)?.src;
}

function isNamedNormals(bump: Texture | null | undefined): boolean {
  return isNormalMap(addressOf(bump) ?? "") || isNormalMap(bump?.name ?? "");
}

/** By Blender's rule for the shininess of FBX; a body is never quite a mirror. */
function roughness({ shininess, specular }: Any): number {
  if (shininess === undefined || !specular || specular.getHex() === 0) return 1;
  return Math.min(Math.max(1 - Math.sqrt(shininess) / 10, 0.2), 1);
}

function rgb(color: Color | undefined, intensity = 1, missing = 1): number[] {
  const parts = color ? [color.r, color.g, color.b] : [missing, missing, missing];
  return parts.map((c) => Math.min(Math.max(c * intensity, 0), 1));
}

/** Null for what glTF does without one. */
function samplerOf({ wrapS, wrapT, magFilter }: Texture): GltfSampler | null {
  const wrap = (mode: number): number => (mode === ClampToEdgeWrapping ? 33071 : mode === MirroredRepeatWrapping ? 33648 : 10497);
  const sampler = {
    ...(wrap(wrapS) !== 10497 && { wrapS: wrap(wrapS) }),
    ...(wrap(wrapT) !== 10497 && { wrapT: wrap(wrapT) }),
    ...(magFilter === NearestFilter && { magFilter: 9728 }),
  };
  return Object.keys(sampler).length > 0 ? sampler : null;
}
