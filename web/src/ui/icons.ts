import { svg, html, type TemplateResult } from "lit";

const drawings = {
  undo: svg`<path d="M8 5 4 9l4 4"/><path d="M4 9h8.5a5 5 0 0 1 0 10H8"/>`,
  redo: svg`<path d="m16 5 4 4-4 4"/><path d="M20 9h-8.5a5 5 0 0 0 0 10H16"/>`,
  help: svg`<path d="M9 9.2a3 3 0 1 1 4.4 2.7c-1 .5-1.4 1-1.4 2.1"/><path d="M12 17.5v.01"/><circle cx="12" cy="12" r="9"/>`,
  model: svg`
    <path d="M12 3.2c4.6 0 7.6 2.6 7.6 6.6 0 2.3-1 3.4-1 5.4 0 3.4-2.7 5.6-6.6 5.6s-6.9-2.2-6.9-5.8c0-2-.7-3-.7-5.2 0-4 3-6.6 7.6-6.6Z"/>
    <path d="M8.3 9.2c.3-1.4 1.3-2.3 2.7-2.5"/>`,
  motion: svg`<path d="M3 19c1.8-7.5 4.6-11.6 8-11.6 3 0 5 3 6.2 8" stroke-dasharray="2.6 3.2"/>
    <circle cx="18.4" cy="17.4" r="3.2" fill="currentColor"/><path d="M2.5 21h19"/>`,
  points: svg`<circle cx="12" cy="6" r="3.4"/><circle cx="5.8" cy="17.2" r="3.4"/>
    <circle cx="18.2" cy="17.2" r="3.4" fill="currentColor"/>`,
  poses: svg`<path d="M12 3.5 20.5 12 12 20.5 3.5 12Z"/><path d="M12 8.5 15.5 12 12 15.5 8.5 12Z" fill="currentColor"/>`,
  scale: svg`<path d="M4 20V4m0 0h5M4 20h5M4 12h3M4 8h2.5M4 16h2.5"/><path d="M16 4v16m-3.5-12.5L16 4l3.5 3.5m-7 9L16 20l3.5-3.5"/>`,
  close: svg`<path d="m6.5 6.5 11 11m0-11-11 11"/>`,
  view: svg`<path d="M3 7h11v10H3Zm11 4 7-3.5v9L14 13"/>`,
  fit: svg`<path d="M4 9V4h5m6 0h5v5m0 6v5h-5m-6 0H4v-5"/>`,
  previous: svg`<path d="M18 6v12l-8-6Z" fill="currentColor"/><path d="M6 6.5v11"/>`,
  next: svg`<path d="M6 6v12l8-6Z" fill="currentColor"/><path d="M18 6.5v11"/>`,
  loop: svg`<path d="M17 3.5 20 6.5l-3 3"/><path d="M20 6.5H8a4 4 0 0 0-4 4v1"/><path d="m7 20.5-3-3 3-3"/>
    <path d="M4 17.5h12a4 4 0 0 0 4-4v-1"/>`,
  addPose: svg`<path d="M12 3.5 20.5 12 12 20.5 3.5 12Z"/><path d="M12 9v6m-3-3h6"/>`,
  pin: svg`<path d="M6 21V4h12.5l-3.5 4.5 3.5 4.5H6" /><path d="M6 4v17"/>`,
  file: svg`<path d="M6 3.5h8l4.5 4.5v12.5H6Z"/><path d="M14 3.5V8h4.5"/>`,
  bell: svg`<path d="M6 17V11a6 6 0 0 1 12 0v6l1.5 2h-15Z"/><path d="M10 21.5h4M12 5V3"/>`,
  more: svg`<path d="M12 5.5v.01m0 6.5v.01m0 6.5v.01" stroke-width="3.5"/>`,
  tick: svg`<path d="m5 12.5 4.5 4.5L19 7.5"/>`,
  warning: svg`<path d="M12 4 21 19.5H3Z"/><path d="M12 10v4.5m0 2.5v.01"/>`,
  turn: svg`<path d="M4.5 12a7.5 7.5 0 1 0 2.4-5.5"/><path d="M4 4v4.5h4.5"/>`,
  up: svg`<path d="M12 20V4m-5 5 5-5 5 5"/>`,
  bin: svg`<path d="M5 7h14M10 7V4.5h4V7m-7.5 0 .8 12.5h9.4L17.5 7"/>`,
  save: svg`<path d="M12 4v11m-4.5-4.5L12 15l4.5-4.5M5 19.5h14"/>`,
} as const;

export type IconName = keyof typeof drawings;

/** An icon of the 24 px set; hidden from assistive tools, so its button needs a name of its own. */
export function icon(name: IconName): TemplateResult {
  return html`<svg class="ico" viewBox="0 0 24 24" aria-hidden="true">${drawings[name]}</svg>`;
}

export const brandMark = html`<svg viewBox="0 0 32 32" aria-hidden="true">
    <path d="M3 27h26" stroke="var(--ink)" stroke-width="2.5" stroke-linecap="round"/>
    <path d="M5 24C7 11 11 6 15.5 6c3 0 5.5 2.5 7 8" fill="none" stroke="var(--ink)"
      stroke-width="2" stroke-dasharray="1 4.4" stroke-linecap="round"/>
    <ellipse cx="23" cy="21.6" rx="6.4" ry="4.6" fill="var(--now)" stroke="var(--ink)" stroke-width="2"/></svg>`;

export const playMark = html`<svg viewBox="0 0 24 24" aria-hidden="true">
    <path d="M8 4.6c0-1 1-1.5 1.8-1l10.6 7.2c.8.5.8 1.7 0 2.3L9.8 20.4c-.8.5-1.8 0-1.8-1Z"/>
    </svg>`;
export const pauseMark = html`<svg viewBox="0 0 24 24" aria-hidden="true">
    <rect x="5.5" y="4" width="4.5" height="16" rx="1.4"/>
    <rect x="14" y="4" width="4.5" height="16" rx="1.4"/></svg>`;
