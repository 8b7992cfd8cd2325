import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { helpRows, labelOf } from "../../app/actions";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

/** The sheet of keys. */
@customElement("rigless-help")
export class Help extends SessionElement {
  protected readonly topics = ["help"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    base,
    css`
      dialog { border: 0; color: var(--ink); background: var(--paper); border-radius: 20px; box-shadow: var(--lift-2);
        padding: var(--s2) var(--s3) var(--s3); width: 400px; max-width: calc(100vw - 32px); }
      dialog::backdrop { background: light-dark(rgb(227 236 240 / .82), rgb(16 23 29 / .78)); }
      h2 { font: var(--t-title); display: flex; justify-content: space-between; align-items: center; margin: 0 -8px 8px 0; }
      dl { display: grid; grid-template-columns: auto 1fr; gap: 6px 16px; align-items: center; margin-top: 12px; }
      dt { display: flex; gap: 4px; }
      dialog kbd { display: inline-block; }
      p { color: var(--ink-2); }
    `,
  ];

  protected override updated(): void {
    const { help } = this.session.selection;
    if (help && !this.dialog.open) this.dialog.showModal();
    if (!help && this.dialog.open) this.dialog.close();
  }

  protected override render() {
    const { actions, selection } = this.session;
    const close = (): void => selection.setHelp(false);
    return html`<dialog aria-labelledby="title" @close=${close}>
      <h2><span id="title">${labelOf(actions.help)}</span
        ><button class="btn icon" aria-label="Close" @click=${close}>${icon("close")}</button></h2>
      <p>Drag a dot: that is a pose, and the whole dance follows it. Two poses are enough to start.
        Drop a model or a motion on the page to use your own.</p>
      <dl>${helpRows(actions).map(({ words, caps }) => html`<dt>${caps.map((cap) => html`<kbd>${cap}</kbd>`)}</dt><dd>${words}</dd>`)}</dl>
    </dialog>`;
  }
}
