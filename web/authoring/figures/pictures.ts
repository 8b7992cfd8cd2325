// Draws one moment after another of a character or of the mannequin, as the page would, into one strip.

import type { Workspace } from "../../src/sync/workspace";
import { Mannequin } from "../../src/viewport/mannequin";
import { describeJoints } from "../../src/skeleton/pair-joints";
import { solvedDance } from "./dance";
import { drawMoments, onTheSpot, theModel } from "./moments";
import type { Figure } from "./moments";

const FRAMES = 8;
const PIXELS = 104;
/** A strip is at most so large. */
const BYTES = 8000;

interface Performance {
  /** Folder that the project lies in. */
  folder: string;
  project: string;
  motion: string;
  who: "model" | "human";
}

declare global {
  interface Window {
    /** A strip of FRAMES squares on a clear ground, as a data URL. */
    drawPicture: (performance: Performance) => Promise<string>;
  }
}

window.drawPicture = async ({ folder, project, motion, who }) => {
  const { model, document, workspace } = await solvedDance(folder, project, motion);
  const strip = drawStrip(who === "model" ? await theModel(model, document, workspace) : theHuman(workspace));
  workspace.close();
  return strip;
};

function theHuman({ motion }: Workspace): Figure {
  const { joints, positions, frames } = motion!;
  const figure = new Mannequin({ joints: describeJoints(joints), parents: Int32Array.from(joints, (joint) => joint.parent) });
  const size = 3 * joints.length;
  return {
    group: figure.group,
    frames,
    places: (frame) => positions.subarray(size * frame, size * (frame + 1)),
    show: (places) => figure.setPose(places),
  };
}

function drawStrip({ group, frames, places, show }: Figure): string {
  const first = mostTelling(frames, places);
  const moments = Array.from({ length: FRAMES }, (_, k) => onTheSpot(places((first + Math.round((k * frames) / FRAMES)) % frames)));
  const canvas = drawMoments(group, show, moments, PIXELS);
  const context = canvas.getContext("2d")!;
  coarsenEdges(context);
  return lightEnough(canvas);
}

/** WebP keeps how clear each pixel is without loss, and as many bytes as for all else: nine steps look the same. */
function coarsenEdges(context: CanvasRenderingContext2D): void {
  const image = context.getImageData(0, 0, context.canvas.width, context.canvas.height);
  for (let i = 3; i < image.data.length; i += 4) image.data[i] = (Math.round((image.data[i]! * 8) / 255) * 255) / 8;
  context.putImageData(image, 0, 0);
}

/** As good as the bytes allow. */
function lightEnough(canvas: HTMLCanvasElement): string {
  for (let quality = 0.86; quality > 0.2; quality -= 0.04) {
    const url = canvas.toDataURL("image/webp", quality);
    if (0.75 * url.length <= BYTES) return url;
  }
  throw new Error(`The strip takes more than ${BYTES} bytes.`);
}

/** The frame that differs most from the mean of all: it stands for the motion while nothing moves. */
function mostTelling(frames: number, places: (frame: number) => Float32Array): number {
  const all = Array.from({ length: frames }, (_, frame) => onTheSpot(places(frame)));
  const middle = all[0]!.map((_, i) => all.reduce((sum, one) => sum + one[i]!, 0) / frames);
  const strangeness = all.map((one) => one.reduce((sum, value, i) => sum + (value - middle[i]!) ** 2, 0));
  return strangeness.indexOf(Math.max(...strangeness));
}
