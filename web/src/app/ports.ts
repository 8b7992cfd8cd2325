// What the app needs of the place it runs in: a page, or a test in Node.

import type { ProjectDocument } from "../document/types";
import type { Steps } from "../document/store";
import type { BuildMorphs, BuildSkin, Engine, MotionInput } from "../engine/types";
import type { FoundClip } from "../io/clips/found-clip";
import type { Model } from "../io/model";
import type { NamedFile } from "../io/named-file";

export type { StagePort } from "../stage/port";

/** What of a file that was dropped or chosen is read. */
export interface PickedFile {
  readonly name: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

export type FileKind = "any" | "model" | "motion" | "song";

export interface FilesPort {
  /** Asks for files; none if the person thinks better of it. */
  pick(kind: FileKind): Promise<readonly PickedFile[]>;
  /** Offers bytes as a download. */
  download(name: string, bytes: Uint8Array<ArrayBuffer>, type: string): void;
}

/** A model that comes with the page, with points and poses of its own. */
export interface Character {
  readonly id: string;
  readonly name: string;
  /** Its project, seen from the folder of the list. */
  readonly project: string;
  readonly vertices: number;
  readonly credit: string;
}

/** A motion that comes with the page. */
export interface Dance {
  readonly file: string;
  readonly name: string;
  readonly seconds: number;
}

/** The folder of what comes with the page. Paths are seen from it. */
export interface AssetsPort {
  readonly characters: readonly [Character, ...Character[]];
  readonly motions: readonly Dance[];
  readonly paths: readonly string[];
  /** For whoever shows a picture; null if there is none of this path. */
  address(path: string): string | null;
  /** Errors: it is not there, in words to be shown. */
  load(path: string): Promise<Uint8Array>;
}

export interface ClockPort {
  /** Calls once when the next picture is due, with the time in milliseconds; the answer calls it off. */
  nextFrame(call: (now: number) => void): () => void;
  /** Resolves when nothing more urgent is to be done. */
  idle(): Promise<void>;
}

/** A project that the browser keeps, as a list shows it. */
export interface KeptProject {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly changed: number;
  /** A small picture's data URL, or "". */
  readonly picture: string;
}

/** A song as it was dropped. */
export interface KeptSong {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly muted: boolean;
}

/** A song that can be heard. */
export interface Sound {
  readonly seconds: number;
  readonly playing: boolean;
  /** Seconds. */
  readonly at: number;
  play(at: number, speed: number): void;
  stop(): void;
  close(): void;
}

/** Everything of a project: what was done in it, whoever left its stage, and the files that all of them name. */
export interface KeptWork extends KeptProject {
  /** Of the document's format. */
  readonly version: number;
  readonly steps: Steps;
  readonly away: readonly ProjectDocument[];
  /** Each model's own file first, named as documents name it. */
  readonly models: readonly (readonly NamedFile[])[];
  readonly motions: readonly { readonly files: readonly string[]; readonly input: MotionInput }[];
  /** Left out by older pages. */
  readonly song?: KeptSong | null;
}

/** What the browser keeps between visits. Errors: its storage is full, or turned off. */
export interface ShelfPort {
  /** Newest first. */
  list(): Promise<readonly KeptProject[]>;
  load(id: string): Promise<KeptWork | null>;
  put(work: KeptWork): Promise<void>;
  remove(id: string): Promise<void>;
  /** The id of a new project, which this page has for itself. */
  begin(): Promise<string>;
  /** Has a project for this page alone until `release`, or until the page is gone; false if another page has it. */
  claim(id: string): Promise<boolean>;
  release(): void;
}

/** What a page remembers at once, before anything is loaded. */
export interface MemoryPort {
  /** The project that this page works on, also after a reload. */
  project: string | null;
  /** The project that is being opened: one that takes the page with it is not opened again by itself. */
  opening: string | null;
  /** Something is on the shelf. */
  kept: boolean;
}

/** Where the page is. */
export interface AddressPort {
  /** What stands behind the "#". */
  readonly link: string;
  /** Leaves that out from now on. */
  forget(): void;
}

export interface Ports {
  readonly address: AddressPort;
  readonly files: FilesPort;
  readonly assets: AssetsPort;
  readonly clock: ClockPort;
  readonly memory: MemoryPort;
  /** Loaded with the first thing to keep. */
  readonly openShelf: () => Promise<ShelfPort>;
  /** Errors: this browser cannot decode it. */
  readonly openSound: (bytes: Uint8Array) => Promise<Sound>;
  readonly createEngine: () => Engine;
  /** As io/read-model, wherever it runs. Errors: ModelError; on abort the signal's reason. */
  readonly readModel: (
    files: readonly NamedFile[],
    options?: { signal?: AbortSignal; onProgress?: (done: number) => void },
  ) => Promise<Model>;
  /** As io/clips/read-clips, likewise. */
  readonly readClips: (
    files: readonly NamedFile[],
    options?: { signal?: AbortSignal; onProgress?: (done: number) => void },
  ) => Promise<FoundClip[]>;
  /** As engine/build-skin.ts, wherever it runs. */
  readonly buildSkin: BuildSkin;
  readonly buildMorphs: BuildMorphs;
  /** Nothing begins to move by itself. */
  readonly calm: boolean;
}
