// USDZ, and the USD files that stand in one, by three's USDLoader.

import { USDLoader } from "three/examples/jsm/loaders/USDLoader.js";

import { starts } from "../format";
import { ModelError } from "../named-file";
import { checkedArchive } from "./archive";
import { withCheckedUsd } from "./check-usd";
import { type BuiltScene, parsed, readScene, type SceneSource } from "./read-scene";
import { inSurroundings } from "./surroundings";

/** Errors (ModelError): a broken archive; no USD in it; broken; no mesh. */
export function readUsd(source: SceneSource): BuiltScene {
  const { name, file } = source;
  if (starts(file.bytes, 0, 0x50, 0x4b) && !checkedArchive(file).some((path) => /\.usd[acz]?$/i.test(path))) {
    throw new ModelError(`${name} holds no USD scene.`);
  }
  const tree = parsed(name, "USD", () =>
    inSurroundings(name, () => withCheckedUsd(name, () => new USDLoader().parse(file.bytes.slice().buffer, ""))),
  );
  // The loader has turned and scaled it.
  return readScene(source, tree, 1);
}
