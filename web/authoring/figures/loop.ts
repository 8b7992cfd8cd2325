// Several characters dance to one motion side by side: a short loop as a GIF.

import { GIFEncoder, applyPalette, quantize } from "gifenc";
import { solvedDance } from "./dance";
import { drawMoments, onTheSpot, theModel } from "./moments";

interface Loop {
  dancers: { folder: string; project: string }[];
  motion: string;
  /** Of one dancer's square. */
  pixels: number;
  /** Frames of the motion for one of the loop. */
  every: number;
}

declare global {
  interface Window {
    /** A GIF in base 64. */
    drawLoop: (loop: Loop) => Promise<string>;
  }
}

window.drawLoop = async ({ dancers, motion, pixels, every }) => {
  const strips: HTMLCanvasElement[] = [];
  for (const { folder, project } of dancers) {
    const { model, document, workspace } = await solvedDance(folder, project, motion);
    const { group, show, places, frames } = await theModel(model, document, workspace);
    const moments = Array.from({ length: Math.floor(frames / every) }, (_, k) => onTheSpot(places(k * every)));
    strips.push(drawMoments(group, show, moments, pixels));
    workspace.close();
  }
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [pixels * strips.length, pixels];
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  const pictures = Array.from({ length: Math.min(...strips.map(({ width }) => width / pixels)) }, (_, k) => {
    context.fillStyle = "#e3ecf0";
    context.fillRect(0, 0, canvas.width, canvas.height);
    strips.forEach((strip, n) => context.drawImage(strip, k * pixels, 0, pixels, pixels, n * pixels, 0, pixels, pixels));
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  });
  // One palette, from every eighth picture: the colours do not flicker.
  const some = pictures.filter((_, k) => k % 8 === 0);
  const palette = quantize(Uint8ClampedArray.from(some.flatMap((data) => [...data])), 256);
  const gif = GIFEncoder();
  pictures.forEach((data, k) =>
    gif.writeFrame(applyPalette(data, palette), canvas.width, canvas.height, { ...(k === 0 && { palette }), delay: (1000 * every) / 30 }),
  );
  gif.finish();
  return btoa(Array.from(gif.bytes(), (byte: number) => String.fromCharCode(byte)).join(""));
};
