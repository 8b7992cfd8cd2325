// What most names of a skeleton have in common at either end: "mixamorig", "CC_Base", "Character1", "_JNT". The twin of
// include/rigless/motion/detail/shared_words.h.

import { END_WORDS, LEFT_WORDS, RIGHT_WORDS, senseOf } from "./name-senses";
import { isNumber, plain } from "./name-words";

/** Whether a word says something of its joint, however many names have it. Not all can be helpers. */
function saysSomething(word: string): boolean {
  const text = plain(word);
  return !["none", "helper"].includes(senseOf(text)) || [LEFT_WORDS, RIGHT_WORDS, END_WORDS].some((words) => words.has(text));
}

/**
 * Names without the words with which more than half of them begin or end; numbers only after such a word. A name of which
 * numbers alone would be left keeps its words.
 */
export function dropSharedWords(names: readonly string[][]): string[][] {
  if (names.length < 4) return names.map((words) => [...words]);
  const shorter = dropAtEnd(
    names,
    (words) => words.at(0),
    (words) => words.slice(1),
    false,
  );
  return dropAtEnd(
    shorter,
    (words) => words.at(-1),
    (words) => words.slice(0, -1),
    true,
  );
}

type Words = string[];

function dropAtEnd(
  whole: readonly Words[],
  end: (words: Words) => string | undefined,
  rest: (words: Words) => Words,
  atEnd: boolean,
): Words[] {
  let names = [...whole];
  for (let first = true; ; first = false) {
    const count = new Map<string, number>();
    for (const word of names.map(end)) if (word !== undefined) count.set(word, (count.get(word) ?? 0) + 1);
    const [most] = [...count].find(([, times]) => 2 * times > names.length) ?? [];
    if (most === undefined || saysSomething(most) || (isNumber(most) && (first || atEnd))) break;
    names = names.map((words) => (end(words) === most ? rest(words) : words));
  }
  return names.map((words, j) => (words.length > 0 && words.every(isNumber) ? whole[j] : words));
}
