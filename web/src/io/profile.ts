import type { BuildMorphs, BuildSkin, CallOptions } from "../engine/types";
import type { GlbInput } from "./write-glb";

/** How like the file is to the dance: rms and worst in diagonals of the model at rest, normals in radians (rms). */
export interface Likeness {
  readonly rms: number;
  readonly worst: number;
  readonly normals: number;
  /** Of either, how many hold it. */
  readonly joints?: number;
  readonly targets?: number;
}

export interface Written {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Null where kept frames are exact. */
  readonly likeness: Likeness | null;
}

/** What a profile may ask for beside the dance. */
export interface Tools extends CallOptions {
  readonly buildSkin: BuildSkin;
  readonly buildMorphs: BuildMorphs;
}

/** A larger file cannot be made in one piece, nor opened. */
export const GLB_BYTES = 2 ** 31;

/** A kind of file that a dance is exported as. profiles.ts is the table of them. */
export interface Profile {
  readonly id: string;
  /** As a button says it. */
  readonly name: string;
  /** How it holds the dance. */
  readonly words: string;
  /** Who opens it: "It opens in ...". */
  readonly worksIn: string;
  readonly extension: string;
  /** So many kept frames every viewer takes, with the reason beside it; null: any number. */
  readonly mostKept: number | null;
  /** A larger file is not begun. */
  readonly mostBytes: number;
  /** Bytes of a file with so many render vertices and kept frames, about. */
  readonly bytes: (vertices: number, kept: number) => number;
  readonly write: (input: GlbInput, tools: Tools) => Promise<Written>;
}
