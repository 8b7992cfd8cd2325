// A triangle mesh in the making.
import { add, distance, mix, scale } from "./vec3.js";

/** Vertices, and triangles that each carry a part's name and three texture coordinates of that part (not yet in the atlas). */
export class Surface {
  vertices = [];
  faces = [];

  vertex(position) {
    return this.vertices.push(position) - 1;
  }
  /** corners: [vertex, u, v] in counter-clockwise order seen from outside. */
  triangle(part, ...corners) {
    this.faces.push({ part, v: corners.map((c) => c[0]), uv: corners.map((c) => [c[1], c[2]]) });
  }
  /** Removes the triangles whose corners all belong to `patch`. */
  removePatch(patch) {
    this.faces = this.faces.filter((f) => !f.v.every((v) => patch.includes(v)));
  }
  /** Drops unused vertices. */
  compact() {
    const used = new Map();
    for (const f of this.faces) f.v = f.v.map((v) => used.get(v) ?? (used.set(v, used.size), used.size - 1));
    this.vertices = [...used.keys()].map((v) => this.vertices[v]);
  }
}

/** Joins two loops that run the same way around, always by the shorter edge. */
export function stitch(surface, part, outer, inner, corner) {
  let i = 0;
  let j = 0;
  const p = (v) => surface.vertices[v];
  while (i < outer.length || j < inner.length) {
    const a = outer[i % outer.length];
    const b = inner[j % inner.length];
    const a2 = outer[(i + 1) % outer.length];
    const b2 = inner[(j + 1) % inner.length];
    const advanceOuter = j === inner.length || (i < outer.length && distance(p(a2), p(b)) <= distance(p(a), p(b2)));
    if (advanceOuter) {
      surface.triangle(part, corner(a), corner(a2), corner(b));
      i++;
    } else {
      surface.triangle(part, corner(a), corner(b2), corner(b));
      j++;
    }
  }
}

/** Rotates a loop so that it starts at the vertex nearest to `to`. */
export function startAt(surface, loop, to) {
  const d = loop.map((v) => distance(surface.vertices[v], to));
  const k = d.indexOf(Math.min(...d));
  return [...loop.slice(k), ...loop.slice(0, k)];
}

/** Moves some vertices halfway to the mean of their neighbours, a few times: rounds the corner where a limb leaves the body. */
export function relax(surface, moving, rounds) {
  const neighbours = new Map(moving.map((v) => [v, new Set()]));
  for (const f of surface.faces) for (const v of f.v) if (neighbours.has(v)) f.v.forEach((w) => w !== v && neighbours.get(v).add(w));
  for (let k = 0; k < rounds; k++) {
    const next = moving.map((v) => {
      const around = [...neighbours.get(v)];
      const mean = scale(
        around.reduce((sum, w) => add(sum, surface.vertices[w]), [0, 0, 0]),
        1 / around.length,
      );
      return mix(surface.vertices[v], mean, 0.5);
    });
    moving.forEach((v, i) => (surface.vertices[v] = next[i]));
  }
}
