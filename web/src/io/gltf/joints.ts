import type { GltfDocument, GltfNode } from "../../gltf/document";

/** A joint of the skeleton that a file's mesh was posed by. */
export interface Joint {
  readonly name: string;
  /** Of the joints, before this one; null for a root. */
  readonly parent: number | null;
  /** In the world. */
  readonly position: readonly [number, number, number];
}

/** The document with a skin that nothing hangs on: joints keep their names, which say what stands there. */
export function withJoints(document: GltfDocument, joints: readonly Joint[]): GltfDocument {
  if (joints.length === 0) return document;
  const { json } = document;
  const before = json.nodes ?? [];
  const roots: number[] = [];
  const nodes = joints.map(({ name, parent, position }): GltfNode & { children: number[] } => {
    const from = parent === null ? [0, 0, 0] : joints[parent].position;
    return { name, translation: position.map((x, k) => x - from[k]), children: [] };
  });
  joints.forEach(({ parent }, j) => (parent === null ? roots : nodes[parent].children).push(before.length + j));
  const [scene, ...scenes] = json.scenes ?? [];
  return {
    ...document,
    json: {
      ...json,
      nodes: [...before, ...nodes.map(({ children, ...node }) => (children.length > 0 ? { ...node, children } : node))],
      skins: [{ joints: nodes.map((_, j) => before.length + j) }],
      scenes: [{ ...scene, nodes: [...(scene?.nodes ?? []), ...roots] }, ...scenes],
    },
  };
}
