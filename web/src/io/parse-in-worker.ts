import type { FoundClip } from "./clips/found-clip";
import type { Model } from "./model";
import { baseName, ModelError, type NamedFile } from "./named-file";
import type { ParseAnswer, ParseRequest } from "./parse-worker";
import type { ReadingOptions } from "./read-model";

type Options = { signal?: AbortSignal } & ReadingOptions;

/**
 * readModel in a worker of its own, so that the page never freezes. The files stay the caller's.
 * Errors: ModelError as readModel; on abort the signal's reason, and the worker ends at once.
 */
export async function readModelInWorker(files: readonly NamedFile[], options: Options = {}): Promise<Model> {
  const answer = await parse({ wanted: "model", files }, options);
  if ("model" in answer) return answer.model;
  throw lost(files);
}

/** readClips likewise. */
export async function readClipsInWorker(files: readonly NamedFile[], options: Options = {}): Promise<FoundClip[]> {
  const answer = await parse({ wanted: "clips", files }, options);
  if ("clips" in answer) return answer.clips;
  throw lost(files);
}

function lost(files: readonly NamedFile[]): ModelError {
  const name = baseName(files[0]?.name ?? "The file");
  return new ModelError(`${name} could not be read: its reader stopped. It may be too large for this browser.`);
}

function parse(request: ParseRequest, { signal, onProgress }: Options): Promise<ParseAnswer> {
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
    const stopped = (): void => {
      end();
      reject(lost(request.files));
    };
    signal?.addEventListener("abort", abort);
    worker.onerror = stopped;
    worker.onmessageerror = stopped;
    worker.onmessage = ({ data }: MessageEvent<ParseAnswer>) => {
      if ("done" in data) {
        onProgress?.(data.done);
        return;
      }
      end();
      if ("message" in data) reject(new ModelError(data.message));
      else resolve(data);
    };
    worker.postMessage(request);
  });
}
