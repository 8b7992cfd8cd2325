// The triangles of a primitive: lists, strips and fans alike.

import { accessorValues } from "../../gltf/accessors";
import type { GltfDocument, GltfPrimitive } from "../../gltf/document";
import { ModelError } from "../named-file";
import { count } from "../count";
import { trianglesIn } from "./check";

/**
 * T x 3 over the accessors' vertices, turned around for a mirrored node; empty for points and lines. Errors (ModelError): a corner
 * without its vertex.
 */
export function trianglesOf(name: string, document: GltfDocument, primitive: GltfPrimitive, mirrored: boolean): Uint32Array {
  const triangles = trianglesIn(document.json, primitive);
  const out = new Uint32Array(3 * triangles);
  if (triangles === 0) return out;
  const { mode = 4, indices } = primitive;
  const vertices = document.json.accessors?.[primitive.attributes.POSITION]?.count ?? 0;
  const named = indices === undefined ? null : accessorValues(document, indices);
  const at = (corner: number): number => {
    const vertex = named ? named[corner] : corner;
    if (vertex < vertices) return vertex;
    throw new ModelError(`${name}: a face names vertex ${vertex + 1}, but there are ${count(vertices, "vertex", "vertices")}.`);
  };
  for (let t = 0; t < triangles; t++) {
    const [a, b, c] =
      mode === 4 ? [3 * t, 3 * t + 1, 3 * t + 2] : mode === 6 ? [0, t + 1, t + 2] : t % 2 ? [t + 1, t, t + 2] : [t, t + 1, t + 2];
    out[3 * t] = at(a);
    out[3 * t + 1] = at(mirrored ? c : b);
    out[3 * t + 2] = at(mirrored ? b : c);
  }
  return out;
}
