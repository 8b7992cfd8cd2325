import type { GltfDocument, GltfNode } from "../../gltf/document";
import type { NamedJoint } from "../../sync/named-body";
import type { View } from "./view";
import { sceneNodes, worldMatrices } from "./world";

/** A joint of the skeleton that a file's mesh was posed by, in the world; its parent comes before it. */
export type Joint = NamedJoint;

/** The joints of all skins where the model stands, else the parts that it is made of, each with where it ends. */
export function jointsOf(document: GltfDocument, view: View): Joint[] {
  const { nodes = [], skins = [] } = document.json;
  const world = worldMatrices(document);
  const wanted = new Set(skins.flatMap(({ joints }) => joints));
  const parts = wanted.size > 0 ? null : partEnds(view);
  const shown = sceneNodes(document);
  const rank = new Map<number, number>();
  const parents = new Map(shown.flatMap((node) => (nodes[node].children ?? []).map((child) => [child, node] as const)));
  const joints: Joint[] = [];
  for (const node of shown) {
    const name = nodes[node].name ?? "";
    if (!(parts ? parts.has(node) : wanted.has(node))) continue;
    let above = parents.get(node);
    while (above !== undefined && !rank.has(above)) above = parents.get(above);
    const parent = above === undefined ? null : (rank.get(above) ?? null);
    const at = world[node];
    const position = [12, 13, 14].map((k) => at[k] - view.origin[k - 12]) as [number, number, number];
    rank.set(node, joints.push({ name, parent, position: parts?.get(node) ?? position }) - 1);
  }
  return joints;
}

/** By node that shows something: its vertex that is farthest from the middle of all. */
function partEnds({ drawn: { instances, positions } }: View): Map<number, [number, number, number]> {
  const middle = [0, 1, 2].map((k) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < positions.length; i += 3) [low, high] = [Math.min(low, positions[i]), Math.max(high, positions[i])];
    return (low + high) / 2;
  });
  const ends = new Map<number, { end: [number, number, number]; off: number }>();
  for (const { node, first, count } of instances) {
    for (let i = 3 * first; i < 3 * (first + count); i += 3) {
      const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
      const off = Math.hypot(x - middle[0], y - middle[1], z - middle[2]);
      if (off > (ends.get(node)?.off ?? -1)) ends.set(node, { end: [x, y, z], off });
    }
  }
  return new Map([...ends].map(([node, { end }]) => [node, end]));
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
