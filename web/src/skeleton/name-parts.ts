// One joint's name: its side, its own words, and what they mean by themselves. The twin of
// include/rigless/motion/detail/name_parts.h.

import type { Side } from "./body-parts";
import { END_WORDS, LEFT_WORDS, NOISE_WORDS, RIGHT_WORDS, senseOf } from "./name-senses";
import type { NameSense } from "./name-senses";
import { isNumber, plain, sizeOf } from "./name-words";

export interface NameParts {
  /** Without the side and what all names share. */
  words: string[];
  side: Side;
  sense: NameSense;
  /** The end of a bone. */
  end: boolean;
  /** Words beside those of the sense were passed over. */
  guess: boolean;
  /** The side was one word with the rest: "lfemur". */
  grown: boolean;
  /** Nothing but what all names share: "Bip01". */
  bare: boolean;
}

const TRUNK: ReadonlySet<NameSense> = new Set(["none", "hips", "root", "spine", "upper_back", "chest", "neck", "head", "nose"]);

const besideTheSpine = (sense: NameSense): boolean => !TRUNK.has(sense);

/** Takes the side out of the words; of several the longest counts: "R_LeftFoot" is left. A letter alone is no side. */
function takeSide(name: NameParts): void {
  if (name.words.length === 1 && sizeOf(name.words[0]) === 1) return;
  let taken = 0;
  let length = 0;
  name.words.forEach((own, k) => {
    const word = plain(own);
    const left = LEFT_WORDS.has(word);
    if ((!left && !RIGHT_WORDS.has(word)) || sizeOf(word) <= length) return;
    name.side = left ? "left" : "right";
    taken = k;
    length = sizeOf(word);
  });
  if (length > 0) name.words.splice(taken, 1);
  name.words.forEach((word, k) => {
    // Scripts without spaces.
    for (const mark of ["左", "왼쪽", "右", "오른쪽"]) {
      if (name.side !== null || !word.startsWith(mark)) continue;
      name.side = mark === "左" || mark === "왼쪽" ? "left" : "right";
      name.words[k] = word.slice(mark.length);
    }
  });
}

/** "lfoot", "LeftFoot" in small letters, "footl": a side that is one word with a part that has sides; answers what the rest means. */
function takeGrownSide(name: NameParts, word: string): NameSense | null {
  let sense: NameSense | null = null;
  for (const mark of ["left", "right", "l", "r"]) {
    if (name.side !== null || sizeOf(word) <= mark.length + 1) continue;
    let rest = word.startsWith(mark) ? word.slice(mark.length) : "";
    let found = senseOf(rest);
    if (!besideTheSpine(found) && word.endsWith(mark)) {
      rest = word.slice(0, -mark.length);
      found = senseOf(rest);
    }
    if (!besideTheSpine(found)) continue;
    sense = found;
    name.side = mark.startsWith("l") ? "left" : "right";
    name.grown = true;
    name.words = name.words.map((own) => (own === word ? rest : own));
  }
  return sense;
}

/** The sense of words among others: any that names a finger, else the last ones, else for the trunk the first ones. */
function guessSense(words: readonly string[], side: Side): NameSense {
  const senses = words.map(senseOf);
  if (senses.includes("helper")) return "none";
  const isFinger = (word: string, k: number): boolean =>
    senses[k] === "finger" || word.endsWith("指") || (side !== null && (word === "mid" || word === "middle"));
  if (words.some(isFinger)) return "finger";
  for (let k = 1; k < words.length; k++) {
    const sense = senseOf(words.slice(k).join(""));
    if (sense !== "none") return sense;
  }
  for (let k = words.length - 1; k >= 1; k--) {
    const sense = senseOf(words.slice(0, k).join(""));
    if (sense === "spine" || sense === "chest" || sense === "neck") return sense;
  }
  return "none";
}

/** `words` as of nameWords(), without what all names share. */
export function readName(words: readonly string[]): NameParts {
  const name: NameParts = { words: [...words], side: null, sense: "none", end: false, guess: false, grown: false, bare: false };
  takeSide(name);
  const telling: string[] = [];
  const all: string[] = [];
  for (const own of name.words) {
    const word = plain(own);
    if (isNumber(word)) continue;
    if (END_WORDS.has(word)) {
      name.end = true;
      continue;
    }
    all.push(word);
    if (!NOISE_WORDS.has(word)) telling.push(word);
  }
  name.sense = senseOf(all.join(""));
  const core = telling.join("");
  if (name.sense === "none") name.sense = senseOf(core);
  if (name.sense === "helper") name.sense = "none";
  if (name.sense !== "none") return name;
  const grown = takeGrownSide(name, core);
  if (grown !== null) return { ...name, sense: grown };
  if (telling.some((word) => takeGrownSide(name, word) !== null)) {
    // Once more without it.
    return { ...readName(name.words), side: name.side, grown: true };
  }
  name.sense = guessSense(telling, name.side);
  name.guess = name.sense !== "none";
  return name;
}
