// One character's dance to one motion: eight moments, and how good it is in figures.

import type { Frame, Performance } from "../../src/engine/types";
import { pointJoints } from "../../src/sync/pairing";
import { meshInput } from "../../src/sync/translate";
import { STAGE_HEIGHT } from "../../src/util/constants";
import { Crossings } from "./crossings";
import { type Dance, solvedDance } from "./dance";
import { type Life, lifeOf } from "./life";
import { drawMoments, onTheSpot, theModel } from "./moments";

const FRAMES = 8;
const PIXELS = 128;

/** Frames apart in which pairs of triangles are counted. */
const CROSSINGS_EVERY = 4;

/** Lengths in heights of the model. */
interface Quality extends Life {
  /** How far the lowest vertex ever lies below the ground. */
  penetration: number;
  /** Least and most volume over the rest's. */
  volume: [number, number];
  /** Per second squared: the most of any point, in the body's frame. */
  acceleration: number;
  /** Root mean square of how far frames are from the poses, 0 taught and 1 guessed. */
  guesswork: number;
  /** The most pairs of triangles that cross and do not at rest. */
  crossings: number;
}

declare global {
  interface Window {
    /** strip: null unless it is to be drawn. */
    castRow: (dance: {
      folder: string;
      project: string;
      motion: string;
      draw: boolean;
    }) => Promise<{ strip: string | null; quality: Quality }>;
    /** Strips below each other, as a data URL. */
    castSheet: (strips: string[]) => Promise<string>;
  }
}

window.castRow = async ({ folder, project, motion, draw }) => {
  const dance = await solvedDance(folder, project, motion);
  const strip = draw ? await stripOf(dance) : null;
  const { model, document, workspace } = dance;
  const made = await workspace.vertexFrames({});
  const places = made.map(({ positions }) => positions);
  const { positions: rest, faces } = meshInput(model, document.mesh);
  const crossings = new Crossings(rest, faces);
  const quality = {
    ...qualityOf(workspace.performance!, made),
    ...lifeOf(workspace.motion!, workspace.performance!, pointJoints(document, workspace.motion!), rest, faces, places),
    crossings: Math.max(...places.filter((_, f) => f % CROSSINGS_EVERY === 0).map((frame) => crossings.since(frame))),
  };
  workspace.close();
  return { strip, quality };
};

async function stripOf({ model, document, workspace }: Dance): Promise<string> {
  const { group, show, places, frames } = await theModel(model, document, workspace);
  const moments = Array.from({ length: FRAMES }, (_, k) => onTheSpot(places(Math.floor(((k + 0.5) * frames) / FRAMES))));
  return drawMoments(group, show, moments, PIXELS).toDataURL("image/png");
}

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

function qualityOf({ controls, frames, coverage }: Performance, made: readonly Frame[]): Omit<Quality, keyof Life | "crossings"> {
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
    penetration: -lowest / STAGE_HEIGHT,
    volume: [least, most],
    acceleration: acceleration / STAGE_HEIGHT,
    guesswork: Math.sqrt(coverage.reduce((sum, value) => sum + value * value, 0) / frames),
  };
}
