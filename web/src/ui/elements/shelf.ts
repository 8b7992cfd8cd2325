import { css, html } from "lit";
import type { Keeping } from "../../app/keeping";
import { ago } from "../../util/words";
import { icon } from "../icons";

/** The projects that this browser keeps, to open again or to let go of. */
export function shelf(keeping: Keeping) {
  const others = keeping.list.filter(({ id }) => id !== keeping.present);
  return html`<h3 class="kept">Kept in this browser
      <button class="btn line" @click=${() => void keeping.startFresh()}>Start fresh</button></h3>
    ${others.length === 0 ? html`<p class="note">This project is kept after each step.</p>` : ""}
    <ul class="shelf">${others.map(
      (one) => html`<li>
      ${book(one, `Open ${one.name}`, () => void keeping.open(one.id))}
      <button class="btn icon" aria-label="Do not keep ${one.name}" title="Do not keep it" @click=${() => void keeping.remove(one.id)}>
        ${icon("close")}</button></li>`,
    )}</ul>`;
}

/** A kept project as a button. */
export function book({ name, changed, picture }: Keeping["list"][number], title: string, choose: () => void) {
  return html`<button class="book" title=${title} @click=${choose}>
    ${picture ? html`<img src=${picture} alt="" width="40" height="40">` : html`<i>${icon("file")}</i>`}
    <span>${name}<small>${ago(Date.now() - changed)}</small></span></button>`;
}

export const shelfStyle = css`
  .kept { display: flex; justify-content: space-between; align-items: center; gap: 8px; margin-top: 12px; font: var(--t-strong); }
  .shelf { display: grid; gap: 2px; }
  .shelf li { display: flex; align-items: center; min-width: 0; }
  .book { flex: 1; display: flex; align-items: center; gap: 8px; min-width: 0; min-height: 44px; padding: 2px 4px; border: 0;
    border-radius: 12px; background: none; color: var(--ink); font: var(--t-body); text-align: start; cursor: pointer; }
  .book:hover { background: var(--desk); }
  .book img, .book i { flex: none; display: grid; place-items: center; width: 40px; height: 40px; object-fit: contain;
    color: var(--ink-3); }
  .book span { display: grid; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
  .book small { font: var(--t-small); color: var(--ink-2); }
`;
