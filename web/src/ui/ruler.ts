const STEPS = [5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
const LABEL_PX = 56;

/** Frames between two labels of the ruler, so that labels keep their distance. */
export function rulerStep(last: number, pixels: number): number {
  return STEPS.find((step) => (step / last) * pixels >= LABEL_PX) ?? 10_000;
}
