// 3MF by three's loader.

import { Group } from "three";
import { ThreeMFLoader } from "three/examples/jsm/loaders/3MFLoader.js";

import { ModelError } from "../named-file";
import { checkedArchive } from "./archive";
import { checkInstances } from "./check-instances";
import { type BuiltScene, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";
import type { XmlDocument } from "./xml";

const METRES: Readonly<Record<string, number>> = { micron: 1e-6, millimeter: 1e-3, centimeter: 1e-2, inch: 0.0254, foot: 0.3048, meter: 1 };

/** Errors (ModelError): a broken archive; no model in it; parts that hold themselves. */
export function read3mf(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const paths = checkedArchive(file);
  if (!paths.some((path) => /^3D\/[^/]*\.model$/.test(path))) throw new ModelError(`${name} holds no 3D model.`);
  let unit = "millimeter";
  const holds = new Map<string, readonly string[]>();
  const look = (document: XmlDocument): void => {
    const model = document.documentElement;
    if (model.nodeName !== "model") return;
    unit = model.getAttribute("unit") ?? unit; // the root model comes last
    for (const object of model.getElementsByTagName("object")) {
      const inside = object.getElementsByTagName("component").map((component) => component.getAttribute("objectid") ?? "");
      if (inside.length > 0) holds.set(object.getAttribute("id") ?? "", inside);
    }
    holds.set(
      "the build",
      model.getElementsByTagName("item").map((item) => item.getAttribute("objectid") ?? ""),
    );
    checkInstances(name, holds);
  };
  const tree = inSurroundings(name, () => new ThreeMFLoader().parse(file.bytes.slice().buffer), look);
  // What is printed stands on XY; the loader leaves that to its caller.
  const upright = new Group();
  upright.rotation.set(-Math.PI / 2, 0, 0);
  upright.add(tree);
  return readScene(source, upright, METRES[unit] ?? 1e-3);
}
