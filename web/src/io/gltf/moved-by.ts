// Which joint moves each vertex most: of the weights that a file brings that alone is kept.

import { accessorValues } from "../../gltf/accessors";
import type { GltfDocument, GltfPrimitive } from "../../gltf/document";
import type { FileJoints } from "./joints";
import { STRONGEST } from "./strongest";
import type { View } from "./view";

/** V: of the joints; -1 where none does. */
export function movedBy(document: GltfDocument, { drawn, positions }: View, { ofNode }: Pick<FileJoints, "ofNode">): Int32Array {
  const { nodes = [], meshes = [], skins = [] } = document.json;
  const out = new Int32Array(positions.length / 3).fill(-1);
  for (const { node, mesh, primitive, first, count, vertices } of drawn.instances) {
    const strongest = strongestOf(document, meshes[mesh].primitives[primitive]);
    const { skin } = nodes[node];
    // What was built of another format names joints of the one skin, on which no node hangs.
    const joints = strongest ? (skins[skin ?? 0]?.joints ?? []) : [];
    for (let r = 0; r < count; r++) {
      const mover = strongest ? joints[strongest[vertices ? vertices[r] : r]] : node;
      out[drawn.toVertex[first + r]] = ofNode.get(mover) ?? -1;
    }
  }
  return out;
}

/** By vertex of a primitive, of its skin's joints; null where it has no weights. */
function strongestOf(document: GltfDocument, { attributes }: GltfPrimitive): Int32Array | null {
  if (attributes[STRONGEST] !== undefined) return Int32Array.from(accessorValues(document, attributes[STRONGEST]));
  let out: Int32Array | null = null;
  let most: Float64Array | null = null;
  for (const key of Object.keys(attributes)) {
    const weighed = attributes[key.replace("JOINTS", "WEIGHTS")];
    if (!key.startsWith("JOINTS_") || weighed === undefined) continue;
    const joints = accessorValues(document, attributes[key]);
    const weights = accessorValues(document, weighed);
    out ??= new Int32Array(joints.length / 4).fill(-1);
    most ??= new Float64Array(joints.length / 4);
    for (let k = 0; k < joints.length; k++) {
      const v = k >> 2;
      if (weights[k] > most[v]) [out[v], most[v]] = [joints[k], weights[k]];
    }
  }
  return out;
}
