// The names of one skeleton, read together. The twin of include/rigless/motion/detail/name_reader.h.

import type { BodyPart, JointName, Side } from "./body-parts";
import { readName } from "./name-parts";
import type { NameParts } from "./name-parts";
import type { NameSense } from "./name-senses";
import { isNumber, nameWords, sizeOf } from "./name-words";
import { dropSharedWords } from "./shared-words";

type Part = BodyPart | null;

export class NameReader {
  private readonly names: NameParts[];
  private readonly known: ReadonlySet<string>;
  /** Joints are the ends of their bones: Acclaim's bones, and no end sites. */
  readonly boneEnds: boolean;

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
    this.known = new Set(this.names.map(({ side, sense }) => `${side} ${sense}`));
    this.boneEnds = this.hasBoneEnds();
  }

  read(): JointName[] {
    const { names } = this;
    const result = names.map(({ side }, j) => ({ side, part: this.part(j) }));
    this.readRigify(result);
    // What was passed over a word yields to what says it plainly.
    for (const [j, read] of result.entries()) {
      if (!names[j].guess || read.part === "tip" || read.part === "end" || read.part === "finger") continue;
      if (result.some(({ part, side }, k) => part === read.part && side === read.side && !names[k].guess)) read.part = null;
    }
    return this.label(result);
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

  private hasBoneEnds(): boolean {
    const grown = (sense: NameSense): boolean => this.names.some((name) => name.grown && name.sense === sense);
    return !this.names.some(({ end }) => end) && grown("femur") && grown("tibia");
  }

  private has(side: Side, ...senses: NameSense[]): boolean {
    return senses.some((sense) => this.known.has(`${side} ${sense}`));
  }

  private hasAnywhere(sense: NameSense): boolean {
    return this.has(null, sense) || this.has("left", sense) || this.has("right", sense);
  }

  private part(joint: number): Part {
    const name = this.names[joint];
    const meant = this.boneEnds ? this.partAtBoneEnd(name) : this.partByContext(joint);
    if (!name.end) return meant;
    return meant === "toe" || meant === "foot" ? "tip" : "end";
  }

  private partAtBoneEnd(name: NameParts): Part {
    switch (name.sense) {
      case "hip_joint":
        return "upper_leg";
      case "femur":
        return "lower_leg";
      case "tibia":
        return "foot";
      case "foot":
        return "toe";
      case "toe":
        return "tip";
      case "collar":
        return "upper_arm";
      case "humerus":
        return "lower_arm";
      case "radius":
        return "hand";
      default:
        return this.partBySense(name);
    }
  }

  /** Words that mean one thing here and another there. */
  private partByContext(joint: number): Part {
    const name = this.names[joint];
    const { side } = name;
    const thigh = this.has(side, "upper_leg", "femur");
    const upperLeg = thigh || (side !== null && this.has(side, "hip"));
    const lowerLeg = this.has(side, "lower_leg", "tibia");
    const upperArm = this.has(side, "upper_arm", "humerus");
    const lowerArm = this.has(side, "lower_arm", "radius");
    switch (name.sense) {
      case "hip":
        if (side === null) return "hips";
        return thigh ? null : "upper_leg";
      case "hip_joint":
        return upperLeg ? null : "upper_leg";
      case "leg":
        return upperLeg || (!lowerLeg && !this.isFirstOfItsWords(joint)) ? "lower_leg" : "upper_leg";
      case "arm":
        if (upperArm) return lowerArm ? "upper_arm" : "lower_arm";
        return !lowerArm && !this.isFirstOfItsWords(joint) ? "lower_arm" : "upper_arm";
      case "shoulder":
        return upperArm || this.has(side, "arm") ? "shoulder" : "upper_arm";
      case "foot":
        return this.has(side, "ankle") && !this.has(side, "toe") ? "toe" : "foot";
      default:
        return this.partBySense(name);
    }
  }

  private partBySense({ sense, side }: NameParts): Part {
    switch (sense) {
      case "hips":
      case "hip":
        return "hips";
      case "root":
        return this.hasAnywhere("hips") || this.has(null, "hip") ? null : "hips";
      case "spine":
        return "spine";
      case "upper_back":
        return this.hasAnywhere("chest") ? "spine" : "chest";
      case "chest":
        return "chest";
      case "neck":
        return "neck";
      case "head":
        return "head";
      case "nose":
        return this.hasAnywhere("head") ? null : "head";
      case "collar":
        return "shoulder";
      case "shoulder":
      case "upper_arm":
      case "arm":
      case "humerus":
        return "upper_arm";
      case "lower_arm":
      case "radius":
        return "lower_arm";
      case "hand":
        return "hand";
      case "finger":
        return "finger";
      case "upper_leg":
      case "femur":
        return "upper_leg";
      case "lower_leg":
      case "leg":
      case "tibia":
        return "lower_leg";
      case "ankle":
      case "foot":
        return "foot";
      case "toe":
        return "toe";
      case "big_toe":
        return this.has(side, "toe") ? null : "toe";
      default:
        return null;
    }
  }

  private isFirstOfItsWords(joint: number): boolean {
    const { side, sense } = this.names[joint];
    return !this.names.slice(0, joint).some((name) => name.side === side && name.sense === sense && !name.end);
  }

  /** Blender's Rigify calls everything from the hips to the head "spine", numbered to 6. */
  private readRigify(result: { part: Part }[]): void {
    const parts: readonly Part[] = ["hips", "spine", "spine", "chest", "neck", "neck", "head"];
    if (result.some(({ part }) => part === "hips" || part === "chest" || part === "neck" || part === "head")) return;
    const joints = new Map<number, number>();
    this.names.forEach(({ sense, words }, j) => {
      const last = words.at(-1) ?? "";
      if (sense === "spine") joints.set(isNumber(last) ? parseInt(last, 10) : 0, j);
    });
    if (!parts.every((_, k) => joints.has(k))) return;
    parts.forEach((part, k) => (result[joints.get(k) ?? 0].part = part));
  }

  private label(result: readonly { side: Side; part: Part }[]): JointName[] {
    const taken = new Map<string, number>();
    return result.map(({ side, part }, j) => {
      const text = partLabel(side, part) ?? sentence(side, ownWords(this.names[j]));
      let unique = text;
      let last = taken.get(text) ?? 0;
      if (last++ > 0) {
        for (unique = `${text} ${last}`; taken.has(unique); ) unique = `${text} ${++last}`;
        taken.set(unique, 1);
      }
      taken.set(text, last);
      return { side, part, label: unique };
    });
  }
}

