// Reads one model, or the clips of one file, off the page's thread.

import type { FoundClip } from "./clips/found-clip";
import type { Model } from "./model";
import type { NamedFile } from "./named-file";
import { readModel } from "./read-model";

export interface ParseRequest {
  readonly wanted: "model" | "clips";
  readonly files: readonly NamedFile[];
}

/** What comes back: how far it is, 0..1, and in the end what was wanted, or the message of a ModelError. */
export type ParseAnswer = { done: number } | { model: Model } | { clips: FoundClip[] } | { message: string };

interface WorkerScope {
  onmessage: ((event: MessageEvent<ParseRequest>) => void) | null;
  postMessage(message: ParseAnswer, transfer: Transferable[]): void;
}

const scope = globalThis as unknown as WorkerScope;

scope.onmessage = ({ data: { wanted, files } }) => {
  const onProgress = (done: number): void => scope.postMessage({ done }, []);
  const reading = wanted === "model" ? model(files, onProgress) : clips(files, onProgress);
  reading.catch((error: unknown) => scope.postMessage({ message: error instanceof Error ? error.message : String(error) }, []));
};

async function model(files: readonly NamedFile[], onProgress: (done: number) => void): Promise<void> {
  const read = await readModel(files, { onProgress });
  scope.postMessage({ model: read }, buffersOf(read));
}

async function clips(files: readonly NamedFile[], onProgress: (done: number) => void): Promise<void> {
  const { readClips } = await import("./clips/read-clips");
  scope.postMessage({ clips: await readClips(files, { onProgress }) }, []);
}

function buffersOf({ positions, faces, drawn, document }: Model): Transferable[] {
  const { normals, index, toVertex } = drawn;
  const vertices = drawn.instances.flatMap((instance) => instance.vertices ?? []);
  const pictures = document.images.flatMap((picture) => picture?.bytes ?? []);
  const arrays = [positions, faces, drawn.positions, normals, index, toVertex, ...vertices, ...document.buffers, ...pictures];
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}
