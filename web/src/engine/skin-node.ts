import { readFile } from "node:fs/promises";
import { buildMorphs, buildSkin } from "./build-skin";
import type { BuildMorphs, BuildSkin, CallOptions } from "./types";

/** buildSkin in this thread; between two steps others get their turn. */
export const buildSkinInNode: BuildSkin = async (input, options) => inTurns(buildSkin(input, await moduleBytes()), options);
/** As that one. */
export const buildMorphsInNode: BuildMorphs = async (input, options) => inTurns(buildMorphs(input, await moduleBytes()), options);

async function moduleBytes(): Promise<ArrayBuffer> {
  return new Uint8Array(await readFile(new URL("./skin.wasm", import.meta.url))).buffer;
}

async function inTurns<T>(steps: Generator<number, T>, { signal, onProgress }: CallOptions = {}): Promise<T> {
  for (;;) {
    signal?.throwIfAborted();
    const step = steps.next();
    if (step.done) return step.value;
    onProgress?.(step.value);
    await new Promise<void>((resolve) => setImmediate(resolve));
  }
}
