// What a file that holds clips is to the sampler, whatever format it came in.

import type { AnimationClip, Object3D } from "three";

/** A tree of joints and others, at rest, and the clips that move it. */
export interface MovingTree {
  readonly tree: Object3D;
  /** What a unit of the tree is long. */
  readonly metres: number;
  readonly clips: readonly AnimationClip[];
  /** What the file calls an object. */
  readonly nameOf: (object: Object3D) => string;
}
