// An animated GLB of core glTF 2.0: the rest model, one morph target per kept frame and weights that lead from each to the
// next, so that two targets at most act at a time (viewers promise no more than eight).

import { FPS } from "../engine/types";
import { dressBare } from "../gltf/bare";
import type { GltfAnimation, GltfDocument } from "../gltf/document";
import type { Drawn } from "../gltf/drawn";
import { ownOf, type Shape, Shapes } from "./drawn-shape";
import { type NewMotion, type NewPrimitive, packGlb, type Put, withGeometry } from "./gltf/write";

export interface GlbInput {
  /** The clip's and the mesh's name; spaces become underscores. */
  name: string;
  document: GltfDocument;
  /** Its normals in the stage's axes. */
  drawn: Drawn;
  /** F x 3 over V. */
  faces: Uint32Array;
  /** Places on the rest model and what people call them, stage metres. */
  places: readonly { readonly name: string; readonly position: readonly [number, number, number] }[];
  /** V x 3, stage metres. */
  rest: Float32Array;
  /** V x 3 each, world stage metres; frame f is at f / 30 s. */
  frames: readonly { readonly positions: Float32Array }[];
  /** File units per stage metre: the model keeps its own size. */
  scale: number;
  /** Every k-th frame and the last one are kept; the viewer goes straight between them. */
  every: number;
}

/** The frames that `every` keeps: 0, k, 2k, ... and the last. */
export function keptFrames(frames: number, every: number): number[] {
  const kept: number[] = [];
  for (let f = 0; f < frames; f += every) kept.push(f);
  if (frames > 0 && kept[kept.length - 1] !== frames - 1) kept.push(frames - 1);
  return kept;
}

/** Bytes of a GLB with so many render vertices and kept frames, without what does not grow with both. */
export function glbBytes(vertices: number, kept: number): number {
  return 24 * vertices * kept + 4 * kept * kept;
}

/**
 * Y up, facing +Z, in the model's own units; travel and turn are in the vertices. Normals have targets too, because a model that
 * turns would be lit from the wrong side without; they double the size: 24 bytes per render vertex and kept frame. Materials,
 * pictures and whatever else the model's own file says stay.
 */
export function writeGlb({ document, drawn, rest, frames, scale, every, ...input }: GlbInput): Uint8Array<ArrayBuffer> {
  const name = clipName(input.name);
  const kept = keptFrames(frames.length, every);
  const shapes = new Shapes(drawn, rest, scale);
  const start = shapes.of(rest);
  const primitives = drawn.instances.map((instance): NewPrimitive & { targets: Shape[] } => ({
    instance,
    index: drawn.index.slice(instance.from, instance.to).map((r) => r - instance.first),
    ...ownOf(start, instance),
    targets: [],
  }));
  for (const f of kept) {
    const shape = difference(shapes.of(frames[f].positions), start);
    for (const primitive of primitives) primitive.targets.push(ownOf(shape, primitive.instance));
  }
  const mesh = { weights: kept.map(() => 0), extras: { targetNames: kept.map((f) => `frame_${f}`) } };
  const motion = (put: Put, node: number): NewMotion => ({
    nodes: [{ name, mesh: 0 }],
    roots: [node],
    animations: kept.length > 0 ? [oneAfterTheOther(name, put, node, timesOf(kept))] : [],
  });
  return packGlb(withGeometry({ ...document, json: dressBare(document.json) }, { name, primitives, mesh, motion }));
}

/** Spaces become underscores. */
export const clipName = (name: string): string => name.trim().replace(/\s+/g, "_") || "dance";

/** Seconds of frames. */
export const timesOf = (kept: readonly number[]): Float32Array => Float32Array.from(kept, (f) => f / FPS);

/** Key k is target k alone. */
function oneAfterTheOther(name: string, put: Put, node: number, times: Float32Array): GltfAnimation {
  const weights = new Float32Array(times.length ** 2);
  for (let k = 0; k < times.length; k++) weights[k * times.length + k] = 1;
  const samplers = [{ input: put(times, "SCALAR", { bounded: true }), output: put(weights, "SCALAR"), interpolation: "LINEAR" }];
  return { name, samplers, channels: [{ sampler: 0, target: { node, path: "weights" } }] };
}

function difference(a: Shape, b: Shape): Shape {
  const less = (x: Float32Array, y: Float32Array): Float32Array => x.map((value, i) => value - y[i]);
  return { positions: less(a.positions, b.positions), normals: a.normals && b.normals && less(a.normals, b.normals) };
}
