// Colours and shapes to paint with.
import { clamp, mix } from "./vec3.js";

export const hex = (text) => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
export const over = (under, colour, alpha) => mix(under, colour, clamp(alpha, 0, 1));
/** Inside an ellipse, turned by `degrees` counter-clockwise. */
export function inEllipse(x, y, [cx, cy], [rx, ry], degrees = 0) {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return ((c * (x - cx) + s * (y - cy)) / rx) ** 2 + ((-s * (x - cx) + c * (y - cy)) / ry) ** 2 < 1;
}
/** Distance to a line through points, in any dimension. */
export function toPath(p, path) {
  let best = Infinity;
  for (let i = 1; i < path.length; i++) {
    const [a, b] = [path[i - 1], path[i]];
    const d = b.map((v, k) => v - a[k]);
    const t = clamp(d.reduce((s, v, k) => s + v * (p[k] - a[k]), 0) / d.reduce((s, v) => s + v * v, 0), 0, 1);
    best = Math.min(best, Math.hypot(...d.map((v, k) => p[k] - a[k] - t * v)));
  }
  return best;
}
/** Points of an arc from one end to the other that sags by `depth` in the middle. */
export const smile = ([x0, y0], [x1, y1], depth, n = 12) =>
  Array.from({ length: n + 1 }, (_, i) => [x0 + ((x1 - x0) * i) / n, y0 + ((y1 - y0) * i) / n - depth * (1 - ((2 * i) / n - 1) ** 2)]);
