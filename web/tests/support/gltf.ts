// glTF made by script, plain JSON and bytes: what a test says is what the file holds.

import { accessorValues } from "../../src/gltf/accessors";
import type { Gltf, GltfDocument, GltfPrimitive } from "../../src/gltf/document";
import { Packer } from "../../src/io/gltf/packer";
import { readDocument } from "../../src/io/gltf/read";
import { packGlb } from "../../src/io/gltf/write";
import type { Model } from "../../src/io/model";
import type { NamedFile } from "../../src/io/named-file";

export const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A document in the making: change `json` at will. */
export class GltfMaker {
  readonly packer = new Packer();
  json: Gltf = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [] };

  floats(values: readonly number[], type: "SCALAR" | "VEC2" | "VEC3" | "VEC4" = "VEC3"): number {
    return this.packer.accessor(Float32Array.from(values), type, { bounded: true });
  }

  shorts(values: readonly number[], type: "SCALAR" | "VEC2" | "VEC4" = "SCALAR"): number {
    return this.packer.accessor(Uint16Array.from(values), type, {});
  }

  /** 4 x 4 matrices: the packer knows none. */
  matrices(values: readonly number[]): number {
    const accessor = this.floats(values, "VEC4");
    const made = this.packer.json().accessors![accessor];
    made.count /= 4;
    made.type = "MAT4";
    delete made.min;
    delete made.max;
    return accessor;
  }

  picture(bytes: Uint8Array): number {
    (this.json.images ??= []).push({ mimeType: "image/png", bufferView: this.packer.view(bytes) });
    return (this.json.textures ??= []).push({ source: this.json.images.length - 1 }) - 1;
  }

  mesh(...primitives: GltfPrimitive[]): number {
    return this.json.meshes!.push({ primitives }) - 1;
  }

  document(): GltfDocument {
    return { json: { ...this.json, ...this.packer.json() }, buffers: [this.packer.bytes()], images: [] };
  }

  glb(name = "t.glb"): NamedFile {
    return { name, bytes: packGlb(this.document()) };
  }
}

/** One triangle on one node, to be changed. */
export function triangle(positions: readonly number[] = TRIANGLE): { maker: GltfMaker; primitive: GltfPrimitive } {
  const maker = new GltfMaker();
  const primitive: GltfPrimitive = { attributes: { POSITION: maker.floats(positions) } };
  maker.mesh(primitive);
  return { maker, primitive };
}

export function openGlb(bytes: Uint8Array): Promise<GltfDocument> {
  const file = { name: "written.glb", bytes };
  return readDocument(file.name, file, [file], []);
}

/** The numbers of an attribute, or of a target's; null where there is none. */
export function valuesOf(document: GltfDocument, key: string, { mesh = 0, primitive = 0, target = -1 } = {}): number[] | null {
  const { attributes, targets = [] } = document.json.meshes![mesh].primitives[primitive];
  const index = (target < 0 ? attributes : targets[target])[key];
  return index === undefined ? null : [...accessorValues(document, index)];
}

/** What the file lays on the vertices that are drawn of a model's instance, such as TEXCOORD_0. */
export function laidOn({ document, drawn }: Model, key: string, width: number, instance = 0): number[] | null {
  const { mesh, primitive, vertices, count } = drawn.instances[instance];
  const values = valuesOf(document, key, { mesh, primitive });
  if (!values) return null;
  return Array.from({ length: count }, (_, r) => values.slice(width * (vertices?.[r] ?? r), width * ((vertices?.[r] ?? r) + 1))).flat();
}
