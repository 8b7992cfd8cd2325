/** One channel of sRGB, 0..1, as linear light. */
export function linear(c: number): number {
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

/** sRGB as linear light, within 0 and 1: bytes where one is above 1, else fractions. */
export function linearColors(values: ArrayLike<number>): Float32Array {
  let largest = 0;
  for (let k = 0; k < values.length; k++) if (values[k] > largest && Number.isFinite(values[k])) largest = values[k];
  const scale = largest > 1 ? 1 / 255 : 1;
  return Float32Array.from(values, (c) => linear(Math.min(Math.max(c * scale, 0), 1)));
}
