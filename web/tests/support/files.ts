import { existsSync, readFileSync } from "node:fs";

import type { NamedFile } from "../../src/io/named-file";

/** Models and motions that are not part of the project; tests that use them are skipped where they are absent. */
const shared = new URL("../../../../shared/data/", import.meta.url);

export const hasShared = existsSync(shared);

export function sharedFile(path: string): NamedFile {
  return { name: path.slice(path.lastIndexOf("/") + 1), bytes: new Uint8Array(readFileSync(new URL(path, shared))) };
}

export function textFile(name: string, text: string): NamedFile {
  return { name, bytes: new TextEncoder().encode(text) };
}

/** An OBJ tetrahedron. */
export const TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/** Bytes of a 1 x 1 PNG. */
export const PNG = Uint8Array.from(
  atob("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg=="),
  (letter) => letter.charCodeAt(0),
);

const read =
  (folder: string) =>
  (path: string): NamedFile => ({
    name: path.slice(path.lastIndexOf("/") + 1),
    bytes: new Uint8Array(readFileSync(new URL(`../../${folder}/${path}`, import.meta.url))),
  });
/** A file of tests/fixtures. */
export const fixture = read("tests/fixtures");
/** A file of assets. */
export const asset = read("assets");
