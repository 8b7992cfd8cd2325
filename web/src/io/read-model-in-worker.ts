import { baseName, ModelError, type NamedFile } from "./named-file";
import type { ParseAnswer } from "./parse-worker";
import type { Model } from "./model";
import type { ReadingOptions } from "./read-model";

/**
 * readModel in a worker of its own, so that the page never freezes. The files stay the caller's.
 * Errors: ModelError as readModel; on abort the signal's reason, and the worker ends at once.
 */
export function readModelInWorker(
  files: readonly NamedFile[],
  { signal, onProgress }: { signal?: AbortSignal } & ReadingOptions = {},
): Promise<Model> {
  return new Promise((resolve, reject) => {
    if (signal?.aborted) {
      reject(signal.reason);
      return;
    }
    const worker = new Worker(new URL("./parse-worker.ts", import.meta.url), { type: "module", name: "parse" });
    const end = (): void => {
      worker.terminate();
      signal?.removeEventListener("abort", abort);
    };
    const abort = (): void => {
      end();
      reject(signal?.reason);
    };
    const lost = (): void => {
      end();
      reject(
        new ModelError(
          `${baseName(files[0]?.name ?? "The model")} could not be read: its reader stopped. It may be too large for this browser.`,
        ),
      );
    };
    signal?.addEventListener("abort", abort);
    worker.onerror = lost;
    worker.onmessageerror = lost;
    worker.onmessage = ({ data }: MessageEvent<ParseAnswer>) => {
      if ("done" in data) {
        onProgress?.(data.done);
        return;
      }
      end();
      if ("model" in data) resolve(data.model);
      else reject(new ModelError(data.message));
    };
    worker.postMessage(files);
  });
}
