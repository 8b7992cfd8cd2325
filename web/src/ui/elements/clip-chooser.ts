import { css, html } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { FoundClip } from "../../app/clip-files";
import { count, seconds } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";
import { dialogStyle } from "./dialog-style";

/** Which of a file's motions come in. */
@customElement("rigless-clips")
export class ClipChooser extends SessionElement {
  protected readonly topics = ["clips"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;
  @state() private chosen: ReadonlySet<FoundClip> = new Set();
  private of: readonly FoundClip[] = [];

  static override styles = [
    base,
    dialogStyle,
    css`
      dialog { max-height: calc(100dvh - 64px); }
      dialog[open] { display: flex; flex-direction: column; gap: var(--s1); }
      ul { overflow-y: auto; margin: 0 -8px; padding: 2px; }
      label { display: grid; grid-template-columns: 20px 1fr auto; gap: 12px; align-items: center; min-height: max(36px, var(--hit));
        padding: 0 8px; border-radius: var(--r-m); cursor: pointer; font: var(--t-strong); }
      label:hover { background: var(--desk); }
      small { font: var(--t-small); color: var(--ink-3); }
      span { overflow-wrap: anywhere; }
      input { width: 18px; height: 18px; margin: 0; accent-color: var(--ink); }
      .acts { display: flex; justify-content: flex-end; gap: var(--s1); }
    `,
  ];

  protected override willUpdate(changed: Parameters<SessionElement["willUpdate"]>[0]): void {
    super.willUpdate(changed);
    const clips = this.session.opening.clipFiles?.asked?.clips ?? [];
    if (clips !== this.of) this.chosen = new Set(clips.slice(0, 1));
    this.of = clips;
  }

  protected override updated(): void {
    const asked = this.of.length > 0;
    if (asked && !this.dialog.open) this.dialog.showModal();
    if (!asked && this.dialog.open) this.dialog.close();
  }

  protected override render() {
    const { clipFiles } = this.session.opening;
    const { file = "", clips = [] } = clipFiles?.asked ?? {};
    const { chosen } = this;
    const bringIn = (): void => clipFiles?.answer(clips.filter((clip) => chosen.has(clip)));
    const all = chosen.size === clips.length;
    return html`<dialog aria-labelledby="title" @close=${() => clipFiles?.answer([])}>
      <h2><span id="title">${file} holds ${count(clips.length, "motion")}</span
        ><button class="btn icon" aria-label="Close" @click=${() => clipFiles?.answer([])}>${icon("close")}</button></h2>
      <ul>${clips.map(
        (clip) => html`<li><label><input type="checkbox" .checked=${chosen.has(clip)} @change=${() => this.toggle(clip)} />
          <span>${clip.name}</span><small>${seconds(clip.seconds)}</small></label></li>`,
      )}</ul>
      <div class="acts">
        <button class="btn" @click=${() => (this.chosen = new Set(all ? [] : clips))}>${all ? "None" : "All"}</button>
        <button class="btn primary" ?disabled=${chosen.size === 0} @click=${bringIn}>Bring in ${count(chosen.size, "motion")}</button>
      </div>
    </dialog>`;
  }

  private toggle(clip: FoundClip): void {
    const chosen = new Set(this.chosen);
    if (!chosen.delete(clip)) chosen.add(clip);
    this.chosen = chosen;
  }
}
