// The keys of one clip: how nodes turn and go, and which morph targets they show. What stays as it is at rest has none.

import type { GltfAnimation } from "../gltf/document";
import type { Put } from "./gltf/write";
import { timesOf } from "./write-glb";

/** Turns by less than a step of a short, and ways of less than this share of the model's height, are none. */
const STILL = 3e-5;

/** The tracks of one clip. */
export class PoseTracks {
  private readonly channels: unknown[] = [];
  private readonly samplers: { input: number; output: number; interpolation: string }[] = [];
  private times: number | null = null;

  constructor(
    private readonly name: string,
    private readonly put: Put,
    private readonly kept: readonly number[],
    private readonly fps: number,
    private readonly scale: number,
  ) {}

  /** Tracks of one node, of poses that begin at `from` in rows of `stride`; none for what stays as it is at rest. */
  add(node: number, poses: Float32Array, stride: number, from: number, rest: readonly number[]): void {
    const turns = new Int16Array(4 * this.kept.length);
    const ways = new Float32Array(3 * this.kept.length);
    let turned = 0;
    let moved = 0;
    this.kept.forEach((f, n) => {
      const at = f * stride + from;
      for (let k = 0; k < 4; k++) turns[4 * n + k] = Math.round(32767 * poses[at + k]);
      for (let k = 0; k < 3; k++) {
        turned = Math.max(turned, Math.abs(poses[at + k]));
        ways[3 * n + k] = this.scale * poses[at + 4 + k];
        moved = Math.max(moved, Math.abs(ways[3 * n + k] - rest[k]) / this.scale);
      }
    });
    if (turned > STILL) this.track(node, "rotation", this.put(turns, "VEC4", { normalized: true }));
    if (moved > STILL) this.track(node, "translation", this.put(ways, "VEC3"));
  }

  /** How much of each of `count` morph targets a node shows, of weights that begin at `from`. */
  mix(node: number, weights: Float32Array, count: number, from: number): void {
    const kept = new Float32Array(count * this.kept.length);
    this.kept.forEach((f, n) => kept.set(weights.subarray(from + f * count, from + (f + 1) * count), n * count));
    this.track(node, "weights", this.put(kept, "SCALAR"));
  }

  animation(): GltfAnimation {
    return { name: this.name, samplers: this.samplers, channels: this.channels };
  }

  private track(node: number, path: "rotation" | "translation" | "weights", output: number): void {
    this.times ??= this.put(timesOf(this.kept, this.fps), "SCALAR", { bounded: true });
    this.channels.push({ sampler: this.samplers.length, target: { node, path } });
    this.samplers.push({ input: this.times, output, interpolation: "LINEAR" });
  }
}
