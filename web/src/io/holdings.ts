// What a file of a model's format seems to hold, without being read: its reader has the last word.

import { fbxNodes } from "./fbx-nodes";
import { modelFormat } from "./formats";
import { decodeText, type NamedFile } from "./named-file";

export interface Holdings {
  readonly mesh: boolean;
  readonly clips: boolean;
}

export function holdingsOf(file: NamedFile): Holdings {
  const format = modelFormat(file);
  if (!format || !("clips" in format)) return { mesh: true, clips: false };
  const { bytes } = file;
  if (format.id === "fbx") {
    const has = (name: string): boolean => !fbxNodes(bytes, name).next().done;
    return { mesh: has("Vertices"), clips: has("AnimationCurve") };
  }
  const text = ("text" in format ? format.text(bytes) : decodeText(bytes)) ?? "";
  return { mesh: /"meshes"\s*:\s*\[\s*\{/.test(text), clips: /"animations"\s*:\s*\[\s*\{/.test(text) };
}
