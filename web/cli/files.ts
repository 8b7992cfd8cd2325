// Reading a project from disk.

import { readdir, readFile, realpath, stat } from "node:fs/promises";
import { basename, dirname, isAbsolute, join, relative, resolve } from "node:path";

import { parseProject } from "../src/document/project";
import { formatNamed } from "../src/io/formats";
import { baseName, decodeText, type NamedFile } from "../src/io/named-file";
import { openProject, type OpenedProject } from "../src/io/project-file";
import { findMotions, type FoundMotion } from "../src/io/read-motion-files";
import { sortFiles } from "../src/io/sort-files";
import { isZip } from "../src/io/zip";

/** A file that cannot be read or written; `message` names it. */
export class FileError extends Error {}

/** Real paths of all that was read: no result takes the place of any. */
export const filesRead: Set<string> = new Set();

/** A saved project, or a project.json and the files that it names, relative to it. */
export async function loadProject(path: string): Promise<OpenedProject> {
  const project = await read(path, basename(path));
  if (isZip(project)) return openProject([project]);
  const name = basename(path);
  const text = decodeText(project.bytes);
  if (text === null) throw new FileError(`${name} is neither a project.json nor a saved project.`);
  const { document } = parseProject(text, name);
  const folder = dirname(path);
  const { companion } = document;
  const files: NamedFile[] = [];
  for (const { mesh, motion } of companion ? [document, companion] : [document]) {
    const model = await read(ownPath(folder, mesh.file), mesh.file, name);
    const beside = await readBeside(model, dirname(ownPath(folder, mesh.file)));
    files.push(model, ...beside, ...(await Promise.all((motion?.files ?? []).map((file) => read(ownPath(folder, file), file, name)))));
  }
  const named = new Map(files.map((file) => [file.name, file])); // both may name one
  return openProject([{ ...project, name: "project.json" }, ...named.values()]);
}

/** Its own motion first, then all others that lie beside it: in the saved project, or in the motion's folder. */
export async function motionsOfProject(path: string, own: FoundMotion): Promise<FoundMotion[]> {
  const project = await read(path, basename(path));
  const others = isZip(project) ? (await sortFiles([project])).motions : await motionsIn(dirname(ownPath(dirname(path), own.files[0])));
  const names = ({ files }: FoundMotion): string => files.map(baseName).join();
  return [own, ...others.filter((other) => names(other) !== names(own))];
}

async function motionsIn(folder: string): Promise<FoundMotion[]> {
  const names = (await readdir(folder)).filter((name) => ["motion", "skeleton"].includes(formatNamed(name)?.kind ?? "")).sort();
  const { motions } = await findMotions(await Promise.all(names.map((name) => read(join(folder, name), name))));
  return motions;
}

/** Files that a user names, and what these name beside them. */
export async function readFiles(paths: readonly string[]): Promise<{ given: NamedFile[]; beside: NamedFile[] }> {
  const given = await Promise.all(paths.map((path) => read(path, basename(path))));
  const beside = await Promise.all(given.map((file, n) => readBeside(file, dirname(paths[n]))));
  return { given, beside: beside.flat() };
}

export interface MotionFiles {
  readonly motions: readonly FoundMotion[];
  /** Each holds motions as well: what readClips takes. */
  readonly clipFiles: readonly (readonly NamedFile[])[];
}

export interface ModelAndMotions extends MotionFiles {
  /** The model's own file first. */
  readonly modelFiles: NamedFile[];
}

/** Motions alone: files in any order. */
export async function loadMotions(paths: readonly string[]): Promise<MotionFiles> {
  const { given, beside } = await readFiles(paths);
  const { models, motions, clips, problems } = await sortFiles(given, { motionsOnly: true });
  if (models.length > 0) throw new FileError(`${models[0].name} is no motion, and the project has a model.`);
  if (problems.length > 0) throw new FileError(problems[0]);
  return { motions, clipFiles: clips.map((file) => [file, ...beside]) };
}

