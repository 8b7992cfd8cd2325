import { html, type TemplateResult } from "lit";

/** Colour of a point by its number (from 1): the seven repeat, with a square body from the eighth on. */
export function pointStyle(number: number): string {
  const k = ((number - 1) % 7) + 1;
  return `--c:var(--p${k});--on-c:var(--on-p${k})`;
}

/** The numbered mark of a point in lists, rows and the status line. */
export function badge(number: number, options: { now?: boolean; weak?: boolean } = {}): TemplateResult {
  const shape = `pt ${number > 7 ? "square" : ""} ${options.now ? "now" : ""} ${options.weak ? "weak" : ""}`;
  return html`<span class=${shape} style=${pointStyle(number)}>${number}</span>`;
}
