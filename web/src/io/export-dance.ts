// The one path from a dance's frames to a file.

import { pointToStage, turnToStage } from "../document/stage-transform";
import type { MeshRef, Point } from "../document/types";
import { FPS } from "../engine/types";
import { stageFor } from "../sync/placement";
import { meshInput } from "../sync/translate";
import { count } from "./count";
import type { Model } from "./model";
import { ModelError } from "./named-file";
import { GLB_BYTES, type Likeness, type Profile, type Tools, type Written } from "./profile";
import { PROFILES } from "./profiles";
import { type Clip, keptFrames } from "./write-glb";

export interface Dance {
  readonly name: string;
  readonly model: Model;
  readonly mesh: MeshRef;
  /** After which joints are named. */
  readonly points?: readonly Pick<Point, "name" | "position">[];
  /** One or several, which then share a skeleton. */
  readonly clips: readonly Clip[];
  /** Default FPS. */
  readonly fps?: number;
  /** File units per stage metre; default those of the model's own file. */
  readonly scale?: number;
}

/**
 * Of each clip every `every`-th frame and the last one are kept.
 * Errors (ModelError): the file would be too large; EngineError of the tools.
 */
export async function exportDance(
  { name, model, mesh, clips, points = [], fps = FPS, scale }: Dance,
  every: number,
  tools: Tools,
  profile: Profile = PROFILES[0],
): Promise<Written> {
  const tooLarge = sizeFault(model, lengthsOf(clips), every, profile);
  if (tooLarge) throw new ModelError(`${name}.${profile.extension} ${tooLarge.text}.`);
  const { document, drawn, faces } = model;
  const rest = meshInput(model, mesh).positions;
  const stage = stageFor(model, mesh);
  const turned = { ...drawn, normals: turnToStage(stage, drawn.normals) };
  const places = points.map((point) => ({ name: point.name, position: pointToStage(stage, point.position) }));
  return profile.write({ name, document, drawn: turned, faces, places, rest, clips, fps, scale: scale ?? 1 / stage.scale, every }, tools);
}

export const lengthsOf = (clips: readonly Clip[]): number[] => clips.map(({ frames }) => frames.length);

/** "22 joints", "64 joints and 8 morph targets" */
export function sayHolding({ joints, targets }: Likeness): string {
  const held = [...(joints ? [count(joints, "joint")] : []), ...(targets ? [count(targets, "morph target")] : [])];
  return held.join(" and ");
}

/** In words: what holds the dance, and how like the file is to it. */
export function sayLikeness(likeness: Likeness): string {
  const { rms, worst, normals } = likeness;
  const share = (of: number): string => `${(100 * of).toFixed(2)} %`;
  const degrees = ((normals * 180) / Math.PI).toFixed(1);
  const places = `${share(rms)} of the model's size off on average, ${share(worst)} in the worst place`;
  return `${sayHolding(likeness)}; ${places}; light ${degrees} degrees off`;
}

/** What of the model's own file makes way for what is written, or null. */
export function sayReplaced({ document: { json } }: Pick<Model, "document">): string | null {
  const clips = json.animations?.length ?? 0;
  const gone = [...(json.skins?.length ? ["skeleton"] : []), ...(clips > 0 ? [clips === 1 ? "clip" : `${clips} clips`] : [])];
  if (gone.length === 0) return null;
  return `The model's own ${gone.join(" and ")} ${gone.length > 1 || clips > 1 ? "are" : "is"} replaced.`;
}

/** How many frames are kept of clips of so many. */
export const keptOf = (frames: readonly number[], every: number): number =>
  frames.reduce((sum, count) => sum + keptFrames(count, every).length, 0);

/** The least step with which every viewer takes clips of so many frames. */
export function everyFor(frames: readonly number[], { mostKept }: Profile = PROFILES[0]): number {
  let every = 1;
  while (mostKept !== null && keptOf(frames, every) > mostKept && every < Math.max(...frames)) every++;
  return every;
}

/** Null where the file is of a size that can be made; else what to say, and the least step that makes it so. */
export function sizeFault(
  model: Model,
  frames: readonly number[],
  every: number,
  profile: Profile,
): { text: string; every: number } | null {
  const bytes = (k: number): number => profile.bytes(model.drawn.toVertex.length, keptOf(frames, k));
  const { mostBytes } = profile;
  if (bytes(every) <= mostBytes) return null;
  let enough = every;
  while (enough < Math.max(...frames) && bytes(enough) > mostBytes) enough++;
  const most = mostBytes < GLB_BYTES ? `the ${size(mostBytes)} that viewers open` : `a ${profile.extension.toUpperCase()} can`;
  return { text: `would hold ${size(bytes(every))}, more than ${most}`, every: enough };
}

/** Whole: it is an estimate. */
const size = (bytes: number): string => (bytes < 1e9 ? `${Math.round(bytes / 1e6)} MB` : `${(bytes / 1e9).toFixed(1)} GB`);
