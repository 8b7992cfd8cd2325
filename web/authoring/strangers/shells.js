// A mesh of shells: each call adds a piece of its own, closed and wound outwards unless it says otherwise.
import { add, cross, dot, length, mix, normalize, scale, sub } from "../kit/vec3.js";

/** Two unit vectors across `along`. */
function across(along) {
  const helper = Math.abs(along[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  const u = normalize(cross(helper, along));
  return [u, cross(along, u)];
}

export class Shells {
  positions = [];
  faces = [];
  parts = [];

  /** Everything that `build` adds is one part. */
  part(name, build) {
    const first = this.faces.length;
    build();
    this.parts.push({ name, first, count: this.faces.length - first });
    return this;
  }

  vertices(list) {
    const first = this.positions.length;
    this.positions.push(...list);
    return first;
  }

  /** Vertices and triangles of another mesh. */
  mesh(name, { vertices, triangles }) {
    return this.part(name, () => {
      const first = this.vertices(vertices);
      for (const triangle of triangles) this.faces.push(triangle.map((v) => v + first));
    });
  }

  /** Rings of `around` vertices about a line; ends that are null stay open. */
  lathe(name, rings, around, low, high) {
    return this.part(name, () => {
      const first = this.vertices(
        rings.flatMap(({ centre, radius, u, v }) =>
          Array.from({ length: around }, (_, k) => {
            const angle = (2 * Math.PI * k) / around;
            return add(centre, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
          }),
        ),
      );
      const at = (ring, k) => first + ring * around + (k % around);
      for (let r = 0; r + 1 < rings.length; r++)
        for (let k = 0; k < around; k++)
          this.faces.push([at(r, k), at(r, k + 1), at(r + 1, k + 1)], [at(r, k), at(r + 1, k + 1), at(r + 1, k)]);
      const cap = (place, ring, flip) => {
        if (!place) return;
        const tip = this.vertices([place]);
        for (let k = 0; k < around; k++) this.faces.push(flip ? [tip, at(ring, k + 1), at(ring, k)] : [tip, at(ring, k), at(ring, k + 1)]);
      };
      cap(low, 0, true);
      cap(high, rings.length - 1, false);
    });
  }

  /** From a to b, radius ra to rb, with round ends. open: without them. */
  capsule(name, a, b, ra, rb = ra, { around = 10, open = false } = {}) {
    const along = normalize(sub(b, a));
    const [u, v] = across(along);
    const ring = (centre, radius) => ({ centre, radius, u, v });
    const far = length(sub(b, a));
    const middle = Math.max(1, Math.round(far / (2 * Math.max(ra, rb, 0.03))));
    const body = Array.from({ length: middle + 1 }, (_, i) => ring(mix(a, b, i / middle), ra + ((rb - ra) * i) / middle));
    if (open) return this.lathe(name, body, around, null, null);
    const low = [0.85, 0.5].map((h) => ring(sub(a, scale(along, ra * h)), ra * Math.sqrt(1 - h * h)));
    const high = [0.5, 0.85].map((h) => ring(add(b, scale(along, rb * h)), rb * Math.sqrt(1 - h * h)));
    return this.lathe(name, [...low, ...body, ...high], around, sub(a, scale(along, ra)), add(b, scale(along, rb)));
  }

  ball(name, centre, radii, { around = 12, rings = 7 } = {}) {
    const [rx, ry, rz] = typeof radii === "number" ? [radii, radii, radii] : radii;
    return this.part(name, () => {
      const first = this.positions.length;
      const unit = new Shells();
      const list = Array.from({ length: rings }, (_, i) => {
        const angle = Math.PI * ((i + 1) / (rings + 1)) - Math.PI / 2;
        return { centre: [0, Math.sin(angle), 0], radius: Math.cos(angle), u: [0, 0, 1], v: [1, 0, 0] };
      });
      unit.lathe(name, list, around, [0, -1, 0], [0, 1, 0]);
      this.vertices(unit.positions.map(([x, y, z]) => [centre[0] + rx * x, centre[1] + ry * y, centre[2] + rz * z]));
      for (const face of unit.faces) this.faces.push(face.map((w) => w + first));
    });
  }

  /** Axis-aligned, or turned by a matrix about its centre; `turn` maps a vector. */
  box(name, centre, half, turn = (x) => x) {
    return this.part(name, () => {
      const first = this.vertices(
        Array.from({ length: 8 }, (_, c) =>
          add(centre, turn([c & 1 ? half[0] : -half[0], c & 2 ? half[1] : -half[1], c & 4 ? half[2] : -half[2]])),
        ),
      );
      for (const [a, b, c, d] of [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
      ])
        this.faces.push([first + a, first + b, first + c], [first + a, first + c, first + d]);
    });
  }

  /** A thin sheet: rows of equally many places. */
  sheet(name, rows) {
    return this.part(name, () => {
      const wide = rows[0].length;
      const first = this.vertices(rows.flat());
      for (let r = 0; r + 1 < rows.length; r++)
        for (let k = 0; k + 1 < wide; k++) {
          const [a, b, c, d] = [r * wide + k, r * wide + k + 1, (r + 1) * wide + k + 1, (r + 1) * wide + k].map((w) => first + w);
          this.faces.push([a, b, c], [a, c, d]);
        }
    });
  }

  /** A rod with a round cross-section of few corners. */
  rod(name, a, b, radius) {
    return this.capsule(name, a, b, radius, radius, { around: 5 });
  }
}

/** The sign of what a closed mesh holds. */
export const volumeOf = ({ positions, faces }) =>
  faces.reduce((sum, [a, b, c]) => sum + dot(positions[a], cross(positions[b], positions[c])), 0) / 6;
