// COLLADA by three's ColladaLoader.

import { TextureLoader } from "three";
import { ColladaLoader } from "three/examples/jsm/loaders/ColladaLoader.js";
import { TGALoader } from "three/examples/jsm/loaders/TGALoader.js";

import { decodeText, ModelError } from "../named-file";
import { prepareCollada } from "./prepare-dae";
import { type BuiltScene, parsed, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

/** Errors (ModelError): no XML; no COLLADA; broken; no mesh. */
export function readDae(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const text = decodeText(file.bytes);
  if (text === null) throw new ModelError(`${name} is not text, so it is no DAE model.`);
  const scene = parsed(name, "DAE", () =>
    inSurroundings(
      name,
      () => withTgaNames(() => new ColladaLoader().parse(withPoints(text), "")?.scene),
      (document) => prepareCollada(name, document),
    ),
  );
  if (!scene) throw new ModelError(`${name} holds no COLLADA scene.`);
  return readScene(source, scene, 1);
}

/** Without a byte-order mark; numbers that some writers leave to their country's comma have points. */
function withPoints(text: string): string {
  const plain = text.replace(/^\uFEFF/, "");
  return /<unit\b[^>]*\bmeter="\d+,\d/.test(plain.slice(0, 8192)) ? plain.replace(/(\d),(?=\d)/g, "$1.") : plain;
}

/** The loader would fetch TGA pictures by itself; as other pictures they are found beside the file. */
function withTgaNames<T>(parse: () => T): T {
  const { load } = TGALoader.prototype;
  TGALoader.prototype.load = function (this: TGALoader, address: string) {
    return new TextureLoader(this.manager).load(address);
  } as unknown as typeof load;
  try {
    return parse();
  } finally {
    TGALoader.prototype.load = load;
  }
}
