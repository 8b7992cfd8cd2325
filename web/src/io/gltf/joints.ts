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
  const pivotOf = (node: number): Place => [12, 13, 14].map((k) => world[node][k] - view.origin[k - 12]) as Place;
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

type Place = [number, number, number];

interface Part {
  base: Place;
  end: Place;
}

/**
 * By node that shows something: where it hangs, and its vertex that is farthest from the middle of all. It hangs on its pivot where
 * that is a hinge, in the part or beside it and no other's, and then ends at its other end; else its middle stands for that.
 */
function partEnds({ drawn: { instances, positions } }: View, pivotOf: (node: number) => Place): Map<number, Part> {
  const ranges = new Map<number, Range[]>();
  for (const { node, first, count } of instances) ranges.set(node, [...(ranges.get(node) ?? []), [3 * first, 3 * (first + count)]]);
  const middle = middleOf(boxOf(positions, [[0, positions.length]]));
  const pivots = [...ranges.keys()].map((node) => `${pivotOf(node)}`);
  return new Map(
    [...ranges].map(([node, own]) => {
      const box = boxOf(positions, own);
      const pivot = pivotOf(node);
      const alone = pivots.filter((other) => other === `${pivot}`).length === 1;
      if (!alone || !isBeside(pivot, box)) return [node, { base: middleOf(box), end: farthest(positions, own, middle) }];
      const reach = FAR * Math.hypot(...farthest(positions, own, pivot).map((x, k) => x - pivot[k]));
      return [node, { base: pivot, end: farthest(positions, own, middle, (i) => distance(positions, i, pivot) >= reach) }];
    }),
  );
}

type Range = readonly [from: number, to: number];
type Box = readonly [low: Place, high: Place];

const distance = (positions: Float32Array, i: number, from: Place): number =>
  Math.hypot(positions[i] - from[0], positions[i + 1] - from[1], positions[i + 2] - from[2]);

/** The vertex that is farthest from a place; `may`: of which. */
function farthest(positions: Float32Array, ranges: readonly Range[], from: Place, may = (_i: number): boolean => true): Place {
  let [best, off] = [0, -1];
  for (const [first, last] of ranges) {
    for (let i = first; i < last; i += 3) {
      const far = distance(positions, i, from);
      if (far > off && may(i)) [best, off] = [i, far];
    }
  }
  return placeOf(positions, best);
}

const placeOf = (positions: Float32Array, i: number): Place => [positions[i], positions[i + 1], positions[i + 2]];

/** Of the way from a hinge to the farthest vertex, what is the other end. */
const FAR = 0.85;

function isBeside(place: Place, [low, high]: Box): boolean {
  const slack = 0.1 * Math.hypot(...high.map((x, k) => x - low[k]));
  return place.every((x, k) => x > low[k] - slack && x < high[k] + slack);
}

function boxOf(positions: Float32Array, ranges: readonly Range[]): Box {
  const low: Place = [Infinity, Infinity, Infinity];
  const high: Place = [-Infinity, -Infinity, -Infinity];
  for (const [from, to] of ranges) {
    for (let i = from; i < to; i++) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
  }
  return [low, high];
}

const middleOf = ([low, high]: Box): Place => low.map((x, k) => (x + high[k]) / 2) as Place;

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
