// FBX 7.0 and later, text and binary, by three's FBXLoader.

import { FBXLoader } from "three/examples/jsm/loaders/FBXLoader.js";

import { ModelError } from "../named-file";
import { checkBinaryFbx } from "./check-fbx";
import { type BuiltScene, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

const CONVERT = "Open it in Blender or Autodesk's free FBX Converter, and save it as FBX 2013 or later, or as glTF.";

/** Errors (ModelError): older than FBX 7; broken; a motion without a mesh. */
export function readFbx(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const { bytes } = file;
  const version = isBinary(bytes) ? checkBinaryFbx(name, bytes) : textVersion(name, bytes);
  if (version < (isBinary(bytes) ? 6400 : 7000)) {
    throw new ModelError(`${name} is an FBX of version ${(version / 1000).toFixed(1)}, which is too old to be read. ${CONVERT}`);
  }
  const buffer = bytes.slice().buffer;
  const tree = inSurroundings(name, () => new FBXLoader().parse(buffer, ""));
  // A file's unit is so many centimetres.
  const centimetres: unknown = tree.userData.unitScaleFactor;
  return readScene(source, tree, 0.01 * (typeof centimetres === "number" && centimetres > 0 ? centimetres : 1));
}

function isBinary(bytes: Uint8Array): boolean {
  return new TextDecoder("latin1").decode(bytes.subarray(0, 20)) === "Kaydara FBX Binary  ";
}

function textVersion(name: string, bytes: Uint8Array): number {
  const version = /FBXVersion:\s*(\d+)/.exec(new TextDecoder("latin1").decode(bytes.subarray(0, 65536)))?.[1];
  if (version === undefined) throw new ModelError(`${name} holds no FBX scene. ${CONVERT}`);
  return Number(version);
}
