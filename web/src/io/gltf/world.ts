// Where the nodes of a document stand: 4 x 4 matrices by column, in double.

import { accessorValues } from "../../gltf/accessors";
import type { GltfDocument, GltfNode } from "../../gltf/document";

export type Matrix = readonly number[];

/** By node. One with two parents, which glTF forbids, follows the first. */
export function worldMatrices({ json: { nodes = [] } }: GltfDocument): Matrix[] {
  const parent = new Int32Array(nodes.length).fill(-1);
  nodes.forEach(({ children = [] }, n) => {
    for (const child of children) if (parent[child] < 0) parent[child] = n;
  });
  const world: Matrix[] = new Array<Matrix>(nodes.length);
  for (let node = 0; node < nodes.length; node++) {
    const path: number[] = [];
    for (let n = node; n >= 0 && !world[n]; n = parent[n]) path.push(n);
    for (const n of path.reverse()) world[n] = parent[n] < 0 ? localMatrix(nodes[n]) : multiply(world[parent[n]], localMatrix(nodes[n]));
  }
  return world;
}

/** The nodes of the scene that is shown, each before its children; all that are nobody's child where there is no scene. */
export function sceneNodes({ json: { nodes = [], scenes = [], scene = 0 } }: GltfDocument): number[] {
  const inner = new Set(nodes.flatMap(({ children = [] }) => children));
  const roots = scenes.length > 0 ? (scenes[scene]?.nodes ?? []) : nodes.flatMap((_, n) => (inner.has(n) ? [] : [n]));
  const seen = new Uint8Array(nodes.length);
  const order: number[] = [];
  const stack = [...roots].reverse();
  for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
    if (seen[node]) continue;
    seen[node] = 1;
    order.push(node);
    const { children = [] } = nodes[node];
    for (let k = children.length - 1; k >= 0; k--) stack.push(children[k]);
  }
  return order;
}

/** A node's own places of what it shows: one, or those that EXT_mesh_gpu_instancing lists. */
export function instanceMatrices(document: GltfDocument, node: GltfNode, world: Matrix): Matrix[] {
  const extension = node.extensions?.["EXT_mesh_gpu_instancing"] as { attributes?: Record<string, number> } | undefined;
  const read = (key: string, width: number): ArrayLike<number> | null => {
    const index = extension?.attributes?.[key];
    const accessor = index === undefined ? undefined : document.json.accessors?.[index];
    if (index === undefined || accessor?.type !== `VEC${width}`) return null;
    return accessorValues(document, index);
  };
  const [translation, rotation, scale] = [read("TRANSLATION", 3), read("ROTATION", 4), read("SCALE", 3)];
  const counts = [translation && translation.length / 3, rotation && rotation.length / 4, scale && scale.length / 3];
  const known = counts.filter((n) => n !== null);
  if (known.length === 0) return [world];
  const part = (values: ArrayLike<number> | null, width: number, i: number): number[] | undefined =>
    values ? Array.from({ length: width }, (_, k) => values[width * i + k]) : undefined;
  return Array.from({ length: Math.min(...known) }, (_, i) =>
    multiply(world, compose(part(translation, 3, i), part(rotation, 4, i), part(scale, 3, i))),
  );
}

function localMatrix({ matrix, translation, rotation, scale }: GltfNode): Matrix {
  return matrix ?? compose(translation, rotation, scale);
}

function compose([px, py, pz]: Matrix = [0, 0, 0], [x, y, z, w]: Matrix = [0, 0, 0, 1], [sx, sy, sz]: Matrix = [1, 1, 1]): Matrix {
  const [x2, y2, z2] = [x + x, y + y, z + z];
  return [
    (1 - (y * y2 + z * z2)) * sx,
    (x * y2 + w * z2) * sx,
    (x * z2 - w * y2) * sx,
    0,
    (x * y2 - w * z2) * sy,
    (1 - (x * x2 + z * z2)) * sy,
    (y * z2 + w * x2) * sy,
    0,
    (x * z2 + w * y2) * sz,
    (y * z2 - w * x2) * sz,
    (1 - (x * x2 + y * y2)) * sz,
    0,
    px,
    py,
    pz,
    1,
  ];
}

export function multiply(a: Matrix, b: Matrix): Matrix {
  const out = new Array<number>(16);
  for (let c = 0; c < 16; c += 4) {
    for (let r = 0; r < 4; r++) out[c + r] = b[c] * a[r] + b[c + 1] * a[4 + r] + b[c + 2] * a[8 + r] + b[c + 3] * a[12 + r];
  }
  return out;
}

/** What turns a surface's normals where `m` turns its points, without length: the inverse transposed, 3 x 3 by column. */
export function normalMatrix(m: Matrix): Matrix {
  const sign = isMirror(m) ? -1 : 1;
  const cofactor = (a: number, b: number, c: number, d: number): number => sign * (m[a] * m[b] - m[c] * m[d]);
  return [
    cofactor(5, 10, 9, 6),
    cofactor(8, 6, 4, 10),
    cofactor(4, 9, 8, 5),
    cofactor(9, 2, 1, 10),
    cofactor(0, 10, 8, 2),
    cofactor(8, 1, 0, 9),
    cofactor(1, 6, 5, 2),
    cofactor(4, 2, 0, 6),
    cofactor(0, 5, 4, 1),
  ];
}

export function isMirror(m: Matrix): boolean {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) + m[8] * (m[1] * m[6] - m[5] * m[2]) < 0;
}
