// Every kind of file that Rigless opens: one row each. File dialogs, drops, the command line, the readers and the sentences about
// them read this table, and a test holds README and docs to it. A new format is a row here and a reader.

import type { MotionInput } from "../engine/types";
import { type Content, type Format, type FormatKind, starts, wordList } from "./format";
import type { GltfDocument } from "../gltf/document";
import { decodeText, decodeUri, extension, type NamedFile } from "./named-file";
import { PICTURES } from "./picture";

/** What the reader of a model is given. */
export interface ModelSource {
  /** Without folders. */
  readonly name: string;
  readonly file: NamedFile;
  /** The file's text; errors (ModelError): it is none. */
  readonly text: () => string;
  /** All files, the model's own among them. */
  readonly files: readonly NamedFile[];
  /** What was worked around, in plain words: the reader adds to it. */
  readonly notes: string[];
}

export interface ModelFormat extends Format {
  readonly kind: "model";
  /** Loads its reader, so that nobody loads those of other formats. */
  readonly read: (source: ModelSource) => Promise<GltfDocument>;
}

export interface MotionSource {
  /** Without folders. */
  readonly name: string;
  readonly bytes: Uint8Array;
  /** "" for a binary format. */
  readonly text: string;
}

export interface MotionFormat extends Format {
  readonly kind: "motion";
  /** Not text: its reader gets the bytes alone. */
  readonly binary?: true;
  /** Id of the skeleton's format that it needs beside it. */
  readonly skeleton?: string;
  /** Errors (ModelError): it cannot be read. Of text the engine says what is wrong. */
  readonly read: (motion: MotionSource, skeleton: MotionSource) => MotionInput | Promise<MotionInput>;
}

/** First groups of all matches. No pattern may run over line ends or try one stretch of spaces in two ways: files can be long. */
const all = (text: string, pattern: RegExp): string[] => [...text.matchAll(pattern)].map((match) => match[1].trim());

const MODELS: readonly ModelFormat[] = [
  {
    id: "obj",
    kind: "model",
    words: "OBJ",
    extensions: ["obj"],
    mediaType: "model/obj",
    names: (text) => all(text, /^[ \t]*mtllib[ \t](.+)$/gm),
    read: async ({ name, file, text, files, notes }) => (await import("./read-obj")).readObj(name, file.name, text(), files, notes),
  },
  {
    id: "off",
    kind: "model",
    words: "OFF",
    extensions: ["off"],
    mediaType: "model/vnd.off",
    is: ({ head }) => /^\s*(ST)?C?N?4?n?OFF\b/.test(head),
    read: async ({ name, text, notes }) => (await import("./read-off")).readOff(name, text(), notes),
  },
  {
    id: "ply",
    kind: "model",
    words: "PLY",
    extensions: ["ply"],
    mediaType: "model/ply",
    is: ({ head }) => /^ply\s/.test(head),
    read: async ({ name, file, notes }) => (await import("./read-ply")).readPly(name, file.bytes, notes),
  },
  {
    id: "stl",
    kind: "model",
    words: "STL",
    extensions: ["stl"],
    mediaType: "model/stl",
    read: async ({ name, file }) => (await import("./read-stl")).readStl(name, file.bytes),
  },
  {
    id: "gltf",
    kind: "model",
    words: "glTF",
    extensions: ["gltf"],
    mediaType: "model/gltf+json",
    names: (text) => all(text, /"uri"\s*:\s*"((?!data:|https?:)[^"]+)"/g).map(decodeUri),
    read: async ({ name, file, files, notes }) => (await import("./gltf/read")).readDocument(name, file, files, notes),
  },
  {
    id: "glb",
    kind: "model",
    words: "GLB",
    extensions: ["glb"],
    mediaType: "model/gltf-binary",
    is: ({ head }) => head.startsWith("glTF"),
    read: async ({ name, file, files, notes }) => (await import("./gltf/read")).readDocument(name, file, files, notes),
  },
];

