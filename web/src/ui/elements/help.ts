import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { helpRows, labelOf } from "../../app/actions";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";
import { dialogStyle } from "./dialog-style";

/** What no button says. */
const HANDS: readonly (readonly [how: string, what: string])[] = [
  ["Drag", "On a dot: a pose. Elsewhere: turn the view"],
  ["Shift", "While dragging: nearer and farther"],
  ["Right drag", "Move the view; with the wheel or two fingers nearer and farther"],
  ["2 fingers", "A tap undoes; with three it redoes"],
  ["Long press", "On a dot: its settings. A second finger mirrors what you hold"],
];
const WAYS: readonly (readonly [how: string, what: string])[] = [
  ["F6", "To the next part of the page"],
  ["↑ ↓", "On in a list; on a dot: move it"],
  ["PgDn", "On in a list, to the next dot too"],
];

/** The sheet of keys and gestures. */
@customElement("rigless-help")
export class Help extends SessionElement {
  protected readonly topics = ["help"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    base,
    dialogStyle,
    css`
      h2 { margin-bottom: 8px; }
      dl { display: grid; grid-template-columns: auto 1fr; gap: 6px 16px; align-items: center; margin-top: 12px; }
      dt { display: flex; gap: 4px; }
      dialog { max-height: calc(100dvh - 32px); }
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
      <dl>${[...HANDS, ...WAYS].map(([how, what]) => html`<dt><kbd>${how}</kbd></dt><dd>${what}</dd>`)}
        ${helpRows(actions).map(({ words, caps }) => html`<dt>${caps.map((cap) => html`<kbd>${cap}</kbd>`)}</dt><dd>${words}</dd>`)}</dl>
    </dialog>`;
  }
}
