// What is known of a kind of file. formats.ts is the table of them.

/**
 * model: a surface. motion: moves it. skeleton: what a motion needs beside it. project: names a model and a motion.
 * archive: holds other files. picture, part: what a model names beside it.
 * song: plays with a dance.
 */
export type FormatKind = "model" | "motion" | "skeleton" | "project" | "archive" | "picture" | "part" | "song";

export interface Format {
  readonly id: string;
  readonly kind: FormatKind;
  /** As people call it. */
  readonly words: string;
  /** The usual one first. */
  readonly extensions: readonly string[];
  readonly mediaType: string;
  /** Whether its content says so; without it only its name does. */
  readonly is?: (content: Content) => boolean;
  /** Of a model: it may hold motions as well, or alone. */
  readonly clips?: true;
  /** Files that it names, relative to it. */
  readonly names?: (text: string) => string[];
  /** Of a binary format: the text in which it names them. */
  readonly text?: (bytes: Uint8Array) => string;
}

/** What a file is recognised by. */
export interface Content {
  readonly bytes: Uint8Array;
  /** The first 256 bytes, a letter each. */
  readonly head: string;
  /** The first 64 kB; "" where that is no text. */
  readonly text: string;
}

export function starts(bytes: Uint8Array, at: number, ...magic: number[]): boolean {
  return magic.every((byte, i) => bytes[at + i] === byte);
}

/** "OBJ, OFF, PLY"; with `last`, "OBJ, OFF or PLY". */
export function wordList(words: readonly string[], last?: "and" | "or"): string {
  return last && words.length > 1 ? `${words.slice(0, -1).join(", ")} ${last} ${words.at(-1)}` : words.join(", ");
}
