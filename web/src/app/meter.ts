/** Milliseconds of the solver, as the status line shows them: the median of the last second, told at most twice a second. */
export class Meter {
  median: number | null = null;
  private readings: { at: number; ms: number }[] = [];
  private told = -Infinity;

  constructor(private readonly changed: () => void) {}

  add(ms: number): void {
    const now = performance.now();
    this.readings = this.readings.filter((reading) => now - reading.at < 1000);
    this.readings.push({ at: now, ms });
    if (now - this.told < 500) return;
    this.told = now;
    const sorted = this.readings.map((reading) => reading.ms).sort((a, b) => a - b);
    this.median = sorted[sorted.length >> 1] ?? null;
    this.changed();
  }
}
