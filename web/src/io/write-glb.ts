// An animated GLB of core glTF 2.0: the rest model, one morph target per kept frame and weights that lead from each to the
// next, so that two targets at most act at a time (viewers promise no more than eight).

import { FPS } from "../engine/types";
import { dressBare } from "../gltf/bare";
import type { GltfDocument } from "../gltf/document";
import type { Drawn } from "../gltf/drawn";
import { bindNormals, writeNormals } from "../gltf/surface-normals";
import { type NewPrimitive, packGlb, withGeometry } from "./gltf/write";

export interface GlbInput {
  /** The clip's and the mesh's name; spaces become underscores. */
  name: string;
  document: GltfDocument;
  /** Its normals in the stage's axes. */
  drawn: Drawn;
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
  const name = input.name.trim().replace(/\s+/g, "_") || "dance";
  const kept = keptFrames(frames.length, every);
  const binding = bindNormals(rest, drawn);
  const shapeOf = (vertices: Float32Array): Shape => {
    const normals = new Float32Array(drawn.positions.length);
    writeNormals(binding, vertices, normals);
    return { positions: onDrawn(drawn, vertices, scale), normals };
  };
  const start = shapeOf(rest);
  const primitives = drawn.instances.map((instance): NewPrimitive & { targets: Shape[] } => ({
    instance,
    index: drawn.index.slice(instance.from, instance.to).map((r) => r - instance.first),
    ...ownOf(start, instance),
    targets: [],
  }));
  for (const f of kept) {
    const shape = difference(shapeOf(frames[f].positions), start);
    for (const primitive of primitives) primitive.targets.push(ownOf(shape, primitive.instance));
  }
  const targetNames = kept.map((f) => `frame_${f}`);
  const times = Float32Array.from(kept, (f) => f / FPS);
  const dressed = { ...document, json: dressBare(document.json) };
  return packGlb(withGeometry(dressed, { name, primitives, targetNames, times }));
}

interface Shape {
  /** N x 3. */
  positions: Float32Array;
  /** N x 3; null where faces are flat. */
  normals: Float32Array | null;
}

function ownOf({ positions, normals }: Shape, { first, count, flat }: Drawn["instances"][number]): Shape {
  const own = (values: Float32Array): Float32Array => values.slice(3 * first, 3 * (first + count));
  return { positions: own(positions), normals: flat || !normals ? null : own(normals) };
}

/** R x 3 of V x 3 values. */
function onDrawn({ toVertex }: Drawn, values: Float32Array, scale: number): Float32Array {
  const out = new Float32Array(3 * toVertex.length);
  toVertex.forEach((v, r) => {
    for (let k = 0; k < 3; k++) out[3 * r + k] = scale * values[3 * v + k];
  });
  return out;
}

function difference(a: Shape, b: Shape): Shape {
  const less = (x: Float32Array, y: Float32Array): Float32Array => x.map((value, i) => value - y[i]);
  return { positions: less(a.positions, b.positions), normals: a.normals && b.normals && less(a.normals, b.normals) };
}
