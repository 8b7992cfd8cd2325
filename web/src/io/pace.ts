// At which pace the frames of a dance go into a file.

import { type Frame, FPS } from "../engine/types";

/** Paces that a file may have: frames per second. */
export const PACES = [24, 30, 60] as const;

type Shape = Pick<Frame, "positions">;

/** Frames at FPS of a dance that goes `speed` times as fast, so many a second; the first and the last stay. */
export function paced(frames: readonly Shape[], fps: number, speed: number): Shape[] {
  return fps === FPS * speed ? frames.map(({ positions }) => ({ positions })) : atPace(frames, fps / (FPS * speed));
}

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
