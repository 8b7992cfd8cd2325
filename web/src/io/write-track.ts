// The dance as numbers, for who brings a renderer of their own. docs/project-format.md explains each field.

import { saidOf } from "../document/clips";
import type { ProjectDocument, Vec3 } from "../document/types";
import { FPS } from "../engine/types";
import { toWorld } from "../sync/placement";
import { type SolverModel, stageFor } from "../sync/placement";
import type { Bake } from "../sync/bake";

export interface Track {
  format: "rigless-track";
  version: 1;
  name: string;
  fps: number;
  frames: number;
  /** Positions are in the model file's units, right-handed, Y up, facing +Z: as in the GLB. */
  units: { metresPerUnit: number };
  points: { id: string; name: string; joint: string | null }[];
  /** T x C x 3: where each point is, world. */
  controls: Vec3[][];
  /** T x 4: x, y, z of the model's origin and its turn about +Y in radians. */
  root: [number, number, number, number][];
  contacts: {
    /** T x C, 1 while the point stands on the ground. */
    labels: number[][];
    /** By point: half-open runs [start, end) of frames. */
    runs: [number, number][][];
  };
  /** [last supported frame, first supported frame after it]. */
  flights: [number, number][];
  source: { model: string; motion: readonly string[]; frames: number; fps: number };
}

export function trackOf(document: ProjectDocument, model: SolverModel, bake: Bake): Track {
  const { performance, frames, motion } = bake;
  const C = document.points.length;
  const { scale } = stageFor(model, document.mesh);
  const labels = frames.map((_, f) => [...performance.contacts.subarray(f * C, (f + 1) * C)]);
  return {
    format: "rigless-track",
    version: 1,
    name: document.name,
    fps: FPS * (saidOf(document).speed ?? 1),
    frames: performance.frames,
    units: { metresPerUnit: scale },
    points: document.points.map(({ id, name, joint }) => ({ id, name, joint })),
    controls: frames.map(({ root }, f) => {
      const world = toWorld(performance.controls.subarray(3 * f * C, 3 * (f + 1) * C), root);
      return document.points.map((_, c) => [0, 1, 2].map((k) => world[3 * c + k] / scale) as unknown as Vec3);
    }),
    root: frames.map(({ root: [x, y, z, yaw] }) => [x / scale, y / scale, z / scale, yaw]),
    contacts: { labels, runs: document.points.map((_, c) => runsOf(labels.map((row) => row[c]))) },
    flights: performance.flights,
    source: { model: document.mesh.file, motion: document.motion.files, frames: motion.source.frames, fps: motion.source.fps },
  };
}

/** The track as text, 7 significant digits: all that a float holds. */
export function serializeTrack(track: Track): string {
  return JSON.stringify(track, (_, value: unknown) => (typeof value === "number" ? Number(value.toPrecision(7)) : value)) + "\n";
}

function runsOf(labels: readonly number[]): [number, number][] {
  const runs: [number, number][] = [];
  labels.forEach((label, f) => {
    if (!label) return;
    const last = runs[runs.length - 1];
    if (last?.[1] === f) last[1] = f + 1;
    else runs.push([f, f + 1]);
  });
  return runs;
}
