// Reads one model off the page's thread.

import type { Model } from "./model";
import type { NamedFile } from "./named-file";
import { readModel } from "./read-model";

/** What comes back: the model, or the message of a ModelError. */
export type ParseAnswer = { model: Model } | { message: string };

interface WorkerScope {
  onmessage: ((event: MessageEvent<readonly NamedFile[]>) => void) | null;
  postMessage(message: ParseAnswer, transfer: Transferable[]): void;
}

const scope = globalThis as unknown as WorkerScope;

scope.onmessage = ({ data }) => {
  readModel(data).then(
    (model) => scope.postMessage({ model }, buffersOf(model)),
    (error: unknown) => scope.postMessage({ message: error instanceof Error ? error.message : String(error) }, []),
  );
};

function buffersOf({ positions, faces, drawn, document }: Model): Transferable[] {
  const { normals, index, toVertex } = drawn;
  const vertices = drawn.instances.flatMap((instance) => instance.vertices ?? []);
  const pictures = document.images.flatMap((picture) => picture?.bytes ?? []);
  const arrays = [positions, faces, drawn.positions, normals, index, toVertex, ...vertices, ...document.buffers, ...pictures];
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}
