// A GLB with a skin: few joints under one that carries the whole body, as games want it. Core glTF 2.0.

import { dressBare } from "../gltf/bare";
import type { GltfNode } from "../gltf/document";
import type { BuiltSkin } from "../engine/types";
import type { DrawnInstance } from "../gltf/drawn";
import { ownOf, type Shape, Shapes, waysOf } from "./drawn-shape";
import { type NewMotion, packGlb, type Put, withGeometry } from "./gltf/write";
import { PoseTracks } from "./pose-tracks";
import { clipName, type GlbInput, keptClips, numbered } from "./write-glb";

/** Bytes of a file with so many render vertices and kept frames, about. */
export function skinnedBytes(vertices: number, kept: number): number {
  return 56 * vertices + 20 * 24 * kept;
}

/**
 * All clips move one skeleton: `skin` was made of their frames, one clip after the other.
 * Y up, facing +Z, in the model's own units; travel and turn are the root joint's. The file's own skin and clips make way.
 */
export function writeSkinned(
  { document, drawn, rest, clips, fps, scale, every, places, ...input }: GlbInput,
  skin: BuiltSkin,
): Uint8Array<ArrayBuffer> {
  const name = clipName(input.name);
  const shapes = new Shapes(drawn, rest, scale);
  const start = shapes.of(rest);
  const weights = wholeWeights(skin.weights);
  const bearing = skin.joints.map((joint, k) => (weights[k] > 0 ? joint : 0)); // as glTF wants it of what rounds to nothing
  const targets = Array.from({ length: skin.ways.length / rest.length }, (_, k) => targetOf(k));
  const primitives = drawn.instances.map((instance) => ({
    instance,
    index: drawn.index.slice(instance.from, instance.to).map((r) => r - instance.first),
    ...ownOf(start, instance),
    ...(targets.length > 0 && { targets: targets.map((target) => ownOf(target, instance)) }),
    skin: {
      joints: fours(bearing, drawn.toVertex, instance, (n) => new Uint8Array(n)),
      weights: fours(weights, drawn.toVertex, instance, (n) => new Uint16Array(n)),
    },
  }));
  const motion = (put: Put, node: number): NewMotion => {
    const count = skin.centres.length / 3;
    const centres = Array.from({ length: count }, (_, j) => [...skin.centres.subarray(3 * j, 3 * j + 3)].map((x) => x * scale));
    const names = namesOf(skin.centres, places);
    const root = node + 1;
    const joints = centres.map((_, j) => root + 1 + j);
    const nodes: GltfNode[] = [
      { name, mesh: 0, skin: 0 },
      { name: "root", children: joints },
      ...centres.map((translation, j) => ({ name: names[j], translation })),
    ];
    const inverse = new Float32Array(16 * count);
    centres.forEach((centre, j) => {
      for (let k = 0; k < 4; k++) inverse[16 * j + 5 * k] = 1;
      for (let k = 0; k < 3; k++) inverse[16 * j + 12 + k] = -centre[k];
    });
    const skins = [{ name, skeleton: root, joints, inverseBindMatrices: put(inverse, "MAT4") }];
    const animations = keptClips(clips, every).map(({ name, kept, from }) => {
      const tracks = new PoseTracks(name, put, kept, fps, scale);
      tracks.add(root, skin.roots, 7, 7 * from, [0, 0, 0]);
      centres.forEach((centre, j) => tracks.add(joints[j], skin.poses, 7 * count, 7 * (count * from + j), centre));
      if (targets.length > 0) tracks.mix(node, skin.mix, targets.length, targets.length * from);
      return tracks.animation();
    });
    return { nodes, roots: [node, root], skins, animations };
  };
  const mesh =
    targets.length > 0 ? { weights: targets.map(() => 0), extras: { targetNames: targets.map((_, k) => `shape_${k + 1}`) } } : {};
  return packGlb(withGeometry({ ...document, json: dressBare(document.json) }, { name, primitives, mesh, motion }));

  /** What joints do not hold, and how it turns normals at rest. */
  function targetOf(k: number): Shape {
    const ways = skin.ways.subarray(k * rest.length, (k + 1) * rest.length);
    const { normals } = shapes.of(rest.map((x, i) => x + ways[i]));
    const turned = normals && start.normals ? normals.map((x, i) => x - start.normals![i]) : null;
    return { positions: waysOf(drawn, skin.ways, rest.length / 3, k, scale), normals: turned };
  }
}

/** Sixteen bits each, and each four still sum to one. */
function wholeWeights(weights: Float32Array): Uint16Array {
  const out = Uint16Array.from(weights, (w) => Math.round(w * 65535));
  for (let v = 0; v < out.length; v += 4) {
    let heaviest = v;
    let left = 65535;
    for (let k = v; k < v + 4; k++) {
      left -= out[k];
      if (out[k] > out[heaviest]) heaviest = k;
    }
    out[heaviest] += left;
  }
  return out;
}

/** Four numbers for each vertex of one draw call. */
function fours<T extends Uint8Array | Uint16Array>(
  values: T,
  toVertex: Uint32Array,
  { first, count }: DrawnInstance,
  make: (length: number) => T,
): T {
  const out = make(4 * count);
  for (let r = 0; r < count; r++) for (let k = 0; k < 4; k++) out[4 * r + k] = values[4 * toVertex[first + r] + k];
  return out;
}

/** Each joint after the nearest place; those of one place are numbered. */
function namesOf(centres: Float32Array, places: GlbInput["places"]): string[] {
  const taken = new Map<string, number>([["root", 1]]);
  return Array.from({ length: centres.length / 3 }, (_, j) => {
    const away = ({ position }: GlbInput["places"][number]): number => Math.hypot(...position.map((x, k) => x - centres[3 * j + k]));
    const nearest = places.reduce<GlbInput["places"][number] | null>((a, b) => (a && away(a) <= away(b) ? a : b), null);
    return numbered(clipName(nearest?.name ?? "joint"), taken);
  });
}
