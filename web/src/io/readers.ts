// The reader of each format of models, loaded with its first file. The page itself never loads this table: a worker reads for it.

import type { GltfDocument } from "../gltf/document";
import type { NamedJoint } from "../sync/named-body";
import type { ModelId } from "./formats";
import type { Built } from "./gltf/build";
import { withJoints } from "./gltf/joints";
import type { NamedFile } from "./named-file";
import { presentable } from "./take-picture";

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

type Reader = (source: ModelSource) => Promise<GltfDocument>;

const gltf: Reader = async ({ name, file, files, notes }) => {
  const document = await (await import("./gltf/read")).readDocument(name, file, files, notes);
  const named = document.images.map((picture, i) => ({ name: document.json.images?.[i].name ?? `Picture ${i + 1}`, picture }));
  return { ...document, images: (await presentable(named, notes)).map(({ picture }) => picture) };
};

/** A reader that finds parts. */
const parts =
  (read: (source: ModelSource) => Promise<Built & { readonly joints?: readonly NamedJoint[] }>): Reader =>
  async (source) => {
    const built = await read(source);
    const { buildDocument } = await import("./gltf/build");
    const pictures = await presentable(built.pictures ?? [], source.notes);
    return withJoints(buildDocument(source.name, { ...built, pictures }), built.joints ?? []);
  };

export const READERS: Readonly<Record<ModelId, Reader>> = {
  obj: parts(async ({ name, file, files, notes, onProgress }) =>
    (await import("./read-obj")).readObj(name, file, files, notes, onProgress),
  ),
  off: parts(async ({ name, file, notes, onProgress }) => (await import("./read-off")).readOff(name, file, notes, onProgress)),
  ply: parts(async ({ name, file, files, notes, onProgress }) =>
    (await import("./read-ply")).readPly(name, file, files, notes, onProgress),
  ),
  stl: parts(async ({ name, file, onProgress }) => (await import("./read-stl")).readStl(name, file, onProgress)),
  gltf,
  glb: gltf,
  fbx: parts(async (source) => (await import("./three-scene/read-fbx")).readFbx(source)),
  dae: parts(async (source) => (await import("./three-scene/read-dae")).readDae(source)),
  "3mf": parts(async (source) => (await import("./three-scene/read-3mf")).read3mf(source)),
  usd: parts(async (source) => (await import("./three-scene/read-usd")).readUsd(source)),
};
