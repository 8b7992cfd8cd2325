// Zips from strangers: bounded, and no name leaves the archive.

import { unzipSync, zipSync } from "fflate";

import { DocumentError } from "../document/project";
import { formatOf } from "./formats";
import { baseName, type NamedFile } from "./named-file";

/** Bytes that an archive may unpack to, all files together. */
const MOST_BYTES = 512 * 1024 * 1024;
const MOST_FILES = 1000;

export function isZip(file: NamedFile): boolean {
  return formatOf(file)?.kind === "archive";
}

/**
 * `wanted`: by default all. Folders and what systems leave behind are passed over. Errors (DocumentError): broken; too large
 * unpacked; a path that leads out.
 */
export function unzip(file: NamedFile, wanted: (path: string) => boolean = () => true): NamedFile[] {
  const name = baseName(file.name);
  let bytes = 0;
  let entries = 0;
  try {
    const unpacked = unzipSync(file.bytes, {
      filter: (entry) => {
        const path = entry.name.replaceAll("\\", "/");
        if (path.startsWith("/") || /^[a-z]:/i.test(path) || path.split("/").includes("..")) {
          throw new DocumentError(`${name} holds a file whose path leads out of it (${entry.name.slice(0, 60)}). We did not open it.`);
        }
        if (path.endsWith("/") || isLeftBehind(path)) return false;
        // fflate never writes more than this declared size.
        bytes += entry.originalSize;
        entries += 1;
        if (bytes > MOST_BYTES || entries > MOST_FILES) {
          throw new DocumentError(
            `${name} would unpack to more than ${bytes > MOST_BYTES ? "512 MB" : "1,000 files"}. We did not open it.`,
          );
        }
        return wanted(path);
      },
    });
    return Object.entries(unpacked).map(([path, content]) => ({ name: path.replaceAll("\\", "/"), bytes: content }));
  } catch (error) {
    if (error instanceof DocumentError) throw error;
    throw new DocumentError(`${name} is a broken zip: ${error instanceof Error ? error.message : String(error)}.`);
  }
}

/** The same files give the same bytes. */
export function zip(files: readonly NamedFile[]): Uint8Array<ArrayBuffer> {
  return zipSync(Object.fromEntries(files.map(({ name, bytes }) => [name, bytes])), { level: 6, mtime: new Date(1980, 0, 1) });
}

/** .DS_Store, __MACOSX and their like. */
export function isLeftBehind(path: string): boolean {
  return path.startsWith("__MACOSX/") || baseName(path).startsWith(".") || baseName(path) === "Thumbs.db";
}
