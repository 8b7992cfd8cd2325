// Limbs that touch the trunk stay limbs where the file says which joint moves what.

import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

import { buildSolid } from "../../src/engine/build-solid";
import type { GltfDocument } from "../../src/gltf/document";
import { buildDocument } from "../../src/io/gltf/build";
import { withJoints } from "../../src/io/gltf/joints";
import { Packer } from "../../src/io/gltf/packer";
import { modelOf } from "../../src/io/model";
import { parted } from "../../src/io/parted";
import type { NamedJoint } from "../../src/sync/named-body";

const bytes = readFileSync(new URL("../../src/engine/shape-analysis.wasm", import.meta.url));
const wasm = new Uint8Array(bytes).buffer;

type Place = [number, number, number];
const JOINTS: NamedJoint[] = (
  [
    ["Hips", null, [0, 1, 0]],
    ["Spine", 0, [0, 1.3, 0]],
    ["Head", 1, [0, 1.7, 0]],
    ["LeftArm", 1, [0.25, 1.5, 0]],
    ["LeftForeArm", 3, [0.25, 1.2, 0]],
    ["LeftHand", 4, [0.25, 0.9, 0]],
    ["RightArm", 1, [-0.25, 1.5, 0]],
    ["RightForeArm", 6, [-0.25, 1.2, 0]],
    ["RightHand", 7, [-0.25, 0.9, 0]],
    ["LeftUpLeg", 0, [0.1, 0.9, 0]],
    ["LeftLeg", 9, [0.1, 0.45, 0]],
    ["LeftFoot", 10, [0.1, 0.05, 0]],
    ["RightUpLeg", 0, [-0.1, 0.9, 0]],
    ["RightLeg", 12, [-0.1, 0.45, 0]],
    ["RightFoot", 13, [-0.1, 0.05, 0]],
  ] as [string, number | null, Place][]
).map(([name, parent, position]) => ({ name, parent, position }));

/** Rods and a trunk: arms dip into it all the way down. Each ring of a rod hangs on the joint next above it. */
const RODS: [middle: Place, half: Place, joints: number[]][] = [
  [[0, 1.3, 0], [0.24, 0.4, 0.15], [1]],
  [
    [0.25, 1.2, 0],
    [0.06, 0.36, 0.06],
    [3, 4, 5],
  ],
  [
    [-0.25, 1.2, 0],
    [0.06, 0.36, 0.06],
    [6, 7, 8],
  ],
  [
    [0.1, 0.48, 0],
    [0.08, 0.48, 0.08],
    [9, 10, 11],
  ],
  [
    [-0.1, 0.48, 0],
    [0.08, 0.48, 0.08],
    [12, 13, 14],
  ],
];

const RINGS = 12;
function rod([middle, half, own]: (typeof RODS)[number]): { positions: number[]; index: number[]; joints: number[] } {
  const positions: number[] = [];
  const joints: number[] = [];
  const index: number[] = [];
  for (let r = 0; r <= RINGS; r++) {
    const y = middle[1] - half[1] + (2 * half[1] * r) / RINGS;
    for (const [x, z] of [
      [1, 1],
      [1, -1],
      [-1, -1],
      [-1, 1],
    ]) {
      positions.push(middle[0] + x * half[0], y, middle[2] + z * half[2]);
      joints.push([...own].reverse().find((j) => JOINTS[j].position[1] >= y) ?? own[0]);
    }
    if (r === RINGS) continue;
    for (let k = 0; k < 4; k++) {
      const [a, b] = [4 * r + k, 4 * r + ((k + 1) % 4)];
      index.push(a, a + 4, b, b, a + 4, b + 4);
    }
  }
  const top = 4 * RINGS;
  index.push(0, 1, 2, 0, 2, 3, top, top + 2, top + 1, top, top + 3, top + 2);
  return { positions, index, joints };
}

/** As FBX and others are read. */
const built = (): GltfDocument => withJoints(buildDocument("figure.fbx", { parts: RODS.map(rod) }), JOINTS);

