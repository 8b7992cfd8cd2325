// A primitive's vertices in the world, in double: shape keys, then the skeleton or the node.

import { accessorValues } from "../../gltf/accessors";
import type { GltfDocument, GltfNode, GltfPrimitive } from "../../gltf/document";
import { isMirror, type Matrix, multiply, normalMatrix } from "./world";

type Values = Float32Array | Float64Array;

export interface Posed {
  /** N x 3. */
  readonly positions: Float64Array;
  /** N x 3, of any length; null where the file has none. */
  readonly normals: Float64Array | null;
  /** Its triangles turn around. */
  readonly mirrored: boolean;
}

/** `matrix`: the node's own; a skinned primitive stands where its joints are. */
export function posed(document: GltfDocument, node: GltfNode, primitive: GltfPrimitive, matrix: Matrix, world: readonly Matrix[]): Posed {
  const positions = morphed(document, node, primitive, "POSITION");
  const normals = primitive.attributes.NORMAL === undefined ? null : morphed(document, node, primitive, "NORMAL");
  const skin = skinOf(document, node, primitive, world);
  if (skin) return skinned(positions, normals, skin);
  const turn = normalMatrix(matrix);
  for (let i = 0; i < positions.length; i += 3) {
    place(matrix, positions[i], positions[i + 1], positions[i + 2], 1, positions, i);
    if (normals) rotate(turn, normals[i], normals[i + 1], normals[i + 2], 1, normals, i);
  }
  return { positions, normals, mirrored: isMirror(matrix) };
}

/** A copy of an attribute with its node's, else its mesh's, shape keys at their weights. */
function morphed(document: GltfDocument, node: GltfNode, { attributes, targets = [] }: GltfPrimitive, key: string): Float64Array {
  const out = Float64Array.from(accessorValues(document, attributes[key]));
  const weights = node.weights ?? document.json.meshes?.[node.mesh ?? -1]?.weights ?? [];
  targets.forEach((target, t) => {
    const weight = Number(weights[t] ?? 0);
    if (!weight || target[key] === undefined) return;
    const deltas = accessorValues(document, target[key]);
    for (let i = 0; i < out.length; i++) out[i] += weight * deltas[i];
  });
  return out;
}

interface Skin {
  readonly sets: readonly { readonly joints: Values; readonly weights: Values }[];
  /** From the mesh at bind time to the world, by joint. */
  readonly bones: readonly Matrix[];
  readonly turns: readonly Matrix[];
}

/** Null if the node has no skin, or its vertices no weights. */
function skinOf(document: GltfDocument, node: GltfNode, { attributes }: GltfPrimitive, world: readonly Matrix[]): Skin | null {
  const skin = node.skin === undefined ? undefined : document.json.skins?.[node.skin];
  const sets = Object.keys(attributes).flatMap((key) => {
    const weights = attributes[key.replace("JOINTS", "WEIGHTS")];
    if (!key.startsWith("JOINTS_") || weights === undefined) return [];
    return [{ joints: accessorValues(document, attributes[key]), weights: accessorValues(document, weights) }];
  });
  if (!skin || sets.length === 0) return null;
  const inverse = skin.inverseBindMatrices === undefined ? null : accessorValues(document, skin.inverseBindMatrices);
  const bones = skin.joints.map((joint, j) =>
    inverse ? multiply(world[joint], Array.from(inverse.subarray(16 * j, 16 * j + 16))) : world[joint],
  );
  return { sets, bones, turns: bones.map(normalMatrix) };
}

/** Linear blend skinning, in place. */
function skinned(positions: Float64Array, normals: Float64Array | null, { sets, bones, turns }: Skin): Posed {
  for (let v = 0; v < positions.length / 3; v++) {
    const i = 3 * v;
    const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
    const [nx, ny, nz] = normals ? [normals[i], normals[i + 1], normals[i + 2]] : [0, 0, 0];
    positions.fill(0, i, i + 3);
    normals?.fill(0, i, i + 3);
    for (const { joints, weights } of sets) {
      for (let k = 4 * v; k < 4 * v + 4; k++) {
        const w = weights[k];
        const bone = bones[joints[k]];
        if (!w || !bone) continue;
        place(bone, x, y, z, w, positions, i, true);
        if (normals) rotate(turns[joints[k]], nx, ny, nz, w, normals, i, true);
      }
    }
  }
  return { positions, normals, mirrored: bones[0] !== undefined && isMirror(bones[0]) };
}

function place(m: Matrix, x: number, y: number, z: number, weight: number, out: Float64Array, at: number, add = false): void {
  for (let k = 0; k < 3; k++) out[at + k] = (add ? out[at + k] : 0) + weight * (m[k] * x + m[k + 4] * y + m[k + 8] * z + m[k + 12]);
}

function rotate(m: Matrix, x: number, y: number, z: number, weight: number, out: Float64Array, at: number, add = false): void {
  for (let k = 0; k < 3; k++) out[at + k] = (add ? out[at + k] : 0) + weight * (m[k] * x + m[k + 3] * y + m[k + 6] * z);
}
