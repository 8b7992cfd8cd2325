// The pictures that a model names beside it, as textures of a document in the making.

import type { GltfSampler, GltfTextureInfo } from "../gltf/document";
import type { BuiltPicture } from "./gltf/build";
import { wordList } from "./format";
import { baseName, decodeUri, findFile, type NamedFile } from "./named-file";
import { takePicture } from "./take-picture";

type Frame = { readonly offset: readonly number[]; readonly scale: readonly number[]; readonly rotation?: number };

export class PictureShelf {
  readonly pictures: BuiltPicture[] = [];
  private readonly known = new Map<string, number>();
  private readonly missing = new Set<string>();

  constructor(
    private readonly files: readonly NamedFile[],
    /** The model's path. */
    private readonly from: string,
    private readonly notes: string[],
  ) {}

  /** A texture of the picture of this name: any path of any machine, found by its last part where it is not there. */
  texture(name: string, sampler: GltfSampler | null = null, frame: Frame | null = null, texCoord = 0): GltfTextureInfo {
    const file = findFile(this.files, name, this.from) ?? findFile(this.files, decodeUri(name), this.from);
    if (!file) this.missing.add(baseName(name));
    const called = baseName(file?.name ?? name);
    return this.put(file?.name ?? name, called, file?.bytes ?? null, sampler, frame, texCoord);
  }

  /** A texture of a picture that the model itself holds under some address. */
  held(
    address: string,
    name: string,
    bytes: Uint8Array,
    sampler: GltfSampler | null = null,
    frame: Frame | null = null,
    texCoord = 0,
  ): GltfTextureInfo {
    return this.put(address, name || `picture ${this.pictures.length + 1}`, bytes, sampler, frame, texCoord);
  }

  private put(
    address: string,
    name: string,
    bytes: Uint8Array | null,
    sampler: GltfSampler | null,
    frame: Frame | null,
    texCoord: number,
  ): GltfTextureInfo {
    const key = JSON.stringify([address, sampler]);
    let index = this.known.get(key);
    if (index === undefined) {
      const picture = bytes && takePicture(name, bytes, undefined, this.notes);
      index = this.pictures.push({ name, picture, ...(sampler && { sampler }) }) - 1;
      this.known.set(key, index);
    }
    return { index, ...(texCoord > 0 && { texCoord }), ...(frame && { extensions: { KHR_texture_transform: frame } }) };
  }

  /** Says what was not there. */
  close(): void {
    const names = [...this.missing];
    if (names.length > 0) {
      const [shown, more] = [names.slice(0, 5), names.length - 5];
      const list = more > 0 ? `${wordList(shown)} and ${more} more` : wordList(shown, "and");
      this.notes.push(`This model names ${list}; drop ${names.length > 1 ? "them" : "it"} too.`);
    }
  }
}
