// A glTF document's nodes and animations as three.js objects and tracks, without what they show.

import {
  AnimationClip,
  Bone,
  Interpolant,
  InterpolateDiscrete,
  InterpolateLinear,
  type KeyframeTrack,
  Matrix4,
  Object3D,
  Quaternion,
  QuaternionKeyframeTrack,
  VectorKeyframeTrack,
} from "three";

import { accessorValues } from "../../gltf/accessors";
import type { GltfAnimation, GltfDocument } from "../../gltf/document";
import type { MovingTree } from "./moving-tree";

const PATHS: Readonly<
  Record<string, { property: string; type: string; Track: typeof VectorKeyframeTrack | typeof QuaternionKeyframeTrack }>
> = {
  translation: { property: "position", type: "VEC3", Track: VectorKeyframeTrack },
  rotation: { property: "quaternion", type: "VEC4", Track: QuaternionKeyframeTrack },
  scale: { property: "scale", type: "VEC3", Track: VectorKeyframeTrack },
};

/** Channels that move no node, or name what is not there, are left out. */
export function gltfTree(document: GltfDocument): MovingTree {
  const { nodes = [], skins = [], animations = [] } = document.json;
  const joints = new Set(skins.flatMap((skin) => skin.joints));
  const objects = nodes.map(({ matrix, translation, rotation, scale }, n) => {
    const object = joints.has(n) ? new Bone() : new Object3D();
    if (matrix) new Matrix4().fromArray(matrix).decompose(object.position, object.quaternion, object.scale);
    if (translation) object.position.fromArray(translation);
    if (rotation) object.quaternion.fromArray(rotation).normalize();
    if (scale) object.scale.fromArray(scale);
    object.userData.shows = nodes[n].mesh !== undefined;
    return object;
  });
  nodes.forEach(({ children = [] }, n) => {
    for (const child of children) if (!objects[child].parent) objects[n].add(objects[child]);
  });
  const tree = new Object3D();
  tree.add(...objects.filter(({ parent }) => !parent));
  const names = namesOf(document);
  const index = new Map(objects.map((object, n) => [object, n]));
  return {
    tree,
    metres: 1,
    clips: animations.map(
      (animation, a) => new AnimationClip(animation.name || `Clip ${a + 1}`, -1, tracksOf(document, animation, objects)),
    ),
    nameOf: (object) => names[index.get(object) ?? -1] ?? "",
  };
}

/** By node. A VRM animation says which of its nodes is which part of a human. */
function namesOf({ json: { nodes = [], extensions } }: GltfDocument): string[] {
  const names = nodes.map(({ name }) => name ?? "");
  const { humanoid } = (extensions?.VRMC_vrm_animation ?? {}) as { humanoid?: { humanBones?: Record<string, { node?: unknown }> } };
  for (const [part, bone] of Object.entries(humanoid?.humanBones ?? {})) {
    if (typeof bone?.node === "number" && bone.node in names) names[bone.node] = part;
  }
  return names;
}

function tracksOf(document: GltfDocument, { channels, samplers }: GltfAnimation, objects: readonly Object3D[]): KeyframeTrack[] {
  const { accessors = [] } = document.json;
  if (!Array.isArray(channels) || !Array.isArray(samplers)) return [];
  return channels.flatMap((channel): KeyframeTrack[] => {
    const { sampler: s, target } = (channel ?? {}) as { sampler?: number; target?: { node?: number; path?: string } };
    const object = objects[target?.node ?? -1];
    const path = PATHS[target?.path ?? ""];
    const { input, output, interpolation } = samplers[s ?? -1] ?? { input: -1, output: -1 };
    const [times, values] = [accessors[input], accessors[output]];
    const cubic = interpolation === "CUBICSPLINE";
    if (!object || !path || times?.type !== "SCALAR" || values?.type !== path.type) return [];
    if (times.count === 0 || values.count !== (cubic ? 3 : 1) * times.count) return [];
    const keys = Float32Array.from(accessorValues(document, input));
    if (!keys.every((time, k) => Number.isFinite(time) && (k === 0 || time > keys[k - 1]))) return [];
    const at = Float32Array.from(accessorValues(document, output));
    if (!at.every(Number.isFinite)) return [];
    const kind = interpolation === "STEP" ? InterpolateDiscrete : InterpolateLinear;
    const name = `${object.uuid}.${path.property}`;
    if (!cubic) return [new path.Track(name, keys, at, kind)];
    // Three counts one value a key; the curve itself has the tangents too.
    const track = new path.Track(name, keys, middles(at, path.type === "VEC4" ? 4 : 3), kind);
    const width = track.getValueSize();
    return [Object.assign(track, { createInterpolant: (result: Float32Array) => new CubicSpline(keys, at, width, result) })];
  });
}

function middles(values: Float32Array, width: number): Float32Array {
  return values.filter((_, i) => Math.floor(i / width) % 3 === 1);
}

/** Tangent in, value, tangent out at each key: glTF 2.0, appendix C. */
class CubicSpline extends Interpolant {
  override copySampleValue_(k: number): Float32Array {
    const { valueSize: width } = this;
    const from = (3 * k + 1) * width;
    return this.filled((i) => this.sampleValues[from + i]);
  }

  override interpolate_(k: number, before: number, t: number, after: number): Float32Array {
    const { valueSize: width, sampleValues: v } = this;
    const span = after - before;
    const s = (t - before) / span;
    const [a, b] = [(3 * (k - 1) + 1) * width, (3 * k + 1) * width];
    return this.filled(
      (i) =>
        (1 + s * s * (2 * s - 3)) * v[a + i] +
        span * s * (1 + s * (s - 2)) * v[a + width + i] +
        s * s * (3 - 2 * s) * v[b + i] +
        span * s * s * (s - 1) * v[b - width + i],
    );
  }

  private filled(value: (i: number) => number): Float32Array {
    const out = this.resultBuffer as Float32Array;
    for (let i = 0; i < this.valueSize; i++) out[i] = value(i);
    if (this.valueSize === 4) turn.fromArray(out).normalize().toArray(out);
    return out;
  }
}

const turn = new Quaternion();
