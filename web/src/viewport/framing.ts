// How far the camera stands and how the picture is shifted so that figures fill the free part of the stage. Pixels are CSS pixels.

import type { Insets, StageView } from "../stage/port";

export const FIELD_OF_VIEW = 28;
/** The camera looks at this height over the ground, from a little to the right and above. */
export const TARGET_HEIGHT = 0.8;
export const AZIMUTH = 0.1;
export const NEAREST = 5.2;
export const ELEVATION = Math.asin((1.5 - TARGET_HEIGHT) / NEAREST);

/** From where: radians further around than AZIMUTH, and upwards. */
export const VIEWS: Readonly<Record<StageView, readonly [around: number, up: number]>> = {
  front: [0, ELEVATION],
  "three-quarter": [0.7, 0.35],
  side: [Math.PI / 2 - AZIMUTH, ELEVATION],
  top: [0, Math.PI / 2],
};
/** Radians a second of a camera that goes around by itself. */
export const TURNING = (2 * Math.PI) / 16;

const FEET = 0.85;
const HEADROOM = 0.08;
const BREADTH = 0.92;
/** Metres from the front to the back of figures that stand side by side. */
const ABREAST = 1;
const HALF_TANGENT = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);

export interface View {
  width: number;
  height: number;
  insets: Insets;
}

/** Box around the figures, metres, standing on the ground under the target. */
export interface Content {
  width: number;
  height: number;
  depth: number;
}

export interface Framing {
  /** Metres from the target. */
  distance: number;
  /** Pixels by which the target moves right and down from the middle of the stage. */
  shiftX: number;
  shiftY: number;
}

/** Pixels per metre at some metres before the camera. */
export function pixelsPerMetre(viewHeight: number, depth: number): number {
  return viewHeight / (2 * depth * HALF_TANGENT);
}

/** The rectangle that cards leave free; never less than a quarter of the stage. */
export function freeRectangle({ width, height, insets }: View): { x: number; y: number; width: number; height: number } {
  const span = (size: number, before: number, after: number): [number, number] => {
    const free = size - before - after;
    return free >= size / 4 ? [before, free] : [0, size];
  };
  const [x, w] = span(width, insets.left, insets.right);
  const [y, h] = span(height, insets.top, insets.bottom);
  return { x, y, width: w, height: h };
}

/** Feet on one line at 85 % of the free height, heads below its top, both figures between its sides. */
export function frame(view: View, content: Content): Framing {
  const free = freeRectangle(view);
  const rise = content.height * Math.cos(ELEVATION) * view.height;
  const nearer = (content.depth - ABREAST) / 2;
  const tall = rise / (2 * HALF_TANGENT * (FEET - HEADROOM) * free.height) + nearer;
  const broad = (content.width * view.height) / (2 * HALF_TANGENT * BREADTH * free.width) + content.depth / 2;
  const distance = Math.max(NEAREST, tall, broad);
  const feetDepth = distance + TARGET_HEIGHT * Math.sin(ELEVATION);
  const feetBelow = TARGET_HEIGHT * Math.cos(ELEVATION) * pixelsPerMetre(view.height, feetDepth);
  return { distance, shiftX: free.x + free.width / 2 - view.width / 2, shiftY: free.y + FEET * free.height - feetBelow - view.height / 2 };
}

/** The box as it is seen by a camera that turned around it by some radians. */
export function turned({ width, height, depth }: Content, angle: number): Content {
  const [c, s] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
  return { width: c * width + s * depth, height, depth: s * width + c * depth };
}

/** Where the two figures stand side by side, metres from the middle, so that their boxes do not touch. */
export function lanes(humanWidth: number, modelWidth: number): { human: number; model: number; width: number } {
  const gap = 0.3;
  const width = humanWidth + gap + modelWidth;
  return { human: (humanWidth - width) / 2, model: (width - modelWidth) / 2, width };
}
