// The line between the two ends of a pair, as an SVG path: a low arch, as a person would draw it.

export interface Point {
  x: number;
  y: number;
}

/** The middle rises over the chord by a sixth of its length, at most 64 px; a short or steep line stays nearly straight. */
export function arcPath(a: Point, b: Point): string {
  const [c, d] = arcControls(a, b);
  const at = (p: Point): string => `${p.x.toFixed(1)} ${p.y.toFixed(1)}`;
  return `M${at(a)}C${at(c)} ${at(d)} ${at(b)}`;
}

export function arcControls(a: Point, b: Point): [Point, Point] {
  const lift = Math.min(64, Math.abs(b.x - a.x) / 6) / 0.75; // a cubic reaches three quarters of its controls' height
  const between = (t: number): Point => ({ x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) - lift });
  return [between(0.3), between(0.7)];
}

export function arcPoint(a: Point, b: Point, t: number): Point {
  const [c, d] = arcControls(a, b);
  const s = 1 - t;
  const mix = (k: "x" | "y"): number => s ** 3 * a[k] + 3 * s * s * t * c[k] + 3 * s * t * t * d[k] + t ** 3 * b[k];
  return { x: mix("x"), y: mix("y") };
}
