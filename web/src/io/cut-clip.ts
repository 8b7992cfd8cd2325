// How the frames of a dance are cut for a file: at which pace, and whether the end leads to the beginning.

import { type Frame, FPS } from "../engine/types";
import { type Root, toLocalAll, toWorld } from "../sync/placement";

/** Paces that a file may have. */
export const PACES = [24, 30, 60] as const;

export interface Cut {
  /** Frames per second. */
  readonly fps: number;
  /** The last frame is the first again; what travels or turns goes on from there. */
  readonly loop: boolean;
}

type Shape = { positions: Float32Array };

/** Frames at FPS to frames at the cut's pace; the first and the last stay. */
export function cutClip(frames: readonly Pick<Frame, "positions" | "root">[], { fps, loop }: Cut): Shape[] {
  const closed: readonly Shape[] = loop ? closeLoop(frames) : frames;
  return fps === FPS ? closed.map(({ positions }) => ({ positions })) : atPace(closed, fps / FPS);
}

/** So many frames before the end are led to the beginning. */
const LEAD = 10;

/** Each vertex's way from the end to the beginning, seen from the body, is gone bit by bit. */
function closeLoop(frames: readonly Pick<Frame, "positions" | "root">[]): Shape[] {
  const last = frames.length - 1;
  const lead = Math.min(LEAD, last);
  if (lead < 1) return [...frames];
  const first = local(frames[0]);
  const gap = local(frames[last]).map((x, i) => first[i] - x);
  return frames.map((frame, f) => {
    const done = (f - (last - lead)) / lead;
    if (done <= 0) return frame;
    const share = done * done * (3 - 2 * done);
    const positions = toWorld(
      local(frame).map((x, i) => x + share * gap[i]),
      onGround(frame.root),
    );
    return { positions };
  });
}

/** The body's height is part of the pose. */
const onGround = ([x, , z, yaw]: Root): Root => [x, 0, z, yaw];
const local = ({ positions, root }: Pick<Frame, "positions" | "root">): Float32Array => toLocalAll(positions, onGround(root));

/** `pace` times as many frames. Between two frames vertices go along a Catmull-Rom curve. */
function atPace(frames: readonly Shape[], pace: number): Shape[] {
  const last = frames.length - 1;
  const steps = Math.max(1, Math.round(last * pace));
  if (last < 1) return [...frames];
  return Array.from({ length: steps + 1 }, (_, k) => {
    const at = (k * last) / steps;
    const f = Math.min(Math.floor(at), last - 1);
    const t = at - f;
    if (t === 0) return { positions: frames[f].positions };
    if (t === 1) return { positions: frames[f + 1].positions };
    const [b, c] = [frames[f].positions, frames[f + 1].positions];
    const [a, d] = [frames[f - 1]?.positions, frames[f + 2]?.positions];
    const positions = new Float32Array(b.length);
    for (let i = 0; i < positions.length; i++) {
      const way = c[i] - b[i];
      const into = a ? (c[i] - a[i]) / 2 : way;
      const out = d ? (d[i] - b[i]) / 2 : way;
      positions[i] = b[i] + t * (into + t * (3 * way - 2 * into - out + t * (into + out - 2 * way)));
    }
    return { positions };
  });
}
