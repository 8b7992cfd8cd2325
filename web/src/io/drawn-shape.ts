// The surface as it is drawn, out of the surface as it is solved.

import type { Drawn, DrawnInstance } from "../gltf/drawn";
import { bindNormals, type NormalBinding, writeNormals } from "../gltf/surface-normals";

export interface Shape {
  /** N x 3. */
  positions: Float32Array;
  /** N x 3; null where faces are flat. */
  normals: Float32Array | null;
}

export class Shapes {
  private readonly binding: NormalBinding;

  /** `rest`: V x 3; `scale`: units that are written per unit of it. */
  constructor(
    private readonly drawn: Drawn,
    rest: Float32Array,
    private readonly scale: number,
  ) {
    this.binding = bindNormals(rest, drawn);
  }

  /** Of all R render vertices, for V x 3. */
  of(vertices: Float32Array): Shape {
    const { toVertex, positions } = this.drawn;
    const normals = new Float32Array(positions.length);
    writeNormals(this.binding, vertices, normals);
    const out = new Float32Array(3 * toVertex.length);
    toVertex.forEach((v, r) => {
      for (let k = 0; k < 3; k++) out[3 * r + k] = this.scale * vertices[3 * v + k];
    });
    return { positions: out, normals };
  }
}

/** R x 3: the way of each render vertex, of target k among ways over V, K x V x 3. */
export function waysOf({ toVertex }: Drawn, ways: Float32Array, vertices: number, k: number, scale: number): Float32Array {
  const from = 3 * vertices * k;
  const out = new Float32Array(3 * toVertex.length);
  toVertex.forEach((v, r) => {
    for (let axis = 0; axis < 3; axis++) out[3 * r + axis] = scale * ways[from + 3 * v + axis];
  });
  return out;
}

/** What of it one draw call shows. */
export function ownOf({ positions, normals }: Shape, { first, count, flat }: DrawnInstance): Shape {
  const own = (values: Float32Array): Float32Array => values.slice(3 * first, 3 * (first + count));
  return { positions: own(positions), normals: flat || !normals ? null : own(normals) };
}
