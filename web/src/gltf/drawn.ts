// What of a document is drawn: its scene's triangles in the world, with the way back to where each comes from.

/** A primitive as one node shows it: one draw call. */
export interface DrawnInstance {
  readonly node: number;
  readonly mesh: number;
  readonly primitive: number;
  /** Its render vertices are [first, first + count). */
  readonly first: number;
  readonly count: number;
  /** Its corners are [from, to) of the index. */
  readonly from: number;
  readonly to: number;
  /** Which of the accessors' vertices each render vertex is; null: all of them, in order. */
  readonly vertices: Uint32Array | null;
  /** The file has no normals for it: faces are flat. */
  readonly flat: boolean;
  /** Some of its triangles show both sides, whatever the material says: the surface ends there, or it is wound both ways. */
  readonly open: boolean;
}

export interface Drawn {
  readonly instances: readonly DrawnInstance[];
  /** R x 3. */
  readonly positions: Float32Array;
  /** R x 3 unit normals; zeros where faces are flat. */
  readonly normals: Float32Array;
  /** F x 3 over R: triangle f is face f of the solver's surface. */
  readonly index: Uint32Array;
  /** R: solver vertex of each render vertex. */
  readonly toVertex: Uint32Array;
}
