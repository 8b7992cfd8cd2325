import type { GltfDocument, GltfNode } from "../../gltf/document";
import type { NamedJoint } from "../../sync/named-body";
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
  const parts = wanted.size > 0 ? null : partEnds(view);
  const shown = sceneNodes(document);
  const ofNode = new Map<number, number>();
  const parents = new Map(shown.flatMap((node) => (nodes[node].children ?? []).map((child) => [child, node] as const)));
  const joints: NamedJoint[] = [];
  for (const node of shown) {
    const name = nodes[node].name ?? "";
    const parent = ofNode.get(parents.get(node) ?? -1) ?? null;
    if (parent !== null) ofNode.set(node, parent);
    if (!(parts ? parts.has(node) : wanted.has(node))) continue;
    const at = world[node];
    const position = [12, 13, 14].map((k) => at[k] - view.origin[k - 12]) as [number, number, number];
    const part = parts?.get(node);
    const joint = joints.push({ name, parent, position: part?.middle ?? position }) - 1;
    ofNode.set(node, joint);
    if (part) joints.push({ name: `${name} end`, parent: joint, position: part.end });
  }
  return { joints, ofNode };
}

type Place = [number, number, number];

/** By node that shows something: its middle, and its vertex that is farthest from the middle of all. */
function partEnds({ drawn: { instances, positions } }: View): Map<number, { middle: Place; end: Place }> {
  const ranges = new Map<number, [from: number, to: number][]>();
  for (const { node, first, count } of instances) ranges.set(node, [...(ranges.get(node) ?? []), [3 * first, 3 * (first + count)]]);
  const middle = middleOf(positions, [[0, positions.length]]);
  const endOf = (own: readonly [number, number][]): Place => {
    let [best, off] = [0, -1];
    for (const [from, to] of own) {
      for (let i = from; i < to; i += 3) {
        const far = Math.hypot(positions[i] - middle[0], positions[i + 1] - middle[1], positions[i + 2] - middle[2]);
        if (far > off) [best, off] = [i, far];
      }
    }
    return [positions[best], positions[best + 1], positions[best + 2]];
  };
  return new Map([...ranges].map(([node, own]) => [node, { middle: middleOf(positions, own), end: endOf(own) }]));
}

function middleOf(positions: Float32Array, ranges: readonly [number, number][]): Place {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const [from, to] of ranges) {
    for (let i = from; i < to; i++) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
  }
  return [0, 1, 2].map((k) => (low[k] + high[k]) / 2) as Place;
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
