import type { GltfDocument, GltfNode } from "../../gltf/document";
import type { NamedJoint } from "../../sync/named-body";
import { partEnds } from "./part-ends";
import type { View } from "./view";
import { sceneNodes, worldMatrices } from "./world";

export interface FileJoints {
  readonly joints: readonly NamedJoint[];
  /** By node: its own joint, or that of what it hangs on. */
  readonly ofNode: ReadonlyMap<number, number>;
}

/** The joints of all skins where the model stands, else the parts that it is made of, each with where it ends; parents come before. */
export function jointsOf(document: GltfDocument, view: View): FileJoints {
  const { nodes = [], skins = [] } = document.json;
  const world = worldMatrices(document);
  const wanted = new Set(skins.flatMap(({ joints }) => joints));
  const pivotOf = (node: number) => [12, 13, 14].map((k) => world[node][k] - view.origin[k - 12]) as [number, number, number];
  const parts = wanted.size > 0 ? null : partEnds(view, pivotOf);
  const shown = sceneNodes(document);
  const ofNode = new Map<number, number>();
  const parents = new Map(shown.flatMap((node) => (nodes[node].children ?? []).map((child) => [child, node] as const)));
  const joints: NamedJoint[] = [];
  for (const node of shown) {
    const name = nodes[node].name ?? "";
    const parent = ofNode.get(parents.get(node) ?? -1) ?? null;
    if (parent !== null) ofNode.set(node, parent);
    if (!(parts ? parts.has(node) : wanted.has(node))) continue;
    const part = parts?.get(node);
    const joint = joints.push({ name, parent, position: part?.base ?? pivotOf(node) }) - 1;
    ofNode.set(node, joint);
    if (part) joints.push({ name: `${name} end`, parent: joint, position: part.end });
  }
  return { joints, ofNode };
}

/** The document with a skin that nothing hangs on: joints keep their names, which say what stands there. */
export function withJoints(document: GltfDocument, joints: readonly NamedJoint[]): GltfDocument {
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
