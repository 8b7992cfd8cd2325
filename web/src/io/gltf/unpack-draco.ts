// Primitives packed by Draco become plain ones.

import type { Gltf } from "../../gltf/document";
import { broken } from "./check";

export async function unpackDraco(name: string, { json }: { json: Gltf; buffers: Uint8Array[] }): Promise<void> {
  throw broken(name, String(json.asset));
}
