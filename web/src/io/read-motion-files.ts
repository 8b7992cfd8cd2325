// Which of some files are a motion: a BVH, or an ASF with an AMC. The engine does the reading; here text is told from junk and
// files are paired.

import type { MotionInput } from "../engine/types";
import { baseName, decodeText, extension, type NamedFile } from "./named-file";

export const MOTION_EXTENSIONS = ["bvh", "asf", "amc"] as const;
export type MotionFormat = (typeof MOTION_EXTENSIONS)[number];

export interface FoundMotion {
  /** As a project names them: the skeleton first. */
  readonly files: readonly string[];
  readonly input: MotionInput;
}

export interface FoundMotions {
  motions: FoundMotion[];
  /** What cannot be used, in plain words. */
  problems: string[];
}

/** What a file is by what it says, else by its name; null if it is no motion. */
export function motionFormat(file: NamedFile): MotionFormat | null {
  const head = decodeText(file.bytes.subarray(0, 65536)) ?? "";
  if (/^\s*HIERARCHY\b/i.test(head)) return "bvh";
  if (/^[ \t]*:bonedata\b/im.test(head)) return "asf";
  if (/^[ \t]*:(fully-specified|degrees|radians)\b/im.test(head)) return "amc";
  return MOTION_EXTENSIONS.find((known) => known === extension(file.name)) ?? null;
}

/** All motions among `files`, in any order. An AMC takes the ASF whose name it begins with, else the first one. */
export function findMotions(files: readonly NamedFile[]): FoundMotions {
  const motions: FoundMotion[] = [];
  const problems: string[] = [];
  const texts = files.flatMap((file) => {
    const format = motionFormat(file);
    if (!format) return [];
    const text = decodeText(file.bytes);
    if (text !== null && text.trim() !== "") return [{ file, format, text }];
    problems.push(
      `${baseName(file.name)} ${text === null ? "is not text, so it is no" : "is empty, so it is no"} ${format.toUpperCase()} file.`,
    );
    return [];
  });
  const skeletons = texts.filter(({ format }) => format === "asf");
  for (const { file, format, text } of texts) {
    const name = baseName(file.name);
    if (format === "bvh") {
      motions.push({ files: [file.name], input: { format: "bvh", name, text } });
    } else if (format === "amc") {
      const skeleton = skeletons.find((asf) => name.startsWith(stem(asf.file.name))) ?? skeletons[0];
      if (!skeleton) {
        problems.push(`${name} needs its skeleton: drop the .asf with it.`);
        continue;
      }
      motions.push({
        files: [skeleton.file.name, file.name],
        input: { format: "acclaim", skeletonName: baseName(skeleton.file.name), skeleton: skeleton.text, name, text },
      });
    }
  }
  for (const { file } of skeletons) {
    if (!motions.some((motion) => motion.files[0] === file.name)) {
      problems.push(`${baseName(file.name)} is a skeleton without a motion: drop an .amc with it.`);
    }
  }
  return { motions, problems };
}

function stem(path: string): string {
  return baseName(path).replace(/\.[^.]*$/, "");
}
