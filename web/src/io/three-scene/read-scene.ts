// From a loader's tree to a document's parts.

import { Group, type Object3D } from "three";

import type { Built } from "../gltf/build";
import { count } from "../count";
import { listed } from "../formats";
import { ModelError, type NamedFile } from "../named-file";
import { PictureShelf } from "../picture-shelf";
import { SKINNED } from "../skinned";
import type { NamedJoint } from "../../sync/named-body";
import { sceneParts } from "./built-scene";
import { SceneMaterials } from "./scene-materials";

export interface BuiltScene extends Built {
  readonly joints: readonly NamedJoint[];
}

export interface SceneSource {
  /** Without folders. */
  readonly name: string;
  readonly file: NamedFile;
  readonly files: readonly NamedFile[];
  readonly notes: string[];
  /** 0..1 of the reading, now and then. */
  readonly onProgress?: (done: number) => void;
}

/** Of the reading, what the loader's part of it is. */
const PARSED = 0.7;

/** What `parse` makes; errors (ModelError): whatever goes wrong in a loader, which expects a sound file, says that it is broken. */
export function parsed<T>(name: string, kind: string, parse: () => T): T {
  try {
    return parse();
  } catch (error) {
    if (error instanceof ModelError) throw error;
    throw new ModelError(
      `${name} is a broken ${kind} file, or has parts that we cannot read. Open it in Blender and save it as glTF 2.0 (.glb).`,
      { cause: error },
    );
  }
}

/** `metres`: what a unit of the tree is long. Errors (ModelError): it holds no triangles. */
export function readScene({ name, file, files, notes, onProgress }: SceneSource, tree: Object3D, metres: number): BuiltScene {
  onProgress?.(PARSED);
  const world = new Group();
  world.scale.setScalar(metres);
  world.add(tree);
  const shelf = new PictureShelf(files, file.name, notes);
  const materials = new SceneMaterials(shelf);
  const { parts, joints, skinned, morphed, others } = sceneParts(world, (material) => materials.indexOf(material));
  if (parts.length === 0) throw new ModelError(noMesh(name, joints.length, others));
  if (skinned) notes.push(SKINNED);
  if (morphed) notes.push("This file has shape keys. We use its current shape.");
  shelf.close();
  return { parts, joints, materials: materials.materials, pictures: shelf.pictures };
}

function noMesh(name: string, joints: number, others: number): string {
  if (joints > 0) {
    return `${name} holds a skeleton of ${count(joints, "joint")}, but no mesh. Motions are read from ${listed("motion", "or")}.`;
  }
  if (others > 0) return `${name} holds lines or points, but no triangles. Save it as a mesh.`;
  return `${name} holds no mesh. Save the model itself into it, not a camera or an empty scene.`;
}
