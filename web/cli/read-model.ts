import { Worker } from "node:worker_threads";

import type { Model } from "../src/io/model";
import { baseName, ModelError, type NamedFile } from "../src/io/named-file";
import type { ParseAnswer } from "../src/io/parse-worker";

/** readModel in a thread of its own. Errors: ModelError as readModel; on abort the signal's reason, and the thread ends at once. */
export async function readModelInThread(
  files: readonly NamedFile[],
  { signal, onProgress }: { signal: AbortSignal; onProgress: (done: number) => void },
): Promise<Model> {
  signal.throwIfAborted();
  const thread = new Worker(new URL("./parse-thread.js", import.meta.url));
  let abort = (): void => {};
  try {
    return await new Promise<Model>((resolve, reject) => {
      abort = () => reject(signal.reason as Error);
      signal.addEventListener("abort", abort);
      thread.on("message", (answer: ParseAnswer) => {
        if ("done" in answer) onProgress(answer.done);
        else if ("model" in answer) resolve(answer.model);
        else reject(new ModelError(answer.message));
      });
      thread.on("error", (error) => reject(lost(files, error)));
      thread.on("exit", () => reject(lost(files)));
      thread.postMessage(files);
    });
  } finally {
    signal.removeEventListener("abort", abort);
    await thread.terminate();
  }
}

function lost(files: readonly NamedFile[], error?: Error): ModelError {
  const name = baseName(files[0]?.name ?? "The model");
  return new ModelError(`${name} could not be read: its reader stopped. It may be too large for this machine.`, { cause: error });
}
