import type { SkinAnswer } from "./skin-worker";
import { type BuildMorphs, type BuildSkin, type CallOptions, EngineError, type MorphsInput, type SkinInput } from "./types";

/** buildSkin in a worker of its own, which ends at once on abort. */
export const buildSkinInWorker: BuildSkin = (...task) => buildInWorker(...task);
/** As that one. */
export const buildMorphsInWorker: BuildMorphs = (...task) => buildInWorker(...task);

/** What is built is what is asked for. */
async function buildInWorker<T>(input: SkinInput | MorphsInput, { signal, onProgress }: CallOptions = {}): Promise<T> {
  const response = await fetch(new URL("./skin.wasm", import.meta.url), signal ? { signal } : {});
  if (!response.ok) throw new EngineError("engine_lost", `What builds skins could not be loaded: it answered ${response.status}.`);
  const wasm = await response.arrayBuffer();
  signal?.throwIfAborted();
  const worker = new Worker(new URL("./skin-worker.ts", import.meta.url), { type: "module", name: "skin" });
  let abort = (): void => {};
  try {
    return await new Promise<T>((resolve, reject) => {
      abort = () => reject(signal?.reason);
      signal?.addEventListener("abort", abort);
      const lost = (): void =>
        reject(new EngineError("engine_lost", "What builds skins stopped. The dance may be too large for this browser."));
      worker.onerror = lost;
      worker.onmessageerror = lost;
      worker.onmessage = ({ data }: MessageEvent<SkinAnswer>) => {
        if ("done" in data) onProgress?.(data.done);
        else if ("built" in data) resolve(data.built as T);
        else reject(new EngineError(data.code, data.message));
      };
      worker.postMessage({ input, wasm }, [wasm]);
    });
  } finally {
    signal?.removeEventListener("abort", abort);
    worker.terminate();
  }
}
