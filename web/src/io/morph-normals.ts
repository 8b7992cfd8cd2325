// What morph targets do to normals: fitted to the normals of all frames, as their ways are to the places.

import type { BuiltMorphs, CallOptions } from "../engine/types";
import { nextTask } from "../util/next-task";
import { Shapes } from "./drawn-shape";
import type { GlbInput } from "./write-glb";

export interface MorphNormals {
  /** K of R x 3: what each target adds to the normal at rest. */
  readonly targets: Float32Array[];
  /** Radians, rms: how far what is mixed is from the frames' own. */
  readonly off: number;
}

/** Others get their turn between two frames. Rejects with the signal's reason. */
export async function morphNormals(
  { drawn, rest, clips, scale }: Pick<GlbInput, "drawn" | "rest" | "clips" | "scale">,
  { weights, roots }: BuiltMorphs,
  { signal, onProgress }: CallOptions,
): Promise<MorphNormals> {
  const shapes = new Shapes(drawn, rest, scale);
  const start = normalsOf(shapes, rest);
  const frames = clips.flatMap((clip) => clip.frames);
  const count = weights.length / Math.max(1, frames.length);
  const targets = Array.from({ length: count }, () => new Float32Array(start.length));
  const turned = (f: number): Float32Array => turnedBack(normalsOf(shapes, frames[f].positions), roots.subarray(7 * f, 7 * f + 4));
  // The weights of two targets are at right angles over the frames, so each is fitted alone.
  for (let f = 0; f < frames.length; f++) {
    const now = turned(f);
    for (let k = 0; k < count; k++) {
      const weight = weights[f * count + k];
      if (weight === 0) continue;
      const target = targets[k];
      for (let i = 0; i < now.length; i++) target[i] += weight * (now[i] - start[i]);
    }
    await nextTask();
    signal?.throwIfAborted();
    onProgress?.(f / frames.length);
  }
  targets.forEach((target, k) => {
    let square = 0;
    for (let f = 0; f < frames.length; f++) square += weights[f * count + k] ** 2;
    if (square > 0) for (let i = 0; i < target.length; i++) target[i] /= square;
  });
  return { targets, off: offBy() };

  function offBy(): number {
    let [sum, lit] = [0, 0];
    for (let f = 0; f < frames.length; f += Math.ceil(frames.length / 24)) {
      const wanted = turned(f);
      const mixed = Float32Array.from(start);
      targets.forEach((target, k) => {
        for (let i = 0; i < mixed.length; i++) mixed[i] += weights[f * count + k] * target[i];
      });
      for (let i = 0; i < mixed.length; i += 3) {
        const dot = mixed[i] * wanted[i] + mixed[i + 1] * wanted[i + 1] + mixed[i + 2] * wanted[i + 2];
        const size = Math.hypot(mixed[i], mixed[i + 1], mixed[i + 2]) * Math.hypot(wanted[i], wanted[i + 1], wanted[i + 2]);
        if (!(size > 0)) continue;
        sum += Math.acos(Math.min(1, Math.max(-1, dot / size))) ** 2;
        lit++;
      }
    }
    return lit > 0 ? Math.sqrt(sum / lit) : 0;
  }
}

const normalsOf = (shapes: Shapes, vertices: Float32Array): Float32Array => shapes.of(vertices).normals ?? new Float32Array(0);

/** By the inverse of a quaternion x, y, z, w; in place. */
function turnedBack(normals: Float32Array, [x, y, z, w]: Float32Array): Float32Array {
  for (let i = 0; i < normals.length; i += 3) {
    const [a, b, c] = [normals[i], normals[i + 1], normals[i + 2]];
    // v + 2 w (v x q) + 2 q x (q x v), q being the quaternion's own vector.
    const [p, q, r] = [b * z - c * y, c * x - a * z, a * y - b * x];
    normals[i] = a + 2 * (w * p + z * q - y * r);
    normals[i + 1] = b + 2 * (w * q + x * r - z * p);
    normals[i + 2] = c + 2 * (w * r + y * p - x * q);
  }
  return normals;
}