const MOTIONS: readonly MotionFormat[] = [
  {
    id: "bvh",
    kind: "motion",
    words: "BVH",
    extensions: ["bvh"],
    mediaType: "text/plain",
    is: ({ text }) => /^\s*HIERARCHY\b/i.test(text),
    read: ({ name, text }) => ({ name, text }),
  },
  {
    id: "amc",
    kind: "motion",
    words: "AMC",
    extensions: ["amc"],
    mediaType: "text/plain",
    is: ({ text }) => /^[ \t]*:(fully-specified|degrees|radians)\b/im.test(text),
    skeleton: "asf",
    read: ({ name, text }, skeleton) => ({ name, text, skeleton: { name: skeleton.name, text: skeleton.text } }),
  },
];

const OTHERS: readonly Format[] = [
  {
    id: "asf",
    kind: "skeleton",
    words: "ASF",
    extensions: ["asf"],
    mediaType: "text/plain",
    is: ({ text }) => /^[ \t]*:bonedata\b/im.test(text),
  },
  { id: "json", kind: "project", words: "project.json", extensions: ["json"], mediaType: "application/json" },
  {
    id: "zip",
    kind: "archive",
    words: "saved project",
    extensions: ["rigless", "zip"],
    mediaType: "application/zip",
    is: ({ bytes }) => starts(bytes, 0, 0x50, 0x4b, 0x03, 0x04),
  },
  ...PICTURES,
  {
    id: "mtl",
    kind: "part",
    words: "MTL",
    extensions: ["mtl"],
    mediaType: "model/mtl",
    names: (text) => all(text, /^[ \t]*map_Kd[ \t](.+)$/gm).map((words) => words.split(/\s+/).at(-1) ?? ""),
  },
  { id: "bin", kind: "part", words: "BIN", extensions: ["bin"], mediaType: "application/octet-stream" },
];

export const FORMATS: readonly (ModelFormat | MotionFormat | Format)[] = [...MODELS, ...MOTIONS, ...OTHERS];

/** What a file is by its content, else by its name; null for what Rigless does not open. An archive says so or is none. */
export function formatOf({ name, bytes }: NamedFile): Format | null {
  const content: Content = {
    bytes,
    head: new TextDecoder("latin1").decode(bytes.subarray(0, 256)),
    text: decodeText(bytes.subarray(0, 65536)) ?? "",
  };
  const named = formatNamed(name);
  return FORMATS.find((format) => format.is?.(content)) ?? (named?.kind === "archive" ? null : named);
}

/** What a file should be by its name alone. */
export function formatNamed(path: string): Format | null {
  return FORMATS.find((format) => format.extensions.includes(extension(path))) ?? null;
}

export function modelFormat(file: NamedFile): ModelFormat | null {
  const format = formatOf(file);
  return MODELS.find((known) => known === format) ?? null;
}

export function motionFormat(file: NamedFile): MotionFormat | null {
  const format = formatOf(file);
  return MOTIONS.find((known) => known === format) ?? null;
}

/** "OBJ, OFF, PLY" as people call the formats of a kind; with `last`, "OBJ, OFF or PLY". */
export function listed(kind: FormatKind, last?: "and" | "or"): string {
  const words = FORMATS.filter((format) => format.kind === kind).map((format) => {
    const skeleton = "skeleton" in format ? FORMATS.find(({ id }) => id === format.skeleton) : undefined;
    return skeleton ? `${skeleton.words} with ${format.words}` : format.words;
  });
  return wordList(words, last);
}

/** What a dialog accepts that asks for files of these kinds: ".obj,.off". */
export function accepted(kinds: readonly FormatKind[]): string {
  return FORMATS.filter(({ kind }) => kinds.includes(kind))
    .flatMap(({ extensions }) => extensions.map((end) => `.${end}`))
    .join(",");
}
