// Builds one skin, or one set of morph targets, off the page's thread.

import { buildMorphs, buildSkin } from "./build-skin";
import { type BuiltMorphs, type BuiltSkin, EngineError, type EngineErrorCode, type MorphsInput, type SkinInput } from "./types";

export type SkinTask = { input: SkinInput | MorphsInput; wasm: ArrayBuffer };
export type SkinAnswer = { done: number } | { built: BuiltSkin | BuiltMorphs } | { code: EngineErrorCode; message: string };

interface WorkerScope {
  onmessage: ((event: MessageEvent<SkinTask>) => void) | null;
  postMessage(message: SkinAnswer): void;
}

const scope = globalThis as unknown as WorkerScope;

scope.onmessage = ({ data: { input, wasm } }) => {
  try {
    const steps = "joints" in input ? buildSkin(input, wasm) : buildMorphs(input, wasm);
    let step = steps.next();
    for (; !step.done; step = steps.next()) scope.postMessage({ done: step.value });
    scope.postMessage({ built: step.value });
  } catch (error) {
    const { code, message } = error instanceof EngineError ? error : { code: "engine_lost" as const, message: String(error) };
    scope.postMessage({ code, message });
  }
};
