// 3MF by three's loader.

import { Group } from "three";
import { ThreeMFLoader } from "three/examples/jsm/loaders/3MFLoader.js";

import { ModelError } from "../named-file";
import { checkedArchive } from "./archive";
import { ThreeMfParts } from "./prepare-3mf";
import { type BuiltScene, parsed, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

const METRES: Readonly<Record<string, number>> = { micron: 1e-6, millimeter: 1e-3, centimeter: 1e-2, inch: 0.0254, foot: 0.3048, meter: 1 };

/** Errors (ModelError): a broken archive; no model in it; parts that hold themselves. */
export function read3mf(source: SceneSource): BuiltScene {
  const { name, file } = source;
  const paths = checkedArchive(file);
  if (!paths.some((path) => /^3D\/[^/]*\.model$/.test(path))) throw new ModelError(`${name} holds no 3D model.`);
  const parts = new ThreeMfParts(name, paths);
  const tree = parsed(name, "3MF", () =>
    inSurroundings(
      name,
      () => new ThreeMFLoader().parse(file.bytes.slice().buffer),
      (document) => parts.prepare(document),
    ),
  );
  // What is printed stands on XY; the loader leaves that to its caller.
  const upright = new Group();
  upright.rotation.set(-Math.PI / 2, 0, 0);
  upright.add(tree);
  return readScene(source, upright, METRES[parts.unit] ?? 1e-3);
}
