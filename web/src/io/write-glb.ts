// An animated GLB of core glTF 2.0: the rest model, one morph target per kept frame and weights that lead from each to the
// next, so that two targets at most act at a time (viewers promise no more than eight).

import { dressBare } from "../gltf/bare";
import type { GltfAnimation, GltfDocument } from "../gltf/document";
import type { Drawn } from "../gltf/drawn";
import { ownOf, type Shape, Shapes } from "./drawn-shape";
import { type NewMotion, type NewPrimitive, packGlb, type Put, withGeometry } from "./gltf/write";

/** A motion as the model dances it. */
export interface Clip {
  /** Spaces become underscores. */
  readonly name: string;
  /** V x 3 each, world stage metres; frame f is at f / fps s. */
  readonly frames: readonly { readonly positions: Float32Array }[];
}

export interface GlbInput {
  /** The mesh's; spaces become underscores. */
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
  clips: readonly Clip[];
  fps: number;
  /** File units per stage metre: the model keeps its own size. */
  scale: number;
  /** Every k-th frame and the last one are kept; the viewer goes straight between them. */
  every: number;
}

/** The frames of a clip that `every` keeps: 0, k, 2k, ... and the last. */
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
export function writeGlb({ document, drawn, rest, fps, scale, every, ...input }: GlbInput): Uint8Array<ArrayBuffer> {
  const name = clipName(input.name);
  const clips = keptClips(input.clips, every);
  const shapes = new Shapes(drawn, rest, scale);
  const start = shapes.of(rest);
  const primitives = drawn.instances.map((instance): NewPrimitive & { targets: Shape[] } => ({
    instance,
    index: drawn.index.slice(instance.from, instance.to).map((r) => r - instance.first),
    ...ownOf(start, instance),
    targets: [],
  }));
  const targetNames: string[] = [];
  for (const { name, frames, kept } of clips) {
    for (const f of kept) {
      const shape = difference(shapes.of(frames[f].positions), start);
      for (const primitive of primitives) primitive.targets.push(ownOf(shape, primitive.instance));
      targetNames.push(`${clips.length > 1 ? name : "frame"}_${f}`);
    }
  }
  const mesh = { weights: targetNames.map(() => 0), extras: { targetNames } };
  const targets = targetNames.length;
  const animations = (put: Put, node: number): GltfAnimation[] =>
    clips.map(({ name, kept, keptFrom }) => oneAfterTheOther(name, put, node, timesOf(kept, fps), { first: keptFrom, all: targets }));
  const motion = (put: Put, node: number): NewMotion => ({ nodes: [{ name, mesh: 0 }], roots: [node], animations: animations(put, node) });
  return packGlb(withGeometry({ ...document, json: dressBare(document.json) }, { name, primitives, mesh, motion }));
}

/** Spaces become underscores. */
export const clipName = (name: string): string => name.trim().replace(/\s+/g, "_") || "dance";

/** Seconds of frames. */
export const timesOf = (kept: readonly number[], fps: number): Float32Array => Float32Array.from(kept, (f) => f / fps);

export interface KeptClip extends Clip {
  /** Numbers of its kept frames. */
  readonly kept: readonly number[];
  /** Its first frame's number among those of all clips. */
  readonly from: number;
  /** The same of kept frames alone. */
  readonly keptFrom: number;
}

/** Clips that have frames, each under a name of its own. */
export function keptClips(clips: readonly Clip[], every: number): KeptClip[] {
  const taken = new Map<string, number>();
  let from = 0;
  let keptFrom = 0;
  return clips.flatMap(({ name, frames }) => {
    if (frames.length === 0) return [];
    const clip = { name: numbered(clipName(name), taken), frames, kept: keptFrames(frames.length, every), from, keptFrom };
    from += frames.length;
    keptFrom += clip.kept.length;
    return [clip];
  });
}

/** "hand", "hand_2" */
export function numbered(name: string, taken: Map<string, number>): string {
  const n = (taken.get(name) ?? 0) + 1;
  taken.set(name, n);
  return n === 1 ? name : `${name}_${n}`;
}

/** Key k is target `first` + k alone. */
function oneAfterTheOther(
  name: string,
  put: Put,
  node: number,
  times: Float32Array,
  { first, all }: { first: number; all: number },
): GltfAnimation {
  const weights = new Float32Array(times.length * all);
  for (let k = 0; k < times.length; k++) weights[k * all + first + k] = 1;
  const samplers = [{ input: put(times, "SCALAR", { bounded: true }), output: put(weights, "SCALAR"), interpolation: "LINEAR" }];
  return { name, samplers, channels: [{ sampler: 0, target: { node, path: "weights" } }] };
}

function difference(a: Shape, b: Shape): Shape {
  const less = (x: Float32Array, y: Float32Array): Float32Array => x.map((value, i) => value - y[i]);
  return { positions: less(a.positions, b.positions), normals: a.normals && b.normals && less(a.normals, b.normals) };
}
