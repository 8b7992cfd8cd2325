// Every kind of file that Rigless opens: one row each. File dialogs, drops, the command line, the readers and the sentences about
// them read this table, and a test holds README and docs to it. A new format is a row here and a reader in
// readers.ts.

import type { MotionInput } from "../engine/types";
import { type Content, type Format, type FormatKind, starts, wordList } from "./format";
import { decodeText, decodeUri, extension, type NamedFile } from "./named-file";
import { fbxPictures, isArchiveStartingWith, isArchiveWith } from "./peek";
import { PICTURES } from "./picture";

/** Its reader is in readers.ts, which the page does not load. */
export interface ModelFormat extends Format {
  readonly kind: "model";
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

const gltfNames = (text: string): string[] => all(text, /"uri"\s*:\s*"((?!data:|https?:)[^"]+)"/g).map(decodeUri);

/** Its first chunk. */
function glbText(bytes: Uint8Array): string {
  const size = bytes.length < 20 ? 0 : new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  return new TextDecoder().decode(bytes.subarray(20, 20 + size));
}

const MODELS = [
  {
    id: "obj",
    kind: "model",
    words: "OBJ",
    extensions: ["obj"],
    mediaType: "model/obj",
    names: (text) => all(text, /^[ \t]*mtllib[ \t](.+)$/gm),
  },
  {
    id: "off",
    kind: "model",
    words: "OFF",
    extensions: ["off"],
    mediaType: "model/vnd.off",
    is: ({ head }) => /^\s*(ST)?C?N?4?n?OFF\b/.test(head),
  },
  { id: "ply", kind: "model", words: "PLY", extensions: ["ply"], mediaType: "model/ply", is: ({ head }) => /^ply\s/.test(head) },
  { id: "stl", kind: "model", words: "STL", extensions: ["stl"], mediaType: "model/stl" },
  { id: "gltf", kind: "model", words: "glTF", extensions: ["gltf"], mediaType: "model/gltf+json", clips: true, names: gltfNames },
  {
    id: "glb",
    kind: "model",
    words: "GLB",
    extensions: ["glb", "vrm", "vrma"],
    mediaType: "model/gltf-binary",
    clips: true,
    is: ({ head }) => head.startsWith("glTF"),
    names: gltfNames,
    text: glbText,
  },
  {
    id: "fbx",
    kind: "model",
    words: "FBX",
    extensions: ["fbx"],
    mediaType: "application/octet-stream",
    clips: true,
    is: ({ head, text }) => head.startsWith("Kaydara FBX Binary") || /^(;.*\s+)*FBXHeaderExtension\b/.test(text),
    names: (text) => all(text, /RelativeFilename:[ \t]*"([^"\r\n]+)"/g),
    text: (bytes) => decodeText(bytes) ?? fbxPictures(bytes),
  },
  {
    id: "dae",
    kind: "model",
    words: "DAE",
    extensions: ["dae"],
    mediaType: "model/vnd.collada+xml",
    is: ({ text }) => /<COLLADA\b/.test(text.slice(0, 2048)),
    names: (text) => all(text, /<init_from>([^<\r\n]+)<\/init_from>/g).map(decodeUri),
  },
  {
    id: "3mf",
    kind: "model",
    words: "3MF",
    extensions: ["3mf"],
    mediaType: "model/3mf",
    is: ({ bytes }) => isArchiveWith(bytes, /3D\/[^/]*\.model/),
  },
  {
    id: "usd",
    kind: "model",
    words: "USDZ",
    extensions: ["usdz", "usda", "usdc", "usd"],
    mediaType: "model/vnd.usdz+zip",
    is: ({ bytes, head }) => /^(#usda|PXR-USDC)/.test(head) || isArchiveStartingWith(bytes, /\.usd[ac]?$/i),
    names: (text) => all(text, /@([^@\r\n]+\.(?:png|jpe?g|webp|bmp|tga))@/gi),
  },
] as const satisfies readonly ModelFormat[];

export type ModelId = (typeof MODELS)[number]["id"];

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
    names: (text) => all(text, /^[ \t]*(?:map_\w+|bump|norm)[ \t](.+)$/gim).map((words) => words.split(/\s+/).at(-1) ?? ""),
  },
  { id: "mp3", kind: "song", words: "MP3", extensions: ["mp3"], mediaType: "audio/mpeg" },
  { id: "ogg", kind: "song", words: "OGG", extensions: ["ogg", "oga", "opus"], mediaType: "audio/ogg" },
  { id: "wav", kind: "song", words: "WAV", extensions: ["wav"], mediaType: "audio/wav" },
  { id: "m4a", kind: "song", words: "M4A", extensions: ["m4a", "aac"], mediaType: "audio/mp4" },
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

export function modelFormat(file: NamedFile): (typeof MODELS)[number] | null {
  const format = formatOf(file);
  return MODELS.find((known) => known === format) ?? null;
}

export function motionFormat(file: NamedFile): MotionFormat | null {
  const format = formatOf(file);
  return MOTIONS.find((known) => known === format) ?? null;
}

/** Whether files of a format can be used as a kind. */
const serves = (format: Format, kind: FormatKind): boolean => format.kind === kind || (kind === "motion" && format.clips === true);

/** "OBJ, OFF, PLY" as people call the formats of a kind; with `last`, "OBJ, OFF or PLY". */
export function listed(kind: FormatKind, last?: "and" | "or"): string {
  const own = FORMATS.filter((format) => format.kind === kind);
  const words = [...own, ...FORMATS.filter((format) => serves(format, kind) && !own.includes(format))].map((format) => {
    const skeleton = "skeleton" in format ? FORMATS.find(({ id }) => id === format.skeleton) : undefined;
    return skeleton ? `${skeleton.words} with ${format.words}` : format.words;
  });
  return wordList(words, last);
}

/** What a dialog accepts that asks for files of these kinds: ".obj,.off". */
export function accepted(kinds: readonly FormatKind[]): string {
  return FORMATS.filter((format) => kinds.some((kind) => serves(format, kind)))
    .flatMap(({ extensions }) => extensions.map((end) => `.${end}`))
    .join(",");
}
