// Films and pictures of what stands on the stage: said by the app, drawn and encoded by the viewport.

import type { Standing } from "../util/standing";

/** What is seen at one moment, as the stage takes it. */
export interface Moment {
  readonly shape: Float32Array;
  /** Of whoever dances beside. */
  readonly companion?: {
    readonly shape: Float32Array;
    readonly standing: Standing;
    /** How far the model comes in a round, x and z. */
    readonly way: readonly [number, number];
  } | null;
  /** J x 3; null where there is no human. */
  readonly pose: Float32Array | null;
  /** The clip begins anew with this moment. */
  readonly again: boolean;
}

export interface Shot {
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** Without the human. */
  readonly alone: boolean;
  /** Nothing stands behind: the ground is seen through, and only shadows lie on it. */
  readonly clear: boolean;
  /** Of what is behind instead of the stage, as CSS has it; null for the stage's own. */
  readonly colour: string | null;
}

export interface FilmShot extends Shot {
  readonly kind: FilmKind;
  readonly frames: number;
  /** Frames per second. */
  readonly fps: number;
  /** How often the camera goes around while it lasts; 0: it stays where the person put it. */
  readonly turns: number;
  /** A song's file, which is heard from its beginning. */
  readonly song: Uint8Array | null;
}

export type FilmKind = "mp4" | "webm" | "gif";

export interface FilmCall {
  readonly signal: AbortSignal;
  /** Frames that are done. */
  onProgress(done: number): void;
}

export interface Studio {
  /** What this browser can make in such a size, the one that plays in most places first. */
  kinds(shot: Pick<Shot, "width" | "height">): Promise<readonly FilmKind[]>;
  /**
   * The bytes of a film, which plays at its pace however long a frame takes to draw; the stage shows nothing meanwhile and is as it was
   * afterwards. Rejects with the signal's reason, or with words to be shown.
   */
  film(shot: FilmShot, momentAt: (frame: number) => Promise<Moment>, call: FilmCall): Promise<Uint8Array<ArrayBuffer>>;
  /** A PNG from where the camera is. */
  picture(shot: Shot, moment: Moment): Promise<Uint8Array<ArrayBuffer>>;
}
