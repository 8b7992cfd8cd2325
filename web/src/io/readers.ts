// The reader of each format of models, loaded with its first file. The page itself never loads this table: a worker reads for it.

import type { Picture } from "../gltf/document";
import type { ModelId } from "./formats";
import type { Built } from "./gltf/build";
import type { Part } from "./model";
import type { NamedFile } from "./named-file";

/** What the reader of a model is given. */
export interface ModelSource {
  /** Without folders. */
  readonly name: string;
  readonly file: NamedFile;
  /** All files, the model's own among them. */
  readonly files: readonly NamedFile[];
  /** What was worked around, in plain words: the reader adds to it. */
  readonly notes: string[];
  /** 0..1 of the reading, now and then. */
  readonly onProgress: (done: number) => void;
}

export interface Surface {
  readonly parts: Part[];
  readonly texture: Picture | null;
}

type Reader = (source: ModelSource) => Promise<Built | Surface>;

const gltf: Reader = async ({ name, file, files, notes }) => (await import("./read-gltf")).readGltf(name, file, files, notes);

export const READERS: Readonly<Record<ModelId, Reader>> = {
  obj: async ({ name, file, files, notes, onProgress }) => (await import("./read-obj")).readObj(name, file, files, notes, onProgress),
  off: async ({ name, file, notes, onProgress }) => (await import("./read-off")).readOff(name, file, notes, onProgress),
  ply: async ({ name, file, files, notes, onProgress }) => (await import("./read-ply")).readPly(name, file, files, notes, onProgress),
  stl: async ({ name, file, onProgress }) => (await import("./read-stl")).readStl(name, file, onProgress),
  gltf,
  glb: gltf,
  fbx: async (source) => (await import("./three-scene/read-fbx")).readFbx(source),
  dae: async (source) => (await import("./three-scene/read-dae")).readDae(source),
  "3mf": async (source) => (await import("./three-scene/read-3mf")).read3mf(source),
  usd: async (source) => (await import("./three-scene/read-usd")).readUsd(source),
};
