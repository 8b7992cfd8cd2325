/** "+x" and so on: an axis of the file. */
export type Axis = `${"+" | "-"}${"x" | "y" | "z"}`;

export interface HostileModel {
  name: string;
  /** What is odd about it. */
  what: string;
  format: "obj" | "glb";
  /** V x 3. */
  positions: Float64Array;
  /** F x 3 over V. */
  faces: Uint32Array;
  /** Runs of faces. */
  parts: { name: string; first: number; count: number; material?: number }[];
  materials?: { color?: number[]; png?: Uint8Array }[];
  truth: {
    up: Axis;
    /** null: it has none. */
    front: Axis | null;
    /** Where limbs end, in the file's coordinates. */
    limbs: Record<string, [number, number, number]>;
  };
}

/** Each makes its model anew, the same each time; by name. */
export const HOSTILE: Readonly<Record<string, () => HostileModel>>;
export function objText(model: HostileModel): string;
export function glbBytes(model: HostileModel): Uint8Array;
/** Writes those whose name matches; gives rows for the table. */
export function writeHostile(
  folder: string,
  wanted: RegExp,
): { name: string; what: string; path: string; truth: { up: string; front: string | null } }[];
