// People who move, as GLB and as FBX, made by script.

import type { Gltf } from "../../src/gltf/document";
import type { NamedFile } from "../../src/io/named-file";
import { GltfMaker } from "./gltf";
import { binaryFbx, type FbxNode, fbxScene, textFbx } from "./scenes";
import { sphere } from "./surfaces";

type Place = readonly [number, number, number];

/** In centimetres against the parent, Y up, facing +Z: as Mixamo names them. */
const BONES: readonly (readonly [name: string, parent: number, at: Place])[] = [
  ["Hips", -1, [0, 95, 0]],
  ["Spine", 0, [0, 20, 0]],
  ["Head", 1, [0, 40, 0]],
  ["LeftArm", 1, [18, 25, 0]],
  ["LeftForeArm", 3, [28, 0, 0]],
  ["LeftHand", 4, [25, 0, 0]],
  ["RightArm", 1, [-18, 25, 0]],
  ["RightForeArm", 6, [-28, 0, 0]],
  ["RightHand", 7, [-25, 0, 0]],
  ["LeftUpLeg", 0, [9, -5, 0]],
  ["LeftLeg", 9, [0, -42, 0]],
  ["LeftFoot", 10, [0, -42, 0]],
  ["RightUpLeg", 0, [-9, -5, 0]],
  ["RightLeg", 12, [0, -42, 0]],
  ["RightFoot", 13, [0, -42, 0]],
];
export const BONE_NAMES = BONES.map(([name]) => name);

export interface Channel {
  readonly bone: string;
  readonly path: "translation" | "rotation" | "scale";
  readonly times: readonly number[];
  readonly values: readonly number[];
  readonly interpolation?: "STEP" | "LINEAR" | "CUBICSPLINE";
}

interface GlbOptions {
  readonly mesh?: boolean;
  readonly skin?: boolean;
  readonly extensions?: Record<string, unknown>;
}

/** Node b + 1 is bone b; above them stands an armature of scale .01, as Blender writes it. */
export function movingGlb(
  clips: Readonly<Record<string, readonly Channel[]>>,
  { mesh = false, skin = true, extensions }: GlbOptions = {},
  name = "person.glb",
): NamedFile {
  const maker = new GltfMaker();
  const childrenOf = (b: number): number[] => BONES.flatMap(([, parent], child) => (parent === b ? [child + 1] : []));
  maker.json.nodes = [
    { name: "Armature", scale: [0.01, 0.01, 0.01], children: childrenOf(-1) },
    ...BONES.map(([bone, , at], b) => ({ name: bone, translation: [...at], ...(childrenOf(b).length > 0 && { children: childrenOf(b) }) })),
  ];
  if (skin) maker.json.skins = [{ joints: BONES.map((_, b) => b + 1) }];
  if (mesh) {
    const { positions, index } = sphere(12, 9);
    maker.mesh({ attributes: { POSITION: maker.floats([...positions]) }, indices: maker.shorts([...index]) });
    maker.json.scenes = [{ nodes: [0, maker.json.nodes.push({ name: "Body", mesh: 0 }) - 1] }];
  }
  const animations = Object.entries(clips).map(([clip, channels]) => ({
    name: clip,
    channels: channels.map(({ bone, path }, sampler) => ({ sampler, target: { node: BONE_NAMES.indexOf(bone) + 1, path } })),
    samplers: channels.map(({ path, times, values, interpolation = "LINEAR" }) => ({
      input: maker.floats(times, "SCALAR"),
      output: maker.floats(values, path === "rotation" ? "VEC4" : "VEC3"),
      interpolation,
    })),
  }));
  maker.json = { ...maker.json, animations, ...(extensions && { extensions }) } as Gltf;
  return maker.glb(name);
}

/** n + 1 keys, `fps` a second. */
export const keys = (n: number, fps: number): number[] => Array.from({ length: n + 1 }, (_, k) => k / fps);

/** The hips go `metres` along z. */
export function gliding(metres: number, n = 30, fps = 30): Channel[] {
  const times = keys(n, fps);
  return [{ bone: "Hips", path: "translation", times, values: times.flatMap((_, k) => [0, 95, (100 * metres * k) / n]) }];
}

/** A second of the FBX's time. */
const SECOND = 46186158000;

/** Bones of a Mixamo file whose hips go two metres along z in a second, thirty keys; text where asked. */
export function movingFbx({ text = false, mesh = false } = {}): NamedFile {
  const id = (b: number): bigint => BigInt(1000 + b);
  const times = keys(30, 30).map((time) => Math.round(time * SECOND));
  const property = (name: string, ...at: readonly number[]): FbxNode => ({ name: "P", values: [name, name, "", "A", ...at] });
  const bones = BONES.map(
    ([name, , at], b): FbxNode => ({
      name: "Model",
      values: [id(b), `mixamorig:${name}\u0000\u0001Model`, "LimbNode"],
      nodes: [{ name: "Properties70", nodes: [property("Lcl Translation", ...at)] }],
    }),
  );
  const curves = [0, 95, 200].map(
    (to, k): FbxNode => ({
      name: "AnimationCurve",
      values: [BigInt(2000 + k), "\u0000\u0001AnimCurve", ""],
      nodes: [
        { name: "KeyTime", values: [{ letter: "l", items: times }] },
        { name: "KeyValueFloat", values: [{ letter: "d", items: times.map((_, f) => (k === 1 ? to : (to * f) / 30)) }] },
      ],
    }),
  );
  const nodes: FbxNode[] = [{ name: "Version", values: [100] }];
  const objects: FbxNode[] = [
    ...bones,
    { name: "AnimationStack", values: [3000n, "mixamo.com\u0000\u0001AnimStack", ""], nodes },
    { name: "AnimationLayer", values: [3001n, "BaseLayer\u0000\u0001AnimLayer", ""], nodes },
    { name: "AnimationCurveNode", values: [3002n, "T\u0000\u0001AnimCurveNode", ""], nodes },
    ...curves,
  ];
  const links: (readonly (bigint | string)[])[] = [
    ...BONES.map(([, parent], b) => [id(b), parent < 0 ? 0n : id(parent)] as const),
    [3001n, 3000n],
    [3002n, 3001n],
    [3002n, id(0), "Lcl Translation"],
    ...["d|X", "d|Y", "d|Z"].map((axis, k) => [BigInt(2000 + k), 3002n, axis] as const),
  ];
  const scene = fbxScene({ objects, links, mesh });
  return { name: "walk.fbx", bytes: text ? new TextEncoder().encode(textFbx(scene)) : binaryFbx(scene) };
}
