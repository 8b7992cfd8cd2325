// Builds one skin off the page's thread.

import { buildSkin } from "./build-skin";
import { type BuiltSkin, EngineError, type EngineErrorCode, type SkinInput } from "./types";

export type SkinAnswer = { done: number } | { skin: BuiltSkin } | { code: EngineErrorCode; message: string };

interface WorkerScope {
  onmessage: ((event: MessageEvent<{ input: SkinInput; wasm: ArrayBuffer }>) => void) | null;
  postMessage(message: SkinAnswer): void;
}

const scope = globalThis as unknown as WorkerScope;

scope.onmessage = ({ data: { input, wasm } }) => {
  try {
    const steps = buildSkin(input, wasm);
    let step = steps.next();
    for (; !step.done; step = steps.next()) scope.postMessage({ done: step.value });
    scope.postMessage({ skin: step.value });
  } catch (error) {
    const { code, message } = error instanceof EngineError ? error : { code: "engine_lost" as const, message: String(error) };
    scope.postMessage({ code, message });
  }
};
