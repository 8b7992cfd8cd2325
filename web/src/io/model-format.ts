// Kept apart from the readers, so that sorting a drop does not load them.

import { extension, type NamedFile } from "./named-file";

export const MODEL_EXTENSIONS = ["obj", "ply", "stl", "glb", "gltf", "off"] as const;
export type ModelFormat = (typeof MODEL_EXTENSIONS)[number];

/** What a file is by its first bytes, else by its name; null if it is no model that we read. */
export function modelFormat(file: NamedFile): ModelFormat | null {
  const head = new TextDecoder("latin1").decode(file.bytes.subarray(0, 256));
  if (head.startsWith("glTF")) return "glb";
  if (/^ply\s/.test(head)) return "ply";
  if (/^\s*(ST)?C?N?4?n?OFF\b/.test(head)) return "off";
  return MODEL_EXTENSIONS.find((known) => known === extension(file.name)) ?? null;
}
