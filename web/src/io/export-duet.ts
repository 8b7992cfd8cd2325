// Two dances in one file: each model held as it would be alone, and one clip that moves both.

import { saidOf } from "../document/clips";
import type { Offset, ProjectDocument } from "../document/types";
import { type Frame, FPS } from "../engine/types";
import { beatAt, standingOf } from "../sync/beside";
import { stageFor } from "../sync/placement";
import { type Dance, exportDance } from "./export-dance";
import { joinGlbs } from "./gltf/join";
import type { Model } from "./model";
import { paced } from "./pace";
import type { Likeness, Profile, Tools, Written } from "./profile";

/** Whoever dances beside: all frames of a dance, at FPS. */
export interface DanceBeside {
  readonly document: ProjectDocument;
  readonly offset: Offset;
  readonly model: Model;
  /** As the file calls it. */
  readonly name: string;
  readonly frames: readonly Frame[];
}

type Rooted = readonly Pick<Frame, "root">[];

/** `hand`: a dance of one clip; `roots`: its frames at FPS. Errors: as those of exportDance. */
export async function exportDuet(
  hand: Dance,
  roots: Rooted,
  beside: DanceBeside,
  every: number,
  tools: Tools,
  profile: Profile,
): Promise<Written> {
  const { clips, fps = FPS } = hand;
  const [clip] = clips;
  const { document, model, name, offset } = beside;
  const scale = 1 / stageFor(hand.model, hand.mesh).scale; // both in the units of the one in hand
  const half = (k: number): Tools => ({ ...tools, onProgress: (done) => tools.onProgress?.((k + done) / 2) });
  const first = await exportDance(hand, every, half(0), profile);
  const frames = framesBeside(beside, fps, clip.frames.length);
  const { mesh, points } = document;
  const other = { name, model, mesh, points, clips: [{ name: clip.name, frames }], fps, scale };
  const second = await exportDance(other, every, half(1), profile);
  const { x, z, yaw } = standingOf(offset, travelOf(roots), travelOf(beside.frames), 0);
  const placed = { name: `${name}_place`, translation: [x * scale, 0, z * scale], rotation: [0, Math.sin(yaw / 2), 0, Math.cos(yaw / 2)] };
  return { bytes: joinGlbs(first.bytes, second.bytes, placed), likeness: bothAlike(first.likeness, second.likeness) };
}

/** So many frames in its own world, as it dances while the one in hand does so once. */
export function framesBeside({ document, offset, frames }: DanceBeside, fps: number, length: number): { positions: Float32Array }[] {
  const { speed = 1, loop = false } = saidOf(document);
  const own = paced(frames, fps, speed);
  const [from, to] = [frames[0].root, frames[frames.length - 1].root];
  return Array.from({ length }, (_, k) => {
    const { frame, round } = beatAt(k - offset.seconds * fps, own.length, loop);
    const { positions } = own[frame];
    if (round === 0) return { positions };
    const way = [0, 1, 2].map((axis) => (axis === 1 ? 0 : round * (to[axis] - from[axis])));
    return { positions: positions.map((value, i) => value + way[i % 3]) };
  });
}

const travelOf = (frames: Rooted): { travel: Float32Array } => ({
  travel: Float32Array.from([...frames.slice(0, 1), ...frames.slice(-1)].flatMap(({ root }) => root.slice(0, 3))),
});

/** The worse of both, and what holds them together. */
function bothAlike(a: Likeness | null, b: Likeness | null): Likeness | null {
  if (!a || !b) return a ?? b;
  const worse = (of: "rms" | "worst" | "normals"): number => Math.max(a[of], b[of]);
  const sum = (of: "joints" | "targets"): number => (a[of] ?? 0) + (b[of] ?? 0);
  return { rms: worse("rms"), worst: worse("worst"), normals: worse("normals"), joints: sum("joints"), targets: sum("targets") };
}
