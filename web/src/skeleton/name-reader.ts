// The names of one skeleton, read together. The twin of include/rigless/motion/detail/name_reader.h.

import { labelJoints } from "./joint-labels";
import type { BodyPart, JointName } from "./body-parts";
import { readName } from "./name-parts";
import type { NameParts } from "./name-parts";
import { isNumber, nameWords, sizeOf } from "./name-words";
import { PartReader } from "./part-reader";
import { dropSharedWords } from "./shared-words";

type Part = BodyPart | null;

export class NameReader {
  private readonly names: NameParts[];
  private readonly parts: PartReader;

  constructor(names: readonly string[]) {
    const whole = names.map(nameWords);
    const words = keepVertebrae(dropSharedWords(whole));
    this.names = words.map((own, j) => {
      const name = readName(own);
      name.bare = own.length === 0 && whole[j].length > 0;
      if (name.bare) name.sense = "root";
      if (name.words.length === 0) name.words = [...whole[j]];
      if (name.words.length === 0) name.words.push("joint");
      return name;
    });
    this.findTwins();
    this.parts = new PartReader(this.names);
  }

  /** Joints are the ends of their bones: Acclaim's bones, and no end sites. */
  get boneEnds(): boolean {
    return this.parts.boneEnds;
  }

  read(): JointName[] {
    const { names } = this;
    const result = names.map(({ side }, j) => ({ side, part: this.parts.part(j) }));
    this.readRigify(result);
    // What was passed over a word yields to what says it plainly.
    for (const [j, read] of result.entries()) {
      if (!names[j].guess || read.part === "tip" || read.part === "end" || read.part === "finger") continue;
      if (result.some(({ part, side }, k) => part === read.part && side === read.side && !names[k].guess)) read.part = null;
    }
    return labelJoints(names, result);
  }

  /** "lwing": a side grown together with a word that only its twin "rwing" explains. */
  private findTwins(): void {
    const unknown = ({ side, sense, words }: NameParts, letter: string): boolean =>
      side === null && sense === "none" && sizeOf(words[0]) > 2 && words[0].startsWith(letter);
    for (const left of this.names) {
      for (const right of this.names) {
        if (!unknown(left, "l") || !unknown(right, "r")) continue;
        const twin = [`l${right.words[0].slice(1)}`, ...right.words.slice(1)];
        if (twin.length !== left.words.length || twin.some((word, k) => word !== left.words[k])) continue;
        for (const name of [left, right]) name.words[0] = name.words[0].slice(1);
        left.side = "left";
        right.side = "right";
      }
    }
  }

  /** Blender's Rigify calls everything from the hips to the head "spine", numbered to 6; 2 and 5 may be missing. */
  private readRigify(result: { part: Part }[]): void {
    const parts: readonly Part[] = ["hips", "spine", "spine", "chest", "neck", "neck", "head"];
    if (result.some(({ part }) => part === "hips" || part === "chest" || part === "neck" || part === "head")) return;
    const joints = new Map<number, number>();
    this.names.forEach(({ sense, words }, j) => {
      const last = words.at(-1) ?? "";
      if (sense === "spine") joints.set(isNumber(last) ? parseInt(last, 10) : 0, j);
    });
    if (![0, 1, 3, 4, 6].every((k) => joints.has(k))) return;
    for (const [k, j] of joints) if (k < parts.length) result[j].part = parts[k];
  }
}

/** "L5" and "T12" are vertebrae, unless there is an "R5". */
function keepVertebrae(names: readonly string[][]): string[][] {
  const numbered = (words: readonly string[], letter: string): boolean => words.length === 2 && words[0] === letter && isNumber(words[1]);
  if (names.some((words) => numbered(words, "r"))) return [...names];
  return names.map((words) => (numbered(words, "l") || numbered(words, "t") ? [words.join("")] : words));
}
