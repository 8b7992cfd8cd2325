// COLLADA by three's ColladaLoader.

import { TextureLoader } from "three";
import { ColladaLoader } from "three/examples/jsm/loaders/ColladaLoader.js";
import { TGALoader } from "three/examples/jsm/loaders/TGALoader.js";

import { decodeText, ModelError } from "../named-file";
import { checkInstances } from "./check-instances";
import { type BuiltScene, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";
import type { XmlDocument } from "./xml";

/** Errors (ModelError): no XML; no COLLADA; broken; no mesh. */
export function readDae(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const text = decodeText(file.bytes);
  if (text === null) throw new ModelError(`${name} is not text, so it is no DAE model.`);
  const scene = inSurroundings(
    name,
    () => withTgaNames(() => new ColladaLoader().parse(text.replace(/^\uFEFF/, ""), "")?.scene),
    (document) => checkCollada(name, document),
  );
  if (!scene) throw new ModelError(`${name} holds no COLLADA scene.`);
  return readScene(source, scene, 1);
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

function checkCollada(name: string, document: XmlDocument): void {
  if (document.documentElement.nodeName !== "COLLADA") throw new ModelError(`${name} holds no COLLADA scene.`);
  // Nodes may hold each other by name.
  const nodes = document.getElementsByTagName("node").flatMap((node) => {
    const id = node.getAttribute("id");
    const inside = node.getElementsByTagName("instance_node").map((instance) => (instance.getAttribute("url") ?? "").slice(1));
    return id && inside.length > 0 ? [[id, inside] as const] : [];
  });
  checkInstances(name, new Map(nodes));
  for (const counts of document.getElementsByTagName("vcount")) {
    const indices = counts.parentElement?.getElementsByTagName("p")[0]?.textContent ?? "";
    let corners = 0;
    for (const word of counts.textContent.split(/\s+/)) corners += Number(word) > 0 ? Number(word) : 0;
    // A corner takes a digit and a blank at least.
    if (2 * corners > indices.length + 1)
      throw new ModelError(`${name} promises ${corners.toLocaleString("en-US")} corners that it does not hold.`);
  }
}
