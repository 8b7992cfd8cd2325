// One way in for every model format; runs in the page's worker and in Node alike.

import { listed, type ModelFormat, modelFormat } from "./formats";
import { type Model, modelOf } from "./model";
import { baseName, decodeText, ModelError, type NamedFile } from "./named-file";

export type { Model } from "./model";

/**
 * Reads the first of `files` that is a model; the others may be its material, picture and .bin files.
 * Errors (ModelError): no model among them, an empty file, and whatever the format's reader finds wrong; the message names the file.
 */
export async function readModel(files: readonly NamedFile[]): Promise<Model> {
  const [file, format] = firstModel(files);
  if (!file || !format) {
    const names = files.map((other) => baseName(other.name)).join(", ");
    throw new ModelError(`${names || "Nothing"} is not a model that we read (${listed("model")}).`);
  }
  const name = baseName(file.name);
  if (file.bytes.length === 0) throw new ModelError(`${name} is empty.`);
  try {
    const notes: string[] = [];
    const text = (): string => textOf(name, file.bytes, format.words);
    return modelOf(name, await format.read({ name, file, text, files, notes }), notes);
  } catch (error) {
    if (error instanceof ModelError) throw error;
    const why = error instanceof Error ? error.message : String(error);
    throw new ModelError(`${name} could not be read: ${why.replace(/\.$/, "")}.`);
  }
}

function firstModel(files: readonly NamedFile[]): [NamedFile, ModelFormat] | [] {
  for (const file of files) {
    const format = modelFormat(file);
    if (format) return [file, format];
  }
  return [];
}

function textOf(name: string, bytes: Uint8Array, kind: string): string {
  const text = decodeText(bytes);
  if (text === null) throw new ModelError(`${name} is not text, so it is no ${kind} model.`);
  return text;
}
