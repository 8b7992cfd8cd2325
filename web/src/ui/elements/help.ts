import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

const KEYS: readonly (readonly [string, string])[] = [
  ["Space", "Play, pause"],
  [", .", "One frame back, on"],
  ["[ ]", "Pose before, after"],
  ["K", "Add a pose here"],
  ["C", "Pin the point in hand, or the selected one, here"],
  ["M", "While holding a dot: its partner mirrors it"],
  ["1 2 3 4", "Model, motion, points, poses"],
  ["F", "Fit the view"],
  ["Esc", "Let go of a dot"],
  ["Del", "Delete the selected point"],
  ["Ctrl Z", "Undo"],
  ["Ctrl Shift Z", "Redo"],
  ["Ctrl S", "Save the project file"],
];

/** The sheet of keys. */
@customElement("rigless-help")
export class Help extends SessionElement {
  protected readonly topics = ["help"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    base,
    css`
      dialog { border: 0; color: var(--ink); background: var(--paper); border-radius: 20px; box-shadow: var(--lift-2); padding: var(--s2) var(--s3) var(--s3); width: 400px; max-width: calc(100vw - 32px); }
      dialog::backdrop { background: light-dark(rgb(227 236 240 / .82), rgb(16 23 29 / .78)); }
      h2 { font: var(--t-title); display: flex; justify-content: space-between; align-items: center; margin: 0 -8px 8px 0; }
      dl { display: grid; grid-template-columns: auto 1fr; gap: 6px 16px; align-items: center; margin-top: 12px; }
      dt { display: flex; gap: 4px; }
      dialog kbd { display: inline-block; }
      p { color: var(--ink-2); }
    `,
  ];

  protected override updated(): void {
    if (this.session.help && !this.dialog.open) this.dialog.showModal();
    if (!this.session.help && this.dialog.open) this.dialog.close();
  }

  protected override render() {
    return html`<dialog aria-labelledby="title" @close=${() => this.session.setHelp(false)}>
      <h2><span id="title">Help and keys</span><button class="btn icon" aria-label="Close" @click=${() => this.session.setHelp(false)}>${icon("close")}</button></h2>
      <p>Drag a dot: that is a pose, and the whole dance follows it. Two poses are enough to start. Drop a model or a motion on the page to use your own.</p>
      <dl>${KEYS.map(([keys, does]) => html`<dt>${keys.split(" ").map((key) => html`<kbd>${key}</kbd>`)}</dt><dd>${does}</dd>`)}</dl>
    </dialog>`;
  }
}
