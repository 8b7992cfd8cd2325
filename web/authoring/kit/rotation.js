// Rotations as 3 x 3 matrices, row by row in nine numbers. Angles in degrees.
import { clamp, cross, dot, normalize, scale, sub } from "./vec3.js";

const radians = (degrees) => (degrees * Math.PI) / 180;
const degrees = (r) => (r * 180) / Math.PI;

export const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];
export function rotX(a) {
  const [c, s] = [Math.cos(radians(a)), Math.sin(radians(a))];
  return [1, 0, 0, 0, c, -s, 0, s, c];
}
export function rotY(a) {
  const [c, s] = [Math.cos(radians(a)), Math.sin(radians(a))];
  return [c, 0, s, 0, 1, 0, -s, 0, c];
}
export function rotZ(a) {
  const [c, s] = [Math.cos(radians(a)), Math.sin(radians(a))];
  return [c, -s, 0, s, c, 0, 0, 0, 1];
}
const times = (a, b) => [0, 3, 6].flatMap((r) => [0, 1, 2].map((c) => a[r] * b[c] + a[r + 1] * b[c + 3] + a[r + 2] * b[c + 6]));
export const multiply = (...matrices) => matrices.reduce(times);
export const transpose = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
export const rotate = (m, v) => [0, 3, 6].map((r) => m[r] * v[0] + m[r + 1] * v[1] + m[r + 2] * v[2]);

/** The rotation with columns x, y, z. */
export const fromColumns = (x, y, z) => [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];

/** The frame whose -y points along `down` and whose z is as near to `forward` as that allows. */
export function frameDown(down, forward) {
  const y = scale(normalize(down), -1);
  const z = normalize(sub(forward, scale(y, dot(forward, y))));
  return fromColumns(cross(y, z), y, z);
}

/** Degrees between two rotations. */
export function angleBetween(a, b) {
  const m = times(transpose(a), b);
  return degrees(Math.acos(clamp((m[0] + m[4] + m[8] - 1) / 2, -1, 1)));
}

/** Angles z, x, y with m = Rz Rx Ry; of the two equal triples the one nearer to `previous`, and without jumps by whole turns. */
export function toZxy(m, previous = [0, 0, 0]) {
  const x = degrees(Math.asin(clamp(m[7], -1, 1)));
  const first = [degrees(Math.atan2(-m[1], m[4])), x, degrees(Math.atan2(-m[6], m[8]))];
  const second = [first[0] + 180, 180 - x, first[2] + 180];
  const near = (triple) => triple.map((a, i) => a - 360 * Math.round((a - previous[i]) / 360));
  const cost = (triple) => triple.reduce((sum, a, i) => sum + Math.abs(a - previous[i]), 0);
  const options = [near(first), near(second)];
  return cost(options[0]) <= cost(options[1]) ? options[0] : options[1];
}
