import { html, type TemplateResult } from "lit";

export type Option = readonly [value: string, words: string];

/** A row of a panel: what is chosen from a list. */
export function select(label: string, value: string, options: readonly Option[], choose: (value: string) => void): TemplateResult {
  const change = (event: Event): void => choose((event.target as HTMLSelectElement).value);
  return html`<label class="pair">${label} <select @change=${change}>
    ${options.map(([one, words]) => html`<option value=${one} .selected=${one === value}>${words}</option>`)}</select></label>`;
}
