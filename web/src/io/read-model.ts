// One way in for every model format; runs in the page's worker and in Node alike.

import { buildModel, type Model, type Part, type Picture } from "./model";
import { modelFormat } from "./model-format";
import { baseName, decodeText, ModelError, type NamedFile } from "./named-file";
import { readOff } from "./read-off";

export type { Model } from "./model";

/**
 * Reads the first of `files` that is a model; the others may be its material, picture and .bin files.
 * Errors (ModelError): no model among them, an empty file, and whatever the format's reader finds wrong; the message names the file.
 */
export async function readModel(files: readonly NamedFile[]): Promise<Model> {
  const file = files.find((candidate) => modelFormat(candidate) !== null);
  if (!file) {
    const names = files.map((other) => baseName(other.name)).join(", ");
    throw new ModelError(`${names || "Nothing"} is not a model that we read (OBJ, PLY, STL, GLB, glTF, OFF).`);
  }
  const name = baseName(file.name);
  if (file.bytes.length === 0) throw new ModelError(`${name} is empty.`);
  try {
    const notes: string[] = [];
    const { parts, texture } = await readParts(name, file, files, notes);
    return buildModel(name, parts, texture, notes);
  } catch (error) {
    if (error instanceof ModelError) throw error;
    const why = error instanceof Error ? error.message : String(error);
    throw new ModelError(`${name} could not be read: ${why.replace(/\.$/, "")}.`);
  }
}

/** Loads the readers one by one as they are needed, so that the page's first load carries only the one of its own model. */
async function readParts(
  name: string,
  file: NamedFile,
  files: readonly NamedFile[],
  notes: string[],
): Promise<{ parts: Part[]; texture: Picture | null }> {
  const format = modelFormat(file);
  switch (format) {
    case "glb":
    case "gltf":
      return (await import("./read-gltf")).readGltf(name, file, files, notes);
    case "ply":
      return { parts: (await import("./read-ply")).readPly(name, file.bytes, notes), texture: null };
    case "stl":
      return { parts: (await import("./read-stl")).readStl(name, file.bytes), texture: null };
    case "obj":
      return (await import("./read-obj")).readObj(name, file.name, textOf(name, file.bytes, "OBJ"), files, notes);
    case "off":
      return { parts: readOff(name, textOf(name, file.bytes, "OFF"), notes), texture: null };
    case null:
      throw new ModelError(`${name} is not a model that we read.`);
  }
}

function textOf(name: string, bytes: Uint8Array, kind: string): string {
  const text = decodeText(bytes);
  if (text === null) throw new ModelError(`${name} is not text, so it is no ${kind} model.`);
  return text;
}
