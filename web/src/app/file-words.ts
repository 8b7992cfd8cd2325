import { boundsOf } from "../document/stage-transform";
import type { MeshRef, Point } from "../document/types";
import type { MeshReport, Motion } from "../engine/types";
import { listed } from "../io/formats";
import type { Model } from "../io/model";
import { STAGE_HEIGHT } from "../util/constants";
import { count, figure } from "../util/words";

const AXIS = { x: 0, y: 1, z: 2 } as const;

/** What we open, as people call it. */
export const TAKEN = { models: listed("model"), motions: listed("motion") } as const;

/** What a model is and what we worked around. */
export function modelText(model: Model, mesh: MeshRef, report: MeshReport | null): { title: string; text: string } {
  const { min, max } = boundsOf(model.positions);
  const axis = AXIS[mesh.up.charAt(1) as keyof typeof AXIS];
  const height = max[axis] - min[axis];
  const notes = [...model.notes];
  if (mesh.up !== "+y") notes.unshift(`It lies down in its file; we stood it up.`);
  else if (mesh.facing !== "+z") notes.unshift(`We turned it to look at you.`);
  if (report && report.shells > 1) notes.push(`${figure(report.shells)} separate pieces, held together by closeness.`);
  if (report && report.nonManifoldEdges > 0)
    notes.push(`${count(report.nonManifoldEdges, "edge")} shared by 3 or more faces; we worked around them.`);
  if (report && report.volume === null) notes.push("It is open, so it has no volume to keep.");
  return {
    title: `${model.name} is ${metres(height)} tall.`,
    text: [`Shown at ${STAGE_HEIGHT} m, like the dancer. Export keeps its own size.`, ...notes].join(" "),
  };
}

/** What we guessed and what can be done about it. */
export function guessText(points: readonly Point[]): { title: string; text: string } {
  const loose = points.filter((point) => point.joint === null);
  const text =
    loose.length > 0 ? `${list(loose.map((point) => point.name))} ${loose.length === 1 ? "follows" : "follow"} the whole pose. ` : "";
  return {
    title: `Guessed ${count(points.length, "point")} and which joints they follow.`,
    text: `${text}Drag any dot to correct, Undo to start from nothing.`,
  };
}

function list(words: readonly string[]): string {
  return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

export function motionText(name: string, motion: Motion | null, pairing: readonly string[]): { title: string; text: string } {
  const length = motion ? `${count(motion.frames, "frame")}, ${figure(motion.frames / 30, 1)} s.` : "";
  const text = [length, ...(motion?.notes ?? []), ...pairingText(pairing, motion)].filter((part) => part !== "").join(" ");
  return { title: `${name} plays now.`, text };
}

/** What of the motion does not fit the points, in short, and what to do about it. */
export function pairingText(notes: readonly string[], motion: Motion | null): string[] {
  const some = notes.length > 2 ? [notes[0] ?? "", `And ${notes.length - 1} more like it.`] : notes;
  return motion?.told === false ? [...some, "Choose under Points which joint moves each of them."] : [...some];
}

function metres(value: number): string {
  return value < 0.1 ? `${figure(value, 4)} m` : value < 10 ? `${figure(value, 2)} m` : `${figure(value, 1)} m`;
}
