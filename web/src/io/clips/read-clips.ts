// The motions that a file of a model or of an animation holds, each as BVH text. Runs in the page's worker and in Node alike.

import type { AnimationClip } from "three";

import { count } from "../count";
import { modelFormat } from "../formats";
import { baseName, ModelError, type NamedFile } from "../named-file";
import type { ReadingOptions } from "../read-model";
import type { FoundClip } from "./found-clip";
import { jointsOfTree, movedBy } from "./joints-of-tree";
import type { MovingTree } from "./moving-tree";
import { ownMoves } from "./own-moves";
import { poseOf, sampleClip, spanOf } from "./sample-clip";
import { writeBvh } from "./write-bvh";

/** Shorter is a pose. */
const SHORTEST = 0.06;
const MOST_JOINTS = 4096;

/**
 * All clips of the first of `files` that move a skeleton, in the file's order; the others are parts of it.
 * Errors (ModelError): none; a format without clips; whatever the format's reader finds wrong.
 */
export async function readClips(files: readonly NamedFile[], { onProgress }: ReadingOptions = {}): Promise<FoundClip[]> {
  const [file] = files;
  const name = baseName(file.name);
  const moving = await movingTree(name, file, files);
  const { tree, metres, nameOf } = moving;
  const joints = jointsOfTree(tree, moving.clips);
  const own = new Set(joints.flatMap(({ object }) => above(object)));
  const clips = moving.clips.filter((clip) => [...movedBy(tree, [clip])].some((object) => own.has(object)));
  const long = clips.filter((clip) => {
    const [from, to] = spanOf(clip);
    return to - from >= SHORTEST;
  });
  if (long.length === 0) throw new ModelError(noClip(name, moving.clips.length, joints.length));
  if (joints.length > MOST_JOINTS) throw new ModelError(`${name} moves ${count(joints.length, "joint")}, and we read 4,096 at most.`);
  const rest = poseOf(tree, joints);
  const names = joints.map(({ object }) => nameOf(object));
  let shows = false;
  tree.traverse((object) => void (shows ||= "isMesh" in object || object.userData.shows === true));
  const stem = name.replace(/\.[^.]*$/, "");
  return clipNames(long).map((called, k) => {
    const sampled = sampleClip(tree, joints, long[k]);
    onProgress?.((k + 1) / long.length);
    const title = long.length === 1 ? `${stem}.bvh` : `${stem} ${called.replace(/[/\\:*?"<>|\x00-\x1f]+/g, "-")}.bvh`;
    const moves = shows ? { moves: ownMoves(names, rest, sampled) } : {};
    const text = writeBvh(joints, names, rest, sampled, metres);
    const seconds = (sampled.positions.length - 1) / sampled.fps;
    return { name: called, seconds, motion: { files: [title], input: { name: title, text }, ...moves } };
  });
}

async function movingTree(name: string, file: NamedFile, files: readonly NamedFile[]): Promise<MovingTree> {
  const format = modelFormat(file);
  if (format?.id === "fbx") return (await import("../three-scene/read-fbx")).readFbxClips(name, file);
  if (format?.id !== "glb" && format?.id !== "gltf") throw new ModelError(`${name} holds no motion that we read.`);
  const document = await (await import("../gltf/read")).readDocument(name, file, files, []);
  return (await import("./gltf-tree")).gltfTree(document);
}

/** An object and what it hangs on. */
function above(object: MovingTree["tree"]): MovingTree["tree"][] {
  return object.parent ? [object, ...above(object.parent)] : [object];
}

function noClip(name: string, clips: number, joints: number): string {
  if (clips === 0) return `${name} holds no motion.`;
  if (joints === 0) return `${name} holds motion, but of no skeleton: cameras, colours or shape keys.`;
  return `${name} holds a pose, but no motion.`;
}

/** Without the words between "|" that all share: "Armature|Walk", "Armature|Run". Unique. */
export function clipNames(clips: readonly Pick<AnimationClip, "name">[]): string[] {
  let parts = clips.map(({ name }) => name.split("|").map((part) => part.trim()));
  for (const end of [0, -1]) {
    while (clips.length > 1 && parts.every((each) => each.length > 1 && each.at(end) === parts[0].at(end))) {
      parts = parts.map((each) => (end === 0 ? each.slice(1) : each.slice(0, -1)));
    }
  }
  const taken = new Map<string, number>();
  return parts.map((each) => {
    const name = each.join(" ") || "Clip";
    const before = taken.get(name) ?? 0;
    taken.set(name, before + 1);
    return before === 0 ? name : `${name} ${before + 1}`;
  });
}
