// A model's geometry on the graphics card, and where a shape puts it. Two kinds: told vertex by vertex, or carried by nodes.

import type { BufferGeometry, Material, Mesh } from "three";
import type { Shape } from "../stage/port";

export interface Body {
  /** By instance of the model. */
  readonly geometries: readonly BufferGeometry[];
  /** The shape at rest. */
  readonly rest: Shape;
  /** Whether a shape is one of this model's. */
  takes(shape: Shape): boolean;
  /** Draws this shape from now on; it stays the caller's. */
  write(shape: Shape): void;
  /** Lets a mesh with its material be drawn as the shape says. */
  dress(mesh: Mesh): void;
  /** Places of vertices in a shape, 3 each. */
  places(shape: Shape, vertices: ArrayLike<number>, out: Float32Array): void;
  /** Where a shape lies, N x 3: enough of its places to stand and to be framed by. Kept until the next call. */
  outline(shape: Shape): Float32Array;
  /** The bare surface of the same model, for a shape of its own. */
  ghost(): GhostBody;
  dispose(): void;
}

export interface GhostBody {
  readonly geometry: BufferGeometry;
  write(shape: Shape): void;
  dress(material: Material): void;
  dispose(): void;
}
