// What the app needs of the place it runs in: a page, or a test in Node.

import type { Engine } from "../engine/types";
import type { Model } from "../io/model";
import type { NamedFile } from "../io/named-file";

export type { StagePort } from "../stage/port";

/** What of a file that was dropped or chosen is read. */
export interface PickedFile {
  readonly name: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

export type FileKind = "any" | "model" | "motion";

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

export interface Ports {
  readonly files: FilesPort;
  readonly assets: AssetsPort;
  readonly clock: ClockPort;
  readonly createEngine: () => Engine;
  /** As io/read-model, wherever it runs. Errors: ModelError; on abort the signal's reason. */
  readonly readModel: (files: readonly NamedFile[], options?: { signal?: AbortSignal }) => Promise<Model>;
  /** Nothing begins to move by itself. */
  readonly calm: boolean;
}
