export interface Shape {
  positions: Float32Array;
  index: Uint32Array;
}

/** Two squares hinged on the z axis, the second bent up by an angle. */
export function hinge(degrees: number): Shape {
  const bend = (degrees * Math.PI) / 180;
  const x = Math.cos(bend);
  const y = Math.sin(bend);
  const positions = Float32Array.of(-1, 0, 0, 0, 0, 0, 0, 0, 1, -1, 0, 1, x, y, 0, x, y, 1);
  return { positions, index: Uint32Array.of(0, 3, 2, 0, 2, 1, 1, 2, 5, 1, 5, 4) };
}

/** A closed sphere of radius 1, counter-clockwise from outside. */
export function sphere(around: number, rings: number): Shape {
  const points: number[] = [0, 1, 0];
  for (let r = 1; r < rings; r++) {
    for (let a = 0; a < around; a++) {
      const [t, u] = [(Math.PI * r) / rings, (2 * Math.PI * a) / around];
      points.push(Math.sin(t) * Math.cos(u), Math.cos(t), Math.sin(t) * Math.sin(u));
    }
  }
  points.push(0, -1, 0);
  const last = points.length / 3 - 1;
  const at = (r: number, a: number): number => 1 + (r - 1) * around + (a % around);
  const index: number[] = [];
  for (let a = 0; a < around; a++) {
    index.push(0, at(1, a + 1), at(1, a), last, at(rings - 1, a), at(rings - 1, a + 1));
    for (let r = 1; r < rings - 1; r++) index.push(at(r, a), at(r, a + 1), at(r + 1, a), at(r, a + 1), at(r + 1, a + 1), at(r + 1, a));
  }
  return { positions: Float32Array.from(points), index: Uint32Array.from(index) };
}
