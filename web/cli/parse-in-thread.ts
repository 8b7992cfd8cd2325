import { Worker } from "node:worker_threads";

import type { FoundClip } from "../src/io/clips/found-clip";
import type { Model } from "../src/io/model";
import { baseName, ModelError, type NamedFile } from "../src/io/named-file";
import type { ParseAnswer, ParseRequest } from "../src/io/parse-worker";

export interface ThreadOptions {
  readonly signal: AbortSignal;
  readonly onProgress: (done: number) => void;
}

/** readModel in a thread of its own. Errors: ModelError as readModel; on abort the signal's reason, and the thread ends at once. */
export async function readModelInThread(files: readonly NamedFile[], options: ThreadOptions): Promise<Model> {
  const answer = await parse({ wanted: "model", files }, options);
  if ("model" in answer) return answer.model;
  throw lost(files);
}

/** readClips likewise. */
export async function readClipsInThread(files: readonly NamedFile[], options: ThreadOptions): Promise<FoundClip[]> {
  const answer = await parse({ wanted: "clips", files }, options);
  if ("clips" in answer) return answer.clips;
  throw lost(files);
}

async function parse(request: ParseRequest, { signal, onProgress }: ThreadOptions): Promise<ParseAnswer> {
  signal.throwIfAborted();
  const { files } = request;
  const thread = new Worker(new URL("./parse-thread.js", import.meta.url));
  let abort = (): void => {};
  try {
    return await new Promise<ParseAnswer>((resolve, reject) => {
      abort = () => reject(signal.reason as Error);
      signal.addEventListener("abort", abort);
      thread.on("message", (answer: ParseAnswer) => {
        if ("done" in answer) onProgress(answer.done);
        else if ("message" in answer) reject(new ModelError(answer.message));
        else resolve(answer);
      });
      thread.on("error", (error) => reject(lost(files, error)));
      thread.on("exit", () => reject(lost(files)));
      thread.postMessage(request);
    });
  } finally {
    signal.removeEventListener("abort", abort);
    await thread.terminate();
  }
}

function lost(files: readonly NamedFile[], error?: Error): ModelError {
  const name = baseName(files[0]?.name ?? "The file");
  return new ModelError(`${name} could not be read: its reader stopped. It may be too large for this machine.`, { cause: error });
}
