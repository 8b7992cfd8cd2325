import { BufferAttribute } from "three";
import type { Drawn, DrawnInstance } from "../gltf/drawn";

/** An instance's corners, counted from its first render vertex. */
export function instanceIndex({ index }: Drawn, { first, from, to }: DrawnInstance): BufferAttribute {
  const own = index.subarray(from, to);
  return new BufferAttribute(first === 0 ? own : own.map((r) => r - first), 1);
}
