// FBX 7.0 and later, text and binary, by three's FBXLoader.

import { FBXLoader } from "three/examples/jsm/loaders/FBXLoader.js";

import { starts } from "../format";
import { ModelError } from "../named-file";
import { checkBinaryFbx } from "./check-fbx";
import { type BuiltScene, parsed, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

const [COLON, LETTER_X] = [58, 120];
const CONVERT = "Open it in Blender or Autodesk's free FBX Converter, and save it as FBX 2013 or later, or as glTF.";

/** Errors (ModelError): older than FBX 7; broken; a motion without a mesh. */
export function readFbx(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const { bytes } = file;
  const copy = bytes.slice();
  const version = isBinary(bytes) ? checkBinaryFbx(name, copy) : textVersion(name, bytes);
  hideCurves(copy);
  if (version < (isBinary(bytes) ? 6400 : 7000)) {
    throw new ModelError(`${name} is an FBX of version ${(version / 1000).toFixed(1)}, which is too old to be read. ${CONVERT}`);
  }
  const tree = parsed(name, "FBX", () => inSurroundings(name, () => new FBXLoader().parse(copy.buffer, "")));
  // A file's unit is so many centimetres.
  const centimetres: unknown = tree.userData.unitScaleFactor;
  return readScene(source, tree, 0.01 * (typeof centimetres === "number" && centimetres > 0 ? centimetres : 1));
}

/**
 * Renames curves of motion, so that the loader passes them over: they take it the most time, and one that it cannot read would take
 * the model with it.
 */
function hideCurves(bytes: Uint8Array): void {
  const curve = new TextEncoder().encode("AnimationCurve");
  for (let at = bytes.indexOf(curve[0]); at >= 0; at = bytes.indexOf(curve[0], at + 1)) {
    const after = bytes[at + curve.length];
    const named = isBinary(bytes) ? bytes[at - 1] === curve.length : after === COLON;
    if (named && starts(bytes, at, ...curve)) bytes[at + curve.length - 1] = LETTER_X;
  }
}

function isBinary(bytes: Uint8Array): boolean {
  return new TextDecoder("latin1").decode(bytes.subarray(0, 20)) === "Kaydara FBX Binary  ";
}

function textVersion(name: string, bytes: Uint8Array): number {
  const version = /FBXVersion:\s*(\d+)/.exec(new TextDecoder("latin1").decode(bytes.subarray(0, 65536)))?.[1];
  if (version === undefined) throw new ModelError(`${name} holds no FBX scene. ${CONVERT}`);
  return Number(version);
}
