// One way in for every model format; runs in the page's worker and in Node alike.

import { modelFormat } from "./formats";
import type { Built } from "./gltf/build";
import { buildModel, type Model } from "./model";
import { baseName, ModelError, type NamedFile } from "./named-file";
import { noModel } from "./refused";
import { READERS, type Surface } from "./readers";

export type { Model } from "./model";

export interface ReadingOptions {
  /** 0..1, now and then. */
  readonly onProgress?: (done: number) => void;
}

/** Of the whole, what the format's reader takes. */
const READING = 0.7;

/**
 * Reads the first of `files` that is a model; the others may be its material, picture and .bin files.
 * Errors (ModelError): no model among them, an empty file, and whatever the format's reader finds wrong; the message names the file.
 */
export async function readModel(files: readonly NamedFile[], { onProgress }: ReadingOptions = {}): Promise<Model> {
  const [file, format] = firstModel(files);
  if (!file || !format) {
    throw new ModelError(noModel(files.map((other) => other.name)));
  }
  const name = baseName(file.name);
  if (file.bytes.length === 0) throw new ModelError(`${name} is empty.`);
  try {
    const notes: string[] = [];
    const { parts, texture } = surfaceOf(
      await READERS[format.id]({ name, file, files, notes, onProgress: (done) => onProgress?.(READING * done) }),
      notes,
    );
    onProgress?.(READING);
    return buildModel(name, parts, texture, notes);
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

function surfaceOf(read: Surface | Built, notes: string[]): Surface {
  if ("texture" in read) return read;
  const pbrOf = (material = -1) => read.materials?.[material]?.pbrMetallicRoughness;
  const parts = read.parts.map(({ positions, index, colors, uvs, material }) => {
    const n = positions.length / 3;
    const factor = pbrOf(material)?.baseColorFactor;
    const width = colors ? colors.length / n : 0;
    const rgb = (i: number): number => (colors ? colors[width * Math.floor(i / 3) + (i % 3)] : 1) * (factor?.[i % 3] ?? 1);
    return {
      positions,
      index,
      colors: colors || factor ? Float32Array.from({ length: 3 * n }, (_, i) => rgb(i)) : null,
      uvs: uvs?.[0] ?? null,
    };
  });
  const used = [...new Set(read.parts.flatMap(({ material }) => pbrOf(material)?.baseColorTexture?.index ?? []))];
  if (used.length > 1) notes.push(`This model has ${used.length} pictures; we show its plain colours.`);
  return { parts, texture: used.length === 1 ? (read.pictures?.[used[0]].picture ?? null) : null };
}
