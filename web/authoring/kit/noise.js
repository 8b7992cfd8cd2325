// Smooth noise in space, the same each time.

function hash(i, j, k) {
  let h = Math.imul(i, 374761393) ^ Math.imul(j, 668265263) ^ Math.imul(k, 2147483647 ^ 0x5bd1e995);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 2 ** 31 - 1;
}

const fade = (t) => t * t * t * (t * (6 * t - 15) + 10);
const lerp = (a, b, t) => a + (b - a) * t;
const row = (i, j, k, u) => lerp(hash(i, j, k), hash(i + 1, j, k), u);

/** Values of -1 to 1 on a grid of 1 m, joined smoothly. */
export function noise(x, y, z) {
  const i = Math.floor(x);
  const j = Math.floor(y);
  const k = Math.floor(z);
  const u = fade(x - i);
  const v = fade(y - j);
  return lerp(lerp(row(i, j, k, u), row(i, j + 1, k, u), v), lerp(row(i, j, k + 1, u), row(i, j + 1, k + 1, u), v), fade(z - k));
}
