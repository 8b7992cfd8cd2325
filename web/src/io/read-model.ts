// One way in for every model format; runs in the page's worker and in Node alike.

import { modelFormat } from "./formats";
import { type Model, modelOf } from "./model";
import { baseName, ModelError, type NamedFile } from "./named-file";
import { READERS } from "./readers";

export type { Model } from "./model";

export interface ReadingOptions {
  /** 0..1, now and then. */
  readonly onProgress?: (done: number) => void;
}

/** A model of one part has so many joints: its middle and its end. */
const ONE_PART = 2;

/** Of the whole, what the format's reader takes. */
const READING = 0.7;

/**
 * Reads the first of `files` that is a model; the others may be its material, picture and .bin files.
 * Errors (ModelError): no model among them, an empty file, and whatever the format's reader finds wrong; the message names the file.
 */
export async function readModel(files: readonly NamedFile[], { onProgress }: ReadingOptions = {}): Promise<Model> {
  const [file, format] = firstModel(files);
  if (!file || !format) {
    const { noModel } = await import("./refused");
    throw new ModelError(noModel(files.map((other) => other.name)));
  }
  const name = baseName(file.name);
  if (file.bytes.length === 0) throw new ModelError(`${name} is empty.`);
  try {
    const notes: string[] = [];
    const document = await READERS[format.id]({ name, file, files, notes, onProgress: (done) => onProgress?.(READING * done) });
    onProgress?.(READING);
    const model = modelOf(name, document, notes);
    return model.joints.length > ONE_PART ? (await import("./parted")).parted(model) : model;
  } catch (error) {
    if (error instanceof ModelError) throw error;
    const why = error instanceof Error ? error.message : String(error);
    throw new ModelError(`${name} could not be read: ${why.replace(/\.$/, "")}.`);
  }
}

function firstModel(files: readonly NamedFile[]): [NamedFile, NonNullable<ReturnType<typeof modelFormat>>] | [] {
  for (const file of files) {
    const format = modelFormat(file);
    if (format) return [file, format];
  }
  return [];
}
