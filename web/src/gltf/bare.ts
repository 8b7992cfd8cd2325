// Clay for what has no material: without one glTF means white metal, which nobody who made a plain shape has in mind.

import type { Gltf, GltfMaterial, GltfPrimitive } from "./document";

/** #e4d2bf as linear light. */
const CLAY = [0.7758, 0.6445, 0.521, 1];

const matt = (name: string, baseColorFactor?: number[]): GltfMaterial => ({
  name,
  pbrMetallicRoughness: { ...(baseColorFactor && { baseColorFactor }), metallicFactor: 0, roughnessFactor: 0.8 },
  doubleSided: true,
});

/** The same JSON with a material for each primitive that has none: its own colours, or clay. */
export function dressBare(json: Gltf): Gltf {
  const { meshes = [], materials = [] } = json;
  const isBare = ({ material }: GltfPrimitive): boolean => material === undefined;
  const isColoured = ({ attributes }: GltfPrimitive): boolean => attributes.COLOR_0 !== undefined;
  const bare = meshes.flatMap(({ primitives }) => primitives.filter(isBare));
  if (bare.length === 0) return json;
  const clay = bare.every(isColoured) ? [] : [matt("clay", CLAY)];
  const coloured = bare.some(isColoured) ? [matt("colours")] : [];
  const materialOf = (primitive: GltfPrimitive): number => materials.length + (isColoured(primitive) ? clay.length : 0);
  return {
    ...json,
    materials: [...materials, ...clay, ...coloured],
    meshes: meshes.map((mesh) => ({
      ...mesh,
      primitives: mesh.primitives.map((primitive) => ({ ...primitive, material: primitive.material ?? materialOf(primitive) })),
    })),
  };
}
