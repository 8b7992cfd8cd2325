import type { GlbInput } from "./write-glb";

/** A kind of file that a dance is exported as. profiles.ts is the table of them. */
export interface Profile {
  readonly id: string;
  /** How it holds the dance. */
  readonly words: string;
  readonly extension: string;
  /** So many kept frames every viewer takes, with the reason beside it; null: any number. */
  readonly mostKept: number | null;
  /** Bytes of a file with so many render vertices and kept frames, about. */
  readonly bytes: (vertices: number, kept: number) => number;
  readonly write: (input: GlbInput) => Uint8Array<ArrayBuffer> | Promise<Uint8Array<ArrayBuffer>>;
}
