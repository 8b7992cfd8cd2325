import { readFile } from "node:fs/promises";
import { buildSkin } from "./build-skin";
import type { BuildSkin } from "./types";

/** buildSkin in this thread; between two steps others get their turn. */
export const buildSkinInNode: BuildSkin = async (input, { signal, onProgress } = {}) => {
  const steps = buildSkin(input, new Uint8Array(await readFile(new URL("./skin.wasm", import.meta.url))).buffer);
  for (;;) {
    signal?.throwIfAborted();
    const step = steps.next();
    if (step.done) return step.value;
    onProgress?.(step.value);
    await new Promise<void>((resolve) => setImmediate(resolve));
  }
};
