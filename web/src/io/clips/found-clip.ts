import type { FoundMotion } from "../read-motion-files";

/** A motion that a file holds among others. */
export interface FoundClip {
  /** Without what all clips of the file are called. */
  readonly name: string;
  readonly seconds: number;
  readonly motion: FoundMotion;
}
