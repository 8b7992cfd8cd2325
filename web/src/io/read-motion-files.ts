// Which of some files are motions, each with its skeleton. The engine reads text; here it is told from junk, and files are paired.

import type { MotionInput } from "../engine/types";
import type { Format } from "./format";
import { FORMATS, formatOf, motionFormat, type MotionSource } from "./formats";
import type { OwnMoves } from "./clips/own-moves";
import { baseName, decodeText, ModelError, type NamedFile } from "./named-file";

export interface FoundMotion {
  /** As a project names them: the skeleton first. */
  readonly files: readonly string[];
  readonly input: MotionInput;
  /** Of a clip that came in a file that shows something: how its joints go, as they move that. */
  readonly moves?: OwnMoves;
}

export interface FoundMotions {
  motions: FoundMotion[];
  /** What cannot be used, in plain words. */
  problems: string[];
}

/**
 * All motions among `files`, in any order. A motion takes the skeleton whose name its own begins with, else the first one of `files`,
 * else the first one `atHand`.
 */
export async function findMotions(files: readonly NamedFile[], atHand: readonly NamedFile[] = []): Promise<FoundMotions> {
  const motions: FoundMotion[] = [];
  const problems: string[] = [];
  const sources = files.flatMap((file) => sourceOf(file, problems));
  const skeletons = sources.filter(({ format }) => format.kind === "skeleton");
  const others = atHand.flatMap((file) => sourceOf(file, []));
  for (const source of sources) {
    const format = motionFormat(source.file);
    if (!format) continue;
    const own = [...skeletons, ...others].filter((other) => other.format.id === format.skeleton);
    const skeleton = own.find((other) => source.name.startsWith(stem(other.name))) ?? own[0];
    if (format.skeleton !== undefined && !skeleton) {
      problems.push(`${source.name} needs its skeleton: drop the .${format.skeleton} with it.`);
      continue;
    }
    const used = format.skeleton === undefined ? [source] : [skeleton, source];
    try {
      motions.push({ files: used.map(({ file }) => file.name), input: await format.read(source, skeleton ?? source) });
    } catch (error) {
      if (!(error instanceof ModelError)) throw error;
      problems.push(error.message);
    }
  }
  for (const { file, name, format } of skeletons) {
    if (motions.some((motion) => motion.files[0] === file.name)) continue;
    const needing = FORMATS.find((other) => "skeleton" in other && other.skeleton === format.id);
    problems.push(`${name} is a skeleton without a motion: drop an .${needing?.id} with it.`);
  }
  return { motions, problems };
}

interface Source extends MotionSource {
  readonly file: NamedFile;
  readonly format: Format;
}

/** A motion's or a skeleton's file; none, with a problem, where it should be text and is not. */
function sourceOf(file: NamedFile, problems: string[]): Source[] {
  const format = formatOf(file);
  if (format?.kind !== "motion" && format?.kind !== "skeleton") return [];
  const name = baseName(file.name);
  const { bytes } = file;
  if ("binary" in format) return [{ file, name, bytes, format, text: "" }];
  const text = decodeText(bytes);
  if (text !== null && text.trim() !== "") return [{ file, name, bytes, format, text }];
  problems.push(`${name} is ${text === null ? "not text" : "empty"}, so it is no ${format.words} file.`);
  return [];
}

function stem(path: string): string {
  return baseName(path).replace(/\.[^.]*$/, "");
}
