import { css, html, type TemplateResult } from "lit";

export interface SliderLook {
  min?: number;
  max: number;
  step?: number;
  /** Where a double-click goes. */
  rest?: number;
  /** What the value means. */
  words: string;
}

export const sliderStyle = css`
  .slide span { display: grid; }
  .slide input { padding: 0; box-shadow: none; background: none; accent-color: var(--ink); }
  .slide small { font: var(--t-small); color: var(--ink-3); margin-top: -6px; }
`;

/** A row of a panel: a number, and whether it is still held. */
export function slider(
  label: string,
  value: number,
  { min = 0, max, step = 0.01, rest = 0, words }: SliderLook,
  set: (value: number, held: boolean) => void,
): TemplateResult {
  const told = (held: boolean) => (event: Event) => set(Number((event.target as HTMLInputElement).value), held);
  return html`<label class="pair slide">${label} <span><input type="range" min=${min} max=${max} step=${step} .value=${String(value)}
    aria-valuetext=${words} @input=${told(true)} @change=${told(false)} @dblclick=${() => set(rest, false)}
    /><small>${words}</small></span></label>`;
}
