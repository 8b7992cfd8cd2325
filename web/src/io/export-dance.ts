// The one path from a dance's frames to a file.

import { pointToStage, turnToStage } from "../document/stage-transform";
import type { MeshRef, Point } from "../document/types";
import { stageFor } from "../sync/placement";
import { meshInput } from "../sync/translate";
import type { Model } from "./model";
import { ModelError } from "./named-file";
import type { Likeness, Profile, Tools, Written } from "./profile";
import { PROFILES } from "./profiles";
import { keptFrames } from "./write-glb";

/** A larger file cannot be made in one piece, nor opened. */
const MOST_BYTES = 2 ** 31;

export interface Dance {
  readonly name: string;
  readonly model: Model;
  readonly mesh: MeshRef;
  /** After which joints are named. */
  readonly points?: readonly Pick<Point, "name" | "position">[];
  /** V x 3 each, world stage metres. */
  readonly frames: readonly { readonly positions: Float32Array }[];
}

/** Every `every`-th frame and the last one are kept. Errors (ModelError): the file would be too large; EngineError of the tools. */
export async function exportDance(
  { name, model, mesh, frames, points = [] }: Dance,
  every: number,
  tools: Tools,
  profile: Profile = PROFILES[0],
): Promise<Written> {
  const tooLarge = sizeFault(model, frames.length, every, profile);
  if (tooLarge) throw new ModelError(`${name}.${profile.extension} ${tooLarge.text}.`);
  const { document, drawn, faces } = model;
  const rest = meshInput(model, mesh).positions;
  const stage = stageFor(model, mesh);
  const turned = { ...drawn, normals: turnToStage(stage, drawn.normals) };
  const places = points.map((point) => ({ name: point.name, position: pointToStage(stage, point.position) }));
  return profile.write({ name, document, drawn: turned, faces, places, rest, frames, scale: 1 / stage.scale, every }, tools);
}

/** In words: how many joints there are, and how like the file is to the dance. */
export function sayLikeness({ joints, rms, worst, normals }: Likeness): string {
  const share = (of: number): string => `${(100 * of).toFixed(2)} %`;
  const degrees = ((normals * 180) / Math.PI).toFixed(1);
  const places = `${share(rms)} of the model's size off on average, ${share(worst)} in the worst place`;
  return `${joints} joints; ${places}; light ${degrees} degrees off`;
}

/** The least step with which every viewer takes a dance of so many frames. */
export function everyFor(frames: number, { mostKept }: Profile = PROFILES[0]): number {
  return mostKept === null ? 1 : Math.max(1, Math.ceil((frames - 1) / (mostKept - 1)));
}

/** Null where the file is of a size that can be made; else what to say, and the least step that makes it so. */
export function sizeFault(model: Model, frames: number, every: number, profile: Profile): { text: string; every: number } | null {
  const bytes = (k: number): number => profile.bytes(model.drawn.toVertex.length, keptFrames(frames, k).length);
  if (bytes(every) <= MOST_BYTES) return null;
  let enough = every;
  while (enough < frames && bytes(enough) > MOST_BYTES) enough++;
  return { text: `would hold ${(bytes(every) / 1e9).toFixed(1)} GB, more than a ${profile.extension.toUpperCase()} can`, every: enough };
}