/** As a GLB has it: two weights for each vertex, the stronger one second. */
function skinned(): GltfDocument {
  const packer = new Packer();
  const primitives = RODS.map((one) => {
    const { positions, index, joints } = rod(one);
    return {
      attributes: {
        POSITION: packer.accessor(Float32Array.from(positions), "VEC3", { bounded: true }),
        JOINTS_0: packer.accessor(Uint16Array.from(joints.flatMap((j) => [0, j, 0, 0])), "VEC4", {}),
        WEIGHTS_0: packer.accessor(Float32Array.from(joints.flatMap(() => [0.4, 0.6, 0, 0])), "VEC4", {}),
      },
      indices: packer.accessor(Uint16Array.from(index), "SCALAR", {}),
    };
  });
  const childrenOf = (j: number): number[] => JOINTS.flatMap(({ parent }, child) => (parent === j ? [child + 1] : []));
  const moved = ({ position, parent }: NamedJoint): number[] =>
    position.map((x, k) => x - (parent === null ? 0 : JOINTS[parent].position[k]));
  const joints = JOINTS.map((joint, j) => {
    const children = childrenOf(j);
    return { name: joint.name, translation: moved(joint), ...(children.length > 0 && { children }) };
  });
  const away = JOINTS.flatMap(({ position: [x, y, z] }) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1]);
  const inverseBindMatrices = packer.accessor(Float32Array.from(away), "MAT4", {});
  const json = {
    asset: { version: "2.0" },
    scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0, skin: 0 }, ...joints],
    meshes: [{ primitives }],
    skins: [{ joints: JOINTS.map((_, j) => j + 1), inverseBindMatrices }],
    ...packer.json(),
  };
  return { json, buffers: [packer.bytes()], images: [] };
}

describe.each([
  ["built of another format", built],
  ["a GLB", skinned],
])("%s", (_, document) => {
  const model = parted(modelOf("figure.glb", document(), []));
  const parts = model.parts ?? new Int32Array(0);
  const at = (v: number): number[] => [...model.positions.subarray(3 * v, 3 * v + 3)];

  it("says of which limb each vertex is, and where that begins", () => {
    const of = (x: number, low: number, high: number): Set<number> =>
      new Set([...parts].filter((_part, v) => Math.abs(at(v)[0] - x) < 0.07 && at(v)[1] > low && at(v)[1] < high));
    const left = [...of(0.31, 0.8, 1.3)];
    expect(left).toHaveLength(1);
    expect(left[0]).toBeGreaterThan(0);
    expect(of(-0.31, 0.8, 1.3)).not.toEqual(new Set(left));
    expect(of(0.31, 1.45, 1.6)).toEqual(new Set([-left[0]]));
    const trunk = [...parts].filter((_part, v) => Math.abs(Math.abs(at(v)[0]) - 0.24) < 1e-4 && Math.abs(Math.abs(at(v)[2]) - 0.15) < 1e-4);
    expect(new Set(trunk)).toEqual(new Set([0]));
  });

  it("and the solid keeps them apart, but for where they begin", () => {
    /** Whether an arm hangs on the trunk between two heights, by nodes that lie there. */
    const hangsOn = (given: Int32Array | null, low: number, high: number): boolean => {
      const solid = buildSolid({ positions: model.positions, faces: model.faces, parts: given }, wasm);
      const nodesOf = (x: number): number[] =>
        [...solid.elementOf].flatMap((element, v) =>
          Math.abs(at(v)[0] - x) < 1e-4 ? [...solid.elements.subarray(8 * element, 8 * element + 8)] : [],
        );
      const lies = (node: number): boolean => solid.nodes[3 * node + 1] > low && solid.nodes[3 * node + 1] < high;
      const trunk = new Set(nodesOf(-0.24));
      const seen = new Set(nodesOf(0.31).filter(lies));
      for (const node of seen) {
        if (trunk.has(node)) return true;
        for (const other of solid.neighbors.subarray(solid.first[node], solid.first[node + 1])) if (lies(other)) seen.add(other);
      }
      return false;
    };
    expect(hangsOn(null, 1, 1.25)).toBe(true);
    expect(hangsOn(parts, 1, 1.25)).toBe(false);
    expect(hangsOn(parts, 1.4, 1.6)).toBe(true);
  });
});

it("names that tell no limbs give no parts", () => {
  const joints = JOINTS.map((joint, j) => ({ ...joint, name: `bone_${j}` }));
  const document = withJoints(buildDocument("figure.fbx", { parts: RODS.map(rod) }), joints);
  expect(parted(modelOf("figure.glb", document, [])).parts).toBeNull();
});