/** "L5" and "T12" are vertebrae, unless there is an "R5". */
function keepVertebrae(names: readonly string[][]): string[][] {
  const numbered = (words: readonly string[], letter: string): boolean => words.length === 2 && words[0] === letter && isNumber(words[1]);
  if (names.some((words) => numbered(words, "r"))) return [...names];
  return names.map((words) => (numbered(words, "l") || numbered(words, "t") ? [words.join("")] : words));
}

const LABELS: Readonly<Partial<Record<BodyPart, string>>> = {
  hips: "hips",
  spine: "spine",
  chest: "chest",
  neck: "neck",
  head: "head",
  shoulder: "collar",
  upper_arm: "shoulder",
  lower_arm: "elbow",
  hand: "hand",
  upper_leg: "hip",
  lower_leg: "knee",
  foot: "foot",
  toe: "toes",
  tip: "toe tip",
};

/** "Left elbow"; null for a part of which there are many. */
export function partLabel(side: Side, part: Part): string | null {
  const words = part && LABELS[part];
  return words ? sentence(side, words) : null;
}

function ownWords({ words }: NameParts): string {
  return words.reduce((text, word) => `${text}${text === "" || (word === "arm" && text.endsWith("fore")) ? "" : " "}${word}`, "");
}

function sentence(side: Side, words: string): string {
  return (side ? `${side} ${words}` : words).replace(/^[a-z]/, (letter) => letter.toUpperCase());
}
