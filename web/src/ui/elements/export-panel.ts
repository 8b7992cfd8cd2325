import { css, html, type TemplateResult } from "lit";
import { customElement, query } from "lit/decorators.js";
import { type Exporting, type MadeFile, PACES, PROFILES, sayHolding } from "../../app/exporting";
import { bytes, count } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";
import { dialogStyle } from "./dialog-style";

/** What a dance is taken away as, and how like it that is, before it is saved. */
@customElement("rigless-export")
export class ExportPanel extends SessionElement {
  protected readonly topics = ["export"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    base,
    dialogStyle,
    css`
      dialog { width: 456px; max-width: calc(100vw - 16px); max-height: calc(100dvh - 16px); }
      dialog[open] { display: grid; grid-template-columns: minmax(0, 1fr); gap: 12px; align-content: start; }
      h2 { gap: 8px; }
      h2 span { overflow-wrap: anywhere; }
      .row { display: grid; grid-template-columns: 72px minmax(0, 1fr); gap: 8px; align-items: center; font: var(--t-small);
        color: var(--ink-2); }
      .seg { display: flex; padding: 2px; border-radius: var(--r-m); background: var(--desk); box-shadow: inset 0 0 0 1px var(--line); }
      .seg .btn { flex: 1; min-width: 0; min-height: max(28px, var(--hit) - 4px); border-radius: 8px; padding: 0 8px; font: var(--t-body); }
      .seg .btn[aria-pressed="true"] { background: var(--ink); color: var(--on-ink); font-weight: 600; }
      .seg span { overflow: hidden; text-overflow: ellipsis; }
      .facts { display: grid; grid-template-columns: 72px minmax(0, 1fr); gap: 4px 8px; padding: 12px 16px; border-radius: var(--r-l);
        min-height: 124px; background: var(--desk); align-content: start; }
      dt { font: var(--t-small); color: var(--ink-2); line-height: 20px; }
      dd { margin: 0; font: var(--t-body); }
      .facts p { grid-column: 1 / -1; font: var(--t-small); color: var(--ink-2); }
      .facts p.bad { color: var(--bad); font: var(--t-body); }
      .making { grid-column: 1 / -1; display: grid; gap: 12px; align-self: center; padding-top: 16px; }
      .making p { font: var(--t-body); color: var(--ink); }
      .progress { position: relative; height: 14px; border-radius: var(--r-full); background: var(--well); }
      .progress i { position: absolute; inset: 0 calc(100% - var(--p) * 100%) 0 0; border-radius: var(--r-full); background: var(--ink); }
      .acts { display: flex; justify-content: flex-end; gap: var(--s1); }
      .acts .primary { min-width: 0; }
      .acts span { overflow: hidden; text-overflow: ellipsis; }
      @media (max-width: 719px) { dialog { padding: 8px 16px 16px; } .row, .facts { grid-template-columns: 60px minmax(0, 1fr); } }
    `,
  ];

  private get exporting(): Exporting | null {
    return this.session.saving.exporting;
  }

  protected override updated(): void {
    const open = (this.exporting?.state.kind ?? "closed") !== "closed";
    if (open && !this.dialog.open) this.dialog.showModal();
    if (!open && this.dialog.open) this.dialog.close();
  }

  protected override render() {
    const { exporting } = this;
    const { name } = this.session.document;
    return html`<dialog aria-labelledby="title" @close=${() => exporting?.close()}>
      <h2><span id="title">Take ${name} with you</span
        ><button class="btn icon" aria-label="Close" @click=${() => exporting?.close()}>${icon("close")}</button></h2>
      ${exporting && exporting.state.kind !== "closed" ? this.renderWish(exporting) : ""}
    </dialog>`;
  }

  private renderWish(exporting: Exporting) {
    const { wish, state, motions } = exporting;
    const stopped = state.kind === "stopped" || state.kind === "failed";
    const now = motions.find((entry) => this.session.motions.isPlaying(entry))?.name ?? "This motion";
    const made = state.kind === "made" ? state.file : null;
    return html`
      ${row("Motions", [
        [now, !wish.all, () => exporting.want({ all: false })],
        [`All ${motions.length} motions`, wish.all, () => exporting.want({ all: true })],
      ])}
      ${row(
        "Kind",
        PROFILES.map((profile) => [profile.name, wish.profile === profile, () => exporting.want({ profile })]),
      )}
      ${row("Goes", [
        ["Travelling", !wish.inPlace, () => exporting.want({ inPlace: false })],
        ["In place", wish.inPlace, () => exporting.want({ inPlace: true })],
      ])}
      ${row(
        "Frames",
        PACES.map((fps) => [`${fps} fps`, wish.fps === fps, () => exporting.want({ fps })]),
      )}
      ${this.renderState(exporting)}
      <div class="acts">
        ${state.kind === "making" ? html`<button class="btn line" @click=${() => exporting.stop()}>Cancel</button>` : ""}
        ${stopped ? html`<button class="btn line" @click=${() => exporting.make()}>Make it</button>` : ""}
        <button class="btn primary" ?disabled=${!made} @click=${() => exporting.save()}
          ><span>Save ${made?.name ?? "the file"}</span></button>
      </div>`;
  }

  private renderState({ state, wish }: Exporting) {
    if (state.kind === "making")
      return html`<div class="facts"><div class="making"><p>${state.step}, ${Math.round(100 * state.done)} %</p>
        <div class="progress" role="progressbar" aria-label="Making the file" aria-valuemin="0" aria-valuemax="100"
          aria-valuenow=${Math.round(100 * state.done)} style="--p:${state.done}"><i></i></div></div></div>`;
    if (state.kind === "failed") return html`<div class="facts" role="alert"><p class="bad">${state.why}</p></div>`;
    if (state.kind === "made") return html`<dl class="facts" aria-live="polite">${facts(state.file, wish.profile.worksIn)}</dl>`;
    return html`<div class="facts"><p>Nothing was made.</p></div>`;
  }
}

type Choice = readonly [words: string, chosen: boolean, choose: () => void];

function row(label: string, choices: readonly Choice[]): TemplateResult {
  return html`<div class="row"><span aria-hidden="true">${label}</span><div class="seg" role="group" aria-label=${label}>${choices.map(
    ([words, chosen, choose]) => html`<button class="btn" aria-pressed=${chosen} @click=${choose}><span>${words}</span></button>`,
  )}</div></div>`;
}

function facts({ bytes: file, likeness, clips, frames, notes }: MadeFile, worksIn: string): TemplateResult {
  const share = (of: number): string => `${(100 * of).toFixed(2)} %`;
  const what = [
    bytes(file.length),
    ...(clips > 1 ? [count(clips, "clip")] : []),
    count(frames, "frame"),
    ...(likeness ? [sayHolding(likeness)] : []),
  ];
  return html`
    <dt>Size</dt><dd>${what.join(", ")}</dd>
    <dt>Likeness</dt><dd>${
      likeness
        ? `${share(likeness.rms)} of its size off on average, ${share(likeness.worst)} in the worst place`
        : "exact in every kept frame"
    }</dd>
    <dt>Works in</dt><dd>${worksIn}</dd>
    ${notes.map((note) => html`<p>${note}</p>`)}`;
}