/** A model with what it names beside it, and motions: files in any order. A model that moves needs no other file. */
export async function loadModelAndMotions(paths: readonly string[]): Promise<ModelAndMotions> {
  const { given, beside } = await readFiles(paths);
  const { models, moves, motions, clips, problems } = await sortFiles(given);
  const [model] = models;
  const own = moves && motions.length + clips.length === 0 ? [model] : clips;
  if (models.length === 1 && motions.length + own.length > 0 && problems.length === 0)
    return { modelFiles: [model, ...beside], motions, clipFiles: own.map((file) => [file, ...beside]) };
  if (models.length === 1 && given.length === 1)
    throw new FileError(`${given[0].name} holds no motion: name one beside it, as in ${given[0].name} motion.bvh.`);
  throw new FileError(
    problems[0] ??
      `one model and a motion are needed, but among ${given.map((file) => file.name).join(", ")} ` +
        `there are ${models.length} and ${motions.length + own.length}.`,
  );
}

async function read(path: string, name: string, namedBy?: string): Promise<NamedFile> {
  try {
    return { name, bytes: namedBy === undefined ? await readGiven(path) : await readWhole(path) };
  } catch (error) {
    const code = codeOf(error);
    const why =
      code === "ENOENT"
        ? "there is no such file"
        : code === "EISDIR"
          ? "it is a folder"
          : code === "ENOTFILE"
            ? "it is not a file"
            : `it cannot be read (${code})`;
    throw new FileError(namedBy === undefined ? `${path}: ${why}.` : `${namedBy} names ${name}: ${why}.`);
  }
}

async function readGiven(path: string): Promise<Uint8Array> {
  const bytes = new Uint8Array(await readFile(path));
  filesRead.add(await realpath(path));
  return bytes;
}

/** For names that stand in a file: a device or a pipe may never end. */
async function readWhole(path: string): Promise<Uint8Array> {
  const found = await stat(path);
  if (!found.isFile() && !found.isDirectory()) throw Object.assign(new Error("not a file"), { code: "ENOTFILE" });
  return readGiven(path);
}

/** Where a project's model or motion lies: in its folder or one near it, but nothing else of the disk is anything's motion. */
function ownPath(folder: string, name: string): string {
  const { kind } = formatNamed(name) ?? {};
  const near = !isAbsolute(name) && (kind === "model" || kind === "motion" || kind === "skeleton");
  return near ? resolve(folder, name) : (within(folder, folder, name)[0] ?? resolve(folder, baseName(name)));
}

/** Where a name in a file of `folder` leads, if not out of `root`: names in files are others' words. */
function within(root: string, folder: string, name: string): string[] {
  const path = resolve(folder, name);
  return isAbsolute(name) || relative(root, path).startsWith("..") ? [] : [path];
}

/**
 * The materials, pictures and buffers that a model in the folder `root` names; one that is not where its name says, or whose name
 * leads elsewhere, is looked for by its base name. The reader says what is missing.
 */
async function readBeside(file: NamedFile, root: string, folder = root): Promise<NamedFile[]> {
  const own = dirname(file.name);
  const format = formatNamed(file.name);
  const names = format?.names?.(format.text?.(file.bytes) ?? decodeText(file.bytes) ?? "") ?? [];
  const found = await Promise.all(
    [...new Set(names)].map(async (inner) => {
      for (const path of [...within(root, folder, inner), resolve(folder, baseName(inner)), resolve(root, baseName(inner))]) {
        const bytes = await readWhole(path).catch(() => null);
        if (bytes) return [{ name: own === "." ? inner : `${own}/${inner}`, bytes, folder: dirname(path) }];
      }
      return [];
    }),
  );
  const files = found.flat();
  // Only a model goes deeper, and only to its own parts: a material names pictures, whatever it says.
  const parts = files.filter((other) => format?.kind === "model" && formatNamed(other.name)?.kind === "part");
  const deeper = await Promise.all(parts.map((other) => readBeside(other, root, other.folder)));
  return [...files.map(({ name, bytes }) => ({ name, bytes })), ...deeper.flat()];
}

export function codeOf(error: unknown): string {
  return error instanceof Error && "code" in error ? String(error.code) : String(error);
}
