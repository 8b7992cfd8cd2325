// Joints and weights, or morph targets, for a mesh that moves. The module is made for one of them and dropped, and its memory with it.

import { morphInfoRow, skinInfoRow } from "./abi";
import { Heap } from "./heap";
import { engineError } from "./messages";
import type { BuiltMorphs, BuiltSkin, MorphsInput, SkinInput } from "./types";
import { instantiateSkin } from "./wasm";

/** `wasm`: the bytes of skin.wasm. Yields how far it is, 0..1. Errors (EngineError): bad_mesh, out_of_memory. */
export function* buildSkin({ positions, faces, frames, joints }: SkinInput, wasm: ArrayBuffer): Generator<number, BuiltSkin> {
  const module = instantiateSkin(wasm);
  const heap = new Heap(module);
  check(heap.lend([positions, faces], ([at, facesAt]) => module.begin_skin(at, positions.length / 3, facesAt, faces.length / 3, joints)));
  for (const frame of frames) check(heap.lend([frame], ([at]) => module.add_skin_frame(at)));
  while (module.advance_skin() !== 0) yield module.skin_progress();
  const { joints: count, frames: made, targets, rms, worst, normals } = heap.read(skinInfoRow, module.skin_info());
  const vertices = positions.length / 3;
  return {
    centres: heap.floats(module.skin_centres(), 3 * count),
    joints: Uint8Array.from(heap.integers(module.skin_joints(), 4 * vertices)),
    weights: heap.floats(module.skin_weights(), 4 * vertices),
    roots: heap.floats(module.skin_roots(), 7 * made),
    poses: heap.floats(module.skin_poses(), 7 * made * count),
    ways: heap.floats(module.skin_ways(), 3 * vertices * targets),
    mix: heap.floats(module.skin_mix(), made * targets),
    ...{ rms, worst, normals },
  };
}

/** As buildSkin. */
export function* buildMorphs({ positions, frames, targets }: MorphsInput, wasm: ArrayBuffer): Generator<number, BuiltMorphs> {
  const module = instantiateSkin(wasm);
  const heap = new Heap(module);
  const vertices = positions.length / 3;
  check(heap.lend([positions], ([at]) => module.begin_morphs(at, vertices, targets)));
  for (const frame of frames) check(heap.lend([frame], ([at]) => module.add_morph_frame(at)));
  while (module.advance_morphs() !== 0) yield module.morph_progress();
  const { targets: count, frames: made, rms, worst } = heap.read(morphInfoRow, module.morph_info());
  return {
    ways: heap.floats(module.morph_ways(), 3 * vertices * count),
    weights: heap.floats(module.morph_weights(), count * made),
    roots: heap.floats(module.morph_roots(), 7 * made),
    ...{ rms, worst },
  };
}

function check(status: number): void {
  if (status !== 0) throw engineError(status, { kind: "mesh" });
}
