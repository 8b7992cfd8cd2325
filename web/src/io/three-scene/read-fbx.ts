// FBX 7.0 and later, text and binary, by three's FBXLoader.

import { FBXLoader } from "three/examples/jsm/loaders/FBXLoader.js";
import type { Group, Object3D } from "three";

import type { MovingTree } from "../clips/moving-tree";
import { fbxNodes, isBinaryFbx } from "../fbx-nodes";
import { ModelError, type NamedFile } from "../named-file";
import { checkBinaryFbx } from "./check-fbx";
import { type BuiltScene, parsed, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

const LETTER_X = 120;
const CONVERT = "Open it in Blender or Autodesk's free FBX Converter, and save it as FBX 2013 or later, or as glTF.";

/** Errors (ModelError): older than FBX 7; broken; a motion without a mesh. */
export function readFbx(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const bytes = checkedCopy(name, file);
  hideCurves(bytes);
  const { tree, metres } = treeOf(name, bytes);
  tree.traverse((object) => void (object.name = nameOf(object)));
  return readScene(source, tree, metres);
}

/** Its takes and what they move. Errors (ModelError): older than FBX 7; broken. */
export function readFbxClips(name: string, file: NamedFile): MovingTree {
  const { tree, metres } = treeOf(name, checkedCopy(name, file));
  return { tree, metres, clips: tree.animations, nameOf };
}

/** As the file has it: the loader takes dots out of names. */
const nameOf = ({ name, userData }: Object3D): string => (typeof userData.originalName === "string" ? userData.originalName : name);

function checkedCopy(name: string, { bytes }: NamedFile): Uint8Array<ArrayBuffer> {
  const copy = bytes.slice();
  const version = isBinaryFbx(bytes) ? checkBinaryFbx(name, copy) : textVersion(name, bytes);
  if (version >= (isBinaryFbx(bytes) ? 6400 : 7000)) return copy;
  throw new ModelError(`${name} is an FBX of version ${(version / 1000).toFixed(1)}, which is too old to be read. ${CONVERT}`);
}

function treeOf(name: string, bytes: Uint8Array<ArrayBuffer>): { tree: Group; metres: number } {
  const tree = parsed(name, "FBX", () => inSurroundings(name, () => new FBXLoader().parse(bytes.buffer, "")));
  // A file's unit is so many centimetres.
  const centimetres: unknown = tree.userData.unitScaleFactor;
  return { tree, metres: 0.01 * (typeof centimetres === "number" && centimetres > 0 ? centimetres : 1) };
}

/**
 * Renames curves of motion, so that the loader passes them over: they take it the most time, and one that it cannot read would take
 * the model with it.
 */
function hideCurves(bytes: Uint8Array): void {
  const curve = "AnimationCurve";
  for (const at of fbxNodes(bytes, curve)) bytes[at + curve.length - 1] = LETTER_X;
}

function textVersion(name: string, bytes: Uint8Array): number {
  const version = /FBXVersion:\s*(\d+)/.exec(new TextDecoder("latin1").decode(bytes.subarray(0, 65536)))?.[1];
  if (version === undefined) throw new ModelError(`${name} holds no FBX scene. ${CONVERT}`);
  return Number(version);
}
