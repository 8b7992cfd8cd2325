import { css, html, type TemplateResult } from "lit";
import { customElement, query } from "lit/decorators.js";
import { type Exporting, type MadeFile, PACES, PROFILES, sayHolding } from "../../app/exporting";
import { bytes, count } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";
import { choiceRow, choiceStyle, progressBar } from "./choice-row";
import { dialogStyle } from "./dialog-style";
import "./film-panel";
import "./link-panel";

const SOUVENIRS = [
  ["model", "Model"],
  ["film", "Film"],
  ["link", "Link"],
] as const;

/** What a dance is taken away as, and how like it that is, before it is saved. */
@customElement("rigless-export")
export class ExportPanel extends SessionElement {
  protected readonly topics = ["export"] as const;
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    base,
    dialogStyle,
    choiceStyle,
    css`
      dialog { width: 456px; max-width: calc(100vw - 16px); max-height: calc(100dvh - 16px); }
      dialog[open] { display: grid; grid-template-columns: minmax(0, 1fr); gap: 12px; align-content: start; }
      h2 { gap: 8px; }
      h2 span { overflow-wrap: anywhere; }
      .facts { display: grid; grid-template-columns: 72px minmax(0, 1fr); gap: 4px 8px; padding: 12px 16px; border-radius: var(--r-l);
        min-height: 124px; background: var(--desk); align-content: start; }
      dt { font: var(--t-small); color: var(--ink-2); line-height: 20px; }
      dd { margin: 0; font: var(--t-body); }
      .facts p { grid-column: 1 / -1; font: var(--t-small); color: var(--ink-2); }
      .facts p.bad { color: var(--bad); font: var(--t-body); }
      .what { margin: -4px 0 4px; }
      @media (max-width: 719px) { dialog { padding: 8px 16px 16px; } .facts { grid-template-columns: 60px minmax(0, 1fr); } }
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
      ${exporting && exporting.state.kind !== "closed" ? this.renderSouvenir(exporting) : ""}
    </dialog>`;
  }

  private renderSouvenir(exporting: Exporting) {
    const { what } = exporting;
    return html`
      <div class="seg what" role="group" aria-label="What to take">${SOUVENIRS.map(
        ([id, words]) => html`<button class="btn" aria-pressed=${what === id} @click=${() => exporting.choose(id)}
          ><span>${words}</span></button>`,
      )}</div>
      ${this.renderChosen(exporting)}`;
  }

  private renderChosen(exporting: Exporting) {
    if (exporting.what === "film") return html`<rigless-film .session=${this.session}></rigless-film>`;
    if (exporting.what === "link") return html`<rigless-link .session=${this.session}></rigless-link>`;
    return this.renderWish(exporting);
  }

  private renderWish(exporting: Exporting) {
    const { wish, state, motions } = exporting;
    const stopped = state.kind === "stopped" || state.kind === "failed";
    const now = motions.find((entry) => this.session.motions.isPlaying(entry))?.name ?? "This motion";
    const made = state.kind === "made" ? state.file : null;
    return html`
      ${choiceRow("Motions", [
        [now, !wish.all, () => exporting.want({ all: false })],
        [`All ${motions.length} motions`, wish.all, () => exporting.want({ all: true })],
      ])}
      ${choiceRow(
        "Kind",
        PROFILES.map((profile) => [profile.name, wish.profile === profile, () => exporting.want({ profile })]),
      )}
      ${choiceRow("Goes", [
        ["Travelling", !wish.inPlace, () => exporting.want({ inPlace: false })],
        ["In place", wish.inPlace, () => exporting.want({ inPlace: true })],
      ])}
      ${choiceRow(
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
    if (state.kind === "making") {
      const { step, done } = state;
      return html`<div class="facts">${progressBar("Making the file", `${step}, ${Math.round(100 * done)} %`, done)}</div>`;
    }
    if (state.kind === "failed") return html`<div class="facts" role="alert"><p class="bad">${state.why}</p></div>`;
    if (state.kind === "made") return html`<dl class="facts" aria-live="polite">${facts(state.file, wish.profile.worksIn)}</dl>`;
    return html`<div class="facts"><p>Nothing was made.</p></div>`;
  }
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
