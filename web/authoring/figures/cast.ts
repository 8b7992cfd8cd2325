// One character's dance to one motion: eight moments, and how good it is in figures.

import type { Frame, Performance } from "../../src/engine/types";
import { STAGE_HEIGHT } from "../../src/util/constants";
import { solvedDance } from "./dance";
import { drawMoments, onTheSpot, theModel } from "./moments";

const FRAMES = 8;
const PIXELS = 128;

/** Lengths in heights of the model. */
interface Quality {
  /** Per second: mean horizontal speed of points that stand. */
  slip: number;
  /** How far the lowest vertex ever lies below the ground. */
  penetration: number;
  /** Least and most volume over the rest's. */
  volume: [number, number];
  /** Per second squared: the most of any point, in the body's frame. */
  acceleration: number;
  /** Root mean square of how far frames are from the poses, 0 taught and 1 guessed. */
  guesswork: number;
}

declare global {
  interface Window {
    castRow: (dance: { folder: string; project: string; motion: string }) => Promise<{ strip: string; quality: Quality }>;
    /** Strips below each other, as a data URL. */
    castSheet: (strips: string[]) => Promise<string>;
  }
}

window.castRow = async ({ folder, project, motion }) => {
  const { model, document, workspace } = await solvedDance(folder, project, motion);
  const { group, show, places, frames } = await theModel(model, document, workspace);
  const moments = Array.from({ length: FRAMES }, (_, k) => onTheSpot(places(Math.floor(((k + 0.5) * frames) / FRAMES))));
  const strip = drawMoments(group, show, moments, PIXELS).toDataURL("image/png");
  const quality = qualityOf(workspace.performance!, await workspace.vertexFrames({}));
  workspace.close();
  return { strip, quality };
};

window.castSheet = async (strips) => {
  const pictures = await Promise.all(strips.map(async (url) => createImageBitmap(await (await fetch(url)).blob())));
  const canvas = document.createElement("canvas");
  canvas.width = FRAMES * PIXELS;
  canvas.height = PIXELS * pictures.length;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#e3ecf0";
  context.fillRect(0, 0, canvas.width, canvas.height);
  pictures.forEach((picture, row) => context.drawImage(picture, 0, row * PIXELS));
  return canvas.toDataURL("image/webp", 0.8);
};

function qualityOf({ controls, frames, slip, coverage }: Performance, made: readonly Frame[]): Quality {
  let lowest = 0;
  let [least, most] = [Infinity, -Infinity];
  for (const { positions, volumeRatio } of made) {
    for (let i = 1; i < positions.length; i += 3) lowest = Math.min(lowest, positions[i]!);
    if (volumeRatio !== null) [least, most] = [Math.min(least, volumeRatio), Math.max(most, volumeRatio)];
  }
  const size = controls.length / frames;
  let acceleration = 0;
  for (let i = size; i + size + 2 < controls.length; i += 3) {
    const bend = [0, 1, 2].map((k) => controls[i + k - size]! - 2 * controls[i + k]! + controls[i + k + size]!);
    acceleration = Math.max(acceleration, Math.hypot(...bend) * 900);
  }
  return {
    slip: slip.after / STAGE_HEIGHT,
    penetration: -lowest / STAGE_HEIGHT,
    volume: [least, most],
    acceleration: acceleration / STAGE_HEIGHT,
    guesswork: Math.sqrt(coverage.reduce((sum, value) => sum + value * value, 0) / frames),
  };
}
