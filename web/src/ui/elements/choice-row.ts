import { css, html, type TemplateResult } from "lit";

export type Choice = readonly [words: string, chosen: boolean, choose: () => void];

/** A choice of a few, in one line after its name. One that cannot be taken says why. */
export function choiceRow(label: string, choices: readonly Choice[], unable: Readonly<Record<string, string>> = {}): TemplateResult {
  return html`<div class="row"><span aria-hidden="true">${label}</span><div class="seg" role="group" aria-label=${label}>${choices.map(
    ([words, chosen, choose]) => html`<button class="btn" aria-pressed=${chosen} ?disabled=${words in unable}
      title=${unable[words] ?? ""} @click=${choose}><span>${words}</span></button>`,
  )}</div></div>`;
}

/** How far something is that can be cancelled. */
export function progressBar(label: string, words: string, done: number): TemplateResult {
  return html`<div class="making"><p>${words}</p>
    <div class="progress" role="progressbar" aria-label=${label} aria-valuemin="0" aria-valuemax="100"
      aria-valuenow=${Math.round(100 * done)} style="--p:${done}"><i></i></div></div>`;
}

/** Rows, progress and buttons of what is taken away. */
export const choiceStyle = css`
  .row { display: grid; grid-template-columns: 72px minmax(0, 1fr); gap: 8px; align-items: center; font: var(--t-small);
    color: var(--ink-2); }
  .seg { display: flex; padding: 2px; border-radius: var(--r-m); background: var(--desk); box-shadow: inset 0 0 0 1px var(--line); }
  .seg .btn { flex: 1; min-width: 0; min-height: max(28px, var(--hit) - 4px); border-radius: 8px; padding: 0 8px; font: var(--t-body); }
  .seg .btn[aria-pressed="true"] { background: var(--ink); color: var(--on-ink); font-weight: 600; }
  .seg span { overflow: hidden; text-overflow: ellipsis; }
  .making { grid-column: 1 / -1; display: grid; gap: 12px; align-self: center; padding-top: 16px; }
  .making p { font: var(--t-body); color: var(--ink); }
  .progress { position: relative; height: 14px; border-radius: var(--r-full); background: var(--well); }
  .progress i { position: absolute; inset: 0 calc(100% - var(--p) * 100%) 0 0; border-radius: var(--r-full); background: var(--ink); }
  .acts { display: flex; justify-content: flex-end; gap: var(--s1); }
  .acts .primary { min-width: 0; }
  .acts span { overflow: hidden; text-overflow: ellipsis; }
  .bad { color: var(--bad); font: var(--t-body); }
  @media (max-width: 719px) { .row { grid-template-columns: 60px minmax(0, 1fr); } }
`;
