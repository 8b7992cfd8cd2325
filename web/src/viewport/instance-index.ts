import { BufferAttribute } from "three";
import type { Drawn, DrawnInstance } from "../gltf/drawn";

/** An instance's corners, counted from its first render vertex. */
export function instanceIndex({ index }: Drawn, { first, from, to }: DrawnInstance): BufferAttribute {
  const own = index.slice(from, to);
  for (let c = 0; first > 0 && c < own.length; c++) own[c]! -= first;
  return new BufferAttribute(own, 1);
}
