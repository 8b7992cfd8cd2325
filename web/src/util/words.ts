/** Figures as people read them. */
export function figure(value: number, digits = 0): string {
  return value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });
}

export function count(n: number, one: string, many = `${one}s`): string {
  return `${figure(n)} ${n === 1 ? one : many}`;
}

export function seconds(value: number): string {
  return `${figure(value, 1)} s`;
}

/** "27 cm up, 31 cm right": a move in stage metres, largest parts only. */
export function move(delta: readonly [number, number, number]): string {
  const names = [
    ["right", "left"],
    ["up", "down"],
    ["forward", "back"],
  ] as const;
  const parts = delta
    .map((metres, axis) => ({ cm: Math.round(Math.abs(metres) * 100), word: names[axis]![metres >= 0 ? 0 : 1] }))
    .filter((part) => part.cm > 0);
  if (parts.length === 0) return "0 cm";
  return [parts.find((p) => p.word === "up" || p.word === "down"), ...parts.filter((p) => p.word !== "up" && p.word !== "down")]
    .filter((part) => part !== undefined)
    .map((part) => `${part.cm} cm ${part.word}`)
    .join(", ");
}

export function bytes(n: number): string {
  return n < 1_000_000 ? `${figure(Math.max(1, n / 1000))} kB` : `${figure(n / 1_000_000, 1)} MB`;
}

/** "3 hours ago"; days at most in numbers. */
export function ago(milliseconds: number): string {
  const minutes = milliseconds / 60_000;
  if (minutes < 1) return "just now";
  if (minutes < 60) return `${count(Math.floor(minutes), "minute")} ago`;
  if (minutes < 60 * 24) return `${count(Math.floor(minutes / 60), "hour")} ago`;
  return `${count(Math.floor(minutes / 60 / 24), "day")} ago`;
}

/** File name without its folders and its last extension. */
export function stem(path: string): string {
  return path.replace(/^.*\//, "").replace(/\.[^.]+$/, "");
}

/** "a dinosaur", "an egg" */
export function withArticle(noun: string): string {
  return `${/^[aeiou]/i.test(noun) ? "an" : "a"} ${noun}`;
}
