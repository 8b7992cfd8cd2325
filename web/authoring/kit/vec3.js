// Vectors as arrays of three numbers.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.sqrt(dot(a, a)); // Math.hypot is many times slower
export const distance = (a, b) => length(sub(a, b));
export const normalize = (a) => scale(a, 1 / length(a));
export const mix = (a, b, t) => a.map((v, i) => v + (b[i] - v) * t);
export const clamp = (x, low, high) => Math.min(high, Math.max(low, x));
export const smoothstep = (low, high, x) => {
  const t = clamp((x - low) / (high - low), 0, 1);
  return t * t * (3 - 2 * t);
};
