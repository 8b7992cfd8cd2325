// A file as the page drops it and as Node reads it.

export interface NamedFile {
  /** With its path relative to what was dropped, "/" between folders. */
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** A model or a motion that cannot be read. `message` names the file and is made to be shown. */
export class ModelError extends Error {
  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = "ModelError";
  }
}

/** "a/b/Cow.OBJ" -> "Cow.OBJ" */
export function baseName(path: string): string {
  return path.slice(Math.max(path.lastIndexOf("/"), path.lastIndexOf("\\")) + 1);
}

/** "a/b/Cow.OBJ" -> "obj"; "" without one. */
export function extension(path: string): string {
  const name = baseName(path);
  const dot = name.lastIndexOf(".");
  return dot < 0 ? "" : name.slice(dot + 1).toLowerCase();
}

/** "oak%20wood.png" -> "oak wood.png"; as it is where that is no encoding. */
export function decodeUri(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/** The file that `path` means, seen from the folder of `from`; else one of the same base name; else undefined. */
export function findFile(files: readonly NamedFile[], path: string, from = ""): NamedFile | undefined {
  const wanted = normalPath(folder(from) + path);
  const lower = baseName(wanted).toLowerCase();
  return files.find((file) => normalPath(file.name) === wanted) ?? files.find((file) => baseName(file.name).toLowerCase() === lower);
}

function folder(path: string): string {
  return path.slice(0, path.length - baseName(path).length);
}

/** Without ".", ".." and doubled slashes; never leads upwards. */
export function normalPath(path: string): string {
  const out: string[] = [];
  for (const part of path.replaceAll("\\", "/").split("/")) {
    if (part === "..") out.pop();
    else if (part !== "" && part !== ".") out.push(part);
  }
  return out.join("/");
}

/** Null if the bytes are not text: a zero byte, or too many that no text has. Knows UTF-8 and, by its mark, UTF-16. */
export function decodeText(bytes: Uint8Array): string | null {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return new TextDecoder("utf-16le").decode(bytes);
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return new TextDecoder("utf-16be").decode(bytes);
  const head = bytes.subarray(0, 4096);
  let odd = 0;
  for (const byte of head) {
    if (byte === 0) return null;
    if (byte < 32 && byte !== 9 && byte !== 10 && byte !== 12 && byte !== 13) odd++;
  }
  if (odd * 20 > head.length) return null;
  return new TextDecoder("utf-8").decode(bytes);
}

/** What to do about a file that ends too early. */
export const CUT_SHORT = "It may have been cut short: fetch or save it once more.";
