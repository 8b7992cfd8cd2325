// Writing whole files or none, and never over what was read.

import { lstat, realpath, rename, rm, stat, writeFile } from "node:fs/promises";
import { basename, dirname, join, resolve } from "node:path";

import { codeOf, FileError, filesRead } from "./files";

/** As a path: standard output. */
export const STDOUT = "-";

/** Files that appear together at the end, under their names, or not at all. */
export class OutputFiles {
  private readonly pending: { path: string; place: string; temporary: string }[] = [];
  private out: Uint8Array | null = null;

  private constructor(private readonly places: ReadonlyMap<string, string>) {}

  /** Errors (FileError), before any work is done: a folder that is not there; a place that is no file, or another result's. */
  static async prepare(paths: readonly (string | null)[]): Promise<OutputFiles> {
    const places = new Map<string, string>();
    for (const path of paths) {
      if (path === null) continue;
      const place = path === STDOUT ? STDOUT : await placeOf(path);
      if ([...places.values()].includes(place)) throw new FileError(`${path}: two results cannot be one file.`);
      places.set(path, place);
    }
    return new OutputFiles(places);
  }

  /** Errors (FileError): a result would replace what was read so far. */
  keepInputs(): void {
    for (const [path, place] of this.places)
      if (filesRead.has(place)) throw new FileError(`${path}: it is read for this; a result goes elsewhere.`);
  }

  async add(path: string, bytes: Uint8Array): Promise<void> {
    if (path === STDOUT) {
      this.out = bytes;
      return;
    }
    this.keepInputs();
    const place = this.places.get(path) ?? path;
    const temporary = `${place}.${process.pid}.tmp`;
    await writing(path, writeFile(temporary, bytes, { flag: "wx" }));
    this.pending.push({ path, place, temporary });
  }

  async commit(): Promise<void> {
    for (const { path, place, temporary } of this.pending) await writing(path, rename(temporary, place));
    this.pending.length = 0;
    if (this.out) await print(this.out);
  }

  async discard(): Promise<void> {
    await Promise.all(this.pending.map(({ temporary }) => rm(temporary, { force: true })));
  }
}

/** Resolves when all of it is on its way. */
export async function print(what: Uint8Array | string): Promise<void> {
  const done = new Promise<void>((written, failed) => process.stdout.write(what, (error) => (error ? failed(error) : written())));
  await writing("standard output", done);
}

/** Where links lead. */
async function placeOf(path: string): Promise<string> {
  const folder = await stat(dirname(resolve(path))).catch(() => null);
  if (!folder?.isDirectory()) throw new FileError(`${path}: there is no folder ${dirname(path)}.`);
  const there = await stat(path).catch(() => null);
  if (there?.isDirectory()) throw new FileError(`${path}: it is a folder.`);
  if (there && !there.isFile()) throw new FileError(`${path}: it is a device or a pipe, not a file.`);
  if (there) return realpath(path);
  if (await lstat(path).catch(() => null)) throw new FileError(`${path}: it is a link to nothing.`);
  return join(await realpath(dirname(resolve(path))), basename(path));
}

async function writing(path: string, work: Promise<void>): Promise<void> {
  await work.catch((error: unknown) => {
    throw new FileError(`${path}: it cannot be written (${codeOf(error)}).`);
  });
}
