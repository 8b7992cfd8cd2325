// A GLB, or a .gltf with the files beside it, as a document. Nothing is fetched.

import type { Gltf, GltfDocument, Picture } from "../../gltf/document";
import { baseName, decodeUri, findFile, ModelError, type NamedFile } from "../named-file";
import { takeOutside, takePicture } from "../take-picture";
import { broken, checkAccessors, checkJson, checkViews } from "./check";
import { expand, forgetFallbacks, isPacked } from "./expand";

/** Errors (ModelError): not glTF 2.0; broken; a .bin that is missing; packed in a way that we do not know. */
export async function readDocument(name: string, file: NamedFile, files: readonly NamedFile[], notes: string[]): Promise<GltfDocument> {
  const { json, bin } = split(name, file.bytes);
  if (typeof json.asset?.version !== "string" || !json.asset.version.startsWith("2")) throw new ModelError(`${name} is not glTF 2.0.`);
  checkJson(name, json);
  forgetFallbacks(json);
  const buffers = (json.buffers ?? []).map(({ uri, byteLength }, i) => {
    if (typeof uri !== "string") return i === 0 && bin ? bin : new Uint8Array(0);
    const bytes = bytesOf(uri, file.name, files);
    if (!bytes) throw new ModelError(`${name} needs ${baseName(decodeUri(uri))}; drop both together.`);
    return bytes.subarray(0, Math.max(0, byteLength) || 0);
  });
  checkViews(name, json, buffers, isPacked);
  const whole = await expand(name, json, buffers);
  checkAccessors(name, whole.json);
  return { ...whole, images: imagesOf(whole, file.name, files, notes) };
}

/** A GLB's JSON and bytes, or the JSON of a .gltf. Errors (ModelError): it is neither. */
export function split(name: string, bytes: Uint8Array): { json: Gltf; bin: Uint8Array | null } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let text = bytes;
  let bin: Uint8Array | null = null;
  if (bytes.length >= 4 && view.getUint32(0, true) === 0x46546c67) {
    const cut = broken(name, "it ends early or its parts do not fit");
    if (bytes.length < 20) throw cut;
    const end = 20 + view.getUint32(12, true);
    if (end > bytes.length) throw cut;
    text = bytes.subarray(20, end);
    if (end + 8 <= bytes.length && view.getUint32(end + 4, true) === 0x004e4942) {
      const length = view.getUint32(end, true);
      if (end + 8 + length > bytes.length) throw cut;
      bin = bytes.subarray(end + 8, end + 8 + length);
    }
  }
  try {
    const json: unknown = JSON.parse(new TextDecoder().decode(text));
    if (typeof json === "object" && json !== null && "asset" in json) return { json: json as Gltf, bin };
  } catch {
    // Not JSON: said below.
  }
  throw new ModelError(`${name} holds no glTF model.`);
}

/** What an address in the file means: bytes in the address itself, or a file that was given. */
function bytesOf(uri: string, from: string, files: readonly NamedFile[]): Uint8Array | null {
  if (!uri.startsWith("data:")) return findFile(files, decodeUri(uri), from)?.bytes ?? null;
  const comma = uri.indexOf(",");
  if (comma < 0) return null;
  const text = uri.slice(comma + 1);
  if (!uri.slice(0, comma).endsWith(";base64")) return new TextEncoder().encode(decodeUri(text));
  try {
    return Uint8Array.from(atob(decodeUri(text)), (letter) => letter.charCodeAt(0));
  } catch {
    return null;
  }
}

function imagesOf(
  { json, buffers }: Pick<GltfDocument, "json" | "buffers">,
  from: string,
  files: readonly NamedFile[],
  notes: string[],
): (Picture | null)[] {
  const missing = new Set<string>();
  const images = (json.images ?? []).map(({ uri, bufferView, mimeType, name: called }, i): Picture | null => {
    const view = bufferView === undefined ? undefined : json.bufferViews?.[bufferView];
    const start = view?.byteOffset ?? 0;
    const named = typeof uri === "string" && !uri.startsWith("data:") ? baseName(decodeUri(uri)) : "";
    const name = named || (typeof called === "string" && called) || `picture ${i + 1}`;
    const bytes = view ? buffers[view.buffer].subarray(start, start + view.byteLength) : bytesOf(String(uri ?? ""), from, files);
    if (!bytes?.length) {
      missing.add(name);
      return null;
    }
    return named ? takeOutside(name, bytes, notes) : takePicture(name, bytes, typeof mimeType === "string" ? mimeType : undefined, notes);
  });
  if (missing.size > 0) notes.push(`This model names ${[...missing].join(", ")}; drop ${missing.size > 1 ? "them" : "it"} too.`);
  return images;
}
