// Polygons of files as triangles.

import { Earcut } from "three/src/extras/Earcut.js";

/** Cutting ears can take the square of the corners; faces with more are fans. */
const MOST_CORNERS = 200;

/**
 * Adds the triangles of one polygon's corners, which lie at `vertices` of `positions` (x 3): a fan where it is convex, else its ears
 * are cut in the plane that it lies in most.
 */
export function addPolygon(out: number[], corners: ArrayLike<number>, vertices: ArrayLike<number>, positions: ArrayLike<number>): void {
  const n = corners.length;
  if (n > 3 && n <= MOST_CORNERS) {
    const plane = planeOf(vertices, positions);
    if (plane && !isConvex(vertices, positions, plane)) {
      const ears = cutEars(vertices, positions, plane);
      // Of a polygon that crosses itself the cutter may make less.
      if (ears.length === 3 * (n - 2)) {
        for (const k of ears) out.push(corners[k]);
        return;
      }
    }
  }
  for (let k = 1; k + 1 < n; k++) out.push(corners[0], corners[k], corners[k + 1]);
}

/** The two axes that the polygon is seen along, in the order in which it turns to the left; null if it has no area. */
type Plane = readonly [u: number, v: number];

/** By Newell's normal. */
function planeOf(loop: ArrayLike<number>, p: ArrayLike<number>): Plane | null {
  const normal = [0, 0, 0];
  const origin = 3 * loop[0];
  for (let k = 1; k + 1 < loop.length; k++) {
    const [a, b] = [3 * loop[k], 3 * loop[k + 1]];
    for (let d = 0; d < 3; d++) {
      const [u, v] = [(d + 1) % 3, (d + 2) % 3];
      normal[d] += (p[a + u] - p[origin + u]) * (p[b + v] - p[origin + v]) - (p[a + v] - p[origin + v]) * (p[b + u] - p[origin + u]);
    }
  }
  const size = normal.map(Math.abs);
  const d = size.indexOf(Math.max(...size));
  if (!(size[d] > 0)) return null;
  return normal[d] > 0 ? [(d + 1) % 3, (d + 2) % 3] : [(d + 2) % 3, (d + 1) % 3];
}

function isConvex(loop: ArrayLike<number>, p: ArrayLike<number>, [u, v]: Plane): boolean {
  const n = loop.length;
  for (let k = 0; k < n; k++) {
    const [a, b, c] = [3 * loop[k], 3 * loop[(k + 1) % n], 3 * loop[(k + 2) % n]];
    if ((p[b + u] - p[a + u]) * (p[c + v] - p[b + v]) < (p[b + v] - p[a + v]) * (p[c + u] - p[b + u])) return false;
  }
  return true;
}

function cutEars(loop: ArrayLike<number>, p: ArrayLike<number>, [u, v]: Plane): number[] {
  const flat: number[] = [];
  // From the first corner: far coordinates would lose the difference.
  for (let k = 0; k < loop.length; k++) flat.push(p[3 * loop[k] + u] - p[3 * loop[0] + u], p[3 * loop[k] + v] - p[3 * loop[0] + v]);
  return turnedLeft(Earcut.triangulate(flat), flat);
}

function turnedLeft(triangles: number[], flat: readonly number[]): number[] {
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
    const turn = (flat[b] - flat[a]) * (flat[c + 1] - flat[a + 1]) - (flat[b + 1] - flat[a + 1]) * (flat[c] - flat[a]);
    if (turn < 0) [triangles[t + 1], triangles[t + 2]] = [triangles[t + 2], triangles[t + 1]];
  }
  return triangles;
}
