// A GLB with few morph targets that are mixed, for squash that joints cannot hold; the whole body's motion is its node's. Core glTF 2.0.

import { dressBare } from "../gltf/bare";
import type { BuiltMorphs } from "../engine/types";
import { ownOf, type Shape, Shapes, waysOf } from "./drawn-shape";
import { type NewMotion, packGlb, type Put, withGeometry } from "./gltf/write";
import { PoseTracks } from "./pose-tracks";
import { clipName, type GlbInput, keptClips } from "./write-glb";

/** So many every viewer keeps in memory. */
export const MOST_TARGETS = 32;

/** Bytes of a file with so many render vertices and kept frames, about. */
export function morphsBytes(vertices: number, kept: number): number {
  const targets = Math.min(MOST_TARGETS, kept);
  return targets * (24 * vertices + 4 * kept);
}

/**
 * All clips mix the same targets: `morphs` were made of their frames, one clip after the other; `normals` are those of the targets.
 * Y up, facing +Z, in the model's own units. The file's own skin and clips make way.
 */
export function writeMorphs(
  { document, drawn, rest, clips, fps, scale, every, ...input }: GlbInput,
  morphs: BuiltMorphs,
  normals: readonly Float32Array[],
): Uint8Array<ArrayBuffer> {
  const name = clipName(input.name);
  const start = new Shapes(drawn, rest, scale).of(rest);
  const count = normals.length;
  const targets = normals.map(
    (turned, k): Shape => ({ positions: waysOf(drawn, morphs.ways, rest.length / 3, k, scale), normals: turned }),
  );
  const primitives = drawn.instances.map((instance) => ({
    instance,
    index: drawn.index.slice(instance.from, instance.to).map((r) => r - instance.first),
    ...ownOf(start, instance),
    targets: targets.map((target) => ownOf(target, instance)),
  }));
  const mesh = { weights: targets.map(() => 0), extras: { targetNames: targets.map((_, k) => `shape_${k + 1}`) } };
  const motion = (put: Put, node: number): NewMotion => {
    const animations = keptClips(clips, every).map((clip) => {
      const tracks = new PoseTracks(clip.name, put, clip.kept, fps, scale);
      tracks.add(node, morphs.roots, 7, 7 * clip.from, [0, 0, 0]);
      tracks.mix(node, morphs.weights, count, count * clip.from);
      return tracks.animation();
    });
    return { nodes: [{ name, mesh: 0 }], roots: [node], animations };
  };
  return packGlb(withGeometry({ ...document, json: dressBare(document.json) }, { name, primitives, mesh, motion }));
}
