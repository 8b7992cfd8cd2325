import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { type Filming, FRAMES, LONGEST, SHORTEST } from "../../app/filming";
import { bytes, seconds } from "../../util/words";
import { SessionElement } from "../element";
import { base } from "../styles";
import { choiceRow, choiceStyle, progressBar } from "./choice-row";

const KINDS = { mp4: "MP4", webm: "WebM", gif: "GIF" } as const;

/** What film editors take out of a picture. */
const GREEN = "#00b140";

/** A film of the dance, or a picture of this frame. */
@customElement("rigless-film")
export class FilmPanel extends SessionElement {
  protected readonly topics = ["export"] as const;
  /** While the hand moves it. */
  @state() private length: number | null = null;
  /** What is shown of the film, and where the browser has it. */
  private shown: { bytes: Uint8Array; url: string } | null = null;

  static override styles = [
    base,
    choiceStyle,
    css`
      :host { display: grid; grid-template-columns: minmax(0, 1fr); gap: 12px; }
      .look { display: grid; place-items: center; height: 216px; border-radius: var(--r-l); overflow: hidden; background: var(--desk); }
      .look.clear { background: repeating-conic-gradient(var(--well) 0 25%, var(--paper) 0 50%) 0 0 / 24px 24px; }
      .look > :is(img, video) { max-width: 100%; height: 216px; object-fit: contain; }
      .making { padding: 0; }
      .length { display: grid; grid-template-columns: minmax(0, 1fr) 48px; gap: 8px; align-items: center; }
      .length input { width: 100%; margin: 0; min-height: var(--hit); accent-color: var(--ink); border-radius: var(--r-full); }
      .length output { font: var(--t-body); color: var(--ink); text-align: right; }
      #colour { width: 64px; min-height: max(32px, var(--hit)); padding: 2px; border: 0; border-radius: var(--r-s); background: none; }
      .acts { flex-wrap: wrap; }
      .acts .picture { margin-right: auto; }
      @media (max-width: 719px) { .look, .look > :is(img, video) { height: 168px; } }
    `,
  ];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.forget();
  }

  private get film(): Filming | null {
    return this.session.saving.exporting?.film ?? null;
  }

  protected override render() {
    const { film } = this;
    if (!film) return nothing;
    const { wish, state, kinds } = film;
    const making = state.kind === "making";
    const { name } = this.session.cast.present ?? { name: "The model" };
    const beside = this.session.document.companion && this.session.duet?.name;
    const unable: Record<string, string> = {};
    if (kinds.length > 0 && !kinds.includes("webm")) unable["Transparent"] = "This browser makes no WebM, which alone can be so.";
    const length = this.length ?? wish.seconds;
    return html`
      ${this.renderLook(film)}
      ${choiceRow(
        "Frame",
        FRAMES.map((frame) => [frame.name, wish.frame === frame, () => film.want({ frame })]),
      )}
      ${choiceRow("Shows", [
        [beside ? "All" : "Both", !wish.alone, () => film.want({ alone: false })],
        [beside ? `${name}, ${beside}` : name, wish.alone, () => film.want({ alone: true })],
      ])}
      ${choiceRow("Camera", [
        ["Yours", !wish.turntable, () => film.want({ turntable: false })],
        ["Goes around", wish.turntable, () => film.want({ turntable: true })],
      ])}
      ${choiceRow(
        "Behind",
        [
          ["The stage", !wish.clear && wish.colour === null, () => film.want({ clear: false, colour: null })],
          ["A colour", wish.colour !== null, () => film.want({ colour: wish.colour ?? GREEN })],
          ["Transparent", wish.clear, () => film.want({ clear: true })],
        ],
        unable,
      )}
      ${
        wish.colour === null
          ? nothing
          : html`<div class="row"><label for="colour">Colour</label><input id="colour" type="color" .value=${wish.colour}
              @change=${(event: Event) => film.want({ colour: (event.target as HTMLInputElement).value })} /></div>`
      }
      <div class="row"><label for="length">Lasts</label><div class="length">
        <input id="length" type="range" min=${SHORTEST} max=${LONGEST} step="0.1" .value=${String(length)}
          aria-valuetext=${seconds(length)} @change=${this.setLength} @input=${this.slide} />
        <output for="length">${seconds(length)}</output></div></div>
      ${
        kinds.length > 0
          ? choiceRow(
              "Kind",
              kinds.map((kind) => [KINDS[kind], wish.kind === kind, () => film.want({ kind })]),
            )
          : nothing
      }
      ${
        film.song && wish.kind !== "gif"
          ? choiceRow("Sound", [
              [film.song.name, !wish.silent, () => film.want({ silent: false })],
              ["None", wish.silent, () => film.want({ silent: true })],
            ])
          : nothing
      }
      ${this.renderState(film)}
      <div class="acts">
        <button class="btn picture" ?disabled=${making} @click=${() => film.savePicture()}>A picture of this frame</button>
        ${making ? html`<button class="btn line" @click=${() => film.stop()}>Cancel</button>` : nothing}
        ${
          state.kind === "made"
            ? html`<button class="btn primary" @click=${() => film.save()}><span>Save ${state.film.name}</span></button>`
            : html`<button class="btn primary" ?disabled=${making || kinds.length === 0} @click=${() => film.make()}>Make the film</button>`
        }
      </div>`;
  }

  private renderLook({ state, preview, wish }: Filming) {
    const made = state.kind === "made" ? state.film : null;
    const url = this.urlOf(made?.bytes ?? preview, made?.type ?? "image/png");
    const look = wish.clear ? "look clear" : "look";
    if (url === null) return html`<div class=${look}></div>`;
    return made && made.type !== "image/gif"
      ? html`<div class=${look}><video src=${url} aria-label="The film" autoplay loop muted playsinline></video></div>`
      : html`<div class=${look}><img src=${url} alt=${made ? "The film" : "How it will look"} /></div>`;
  }

  private renderState({ state }: Filming) {
    if (state.kind === "making") return progressBar("Making the film", `Frame ${state.done} of ${state.of}`, state.done / state.of);
    if (state.kind === "failed") return html`<p class="bad" role="alert">${state.why}</p>`;
    return html`<p class="sub" aria-live="polite">${state.kind === "made" ? bytes(state.film.bytes.length) : nothing}</p>`;
  }

  private readonly slide = (event: Event): void => {
    this.length = Number((event.target as HTMLInputElement).value);
  };

  private readonly setLength = (event: Event): void => {
    this.length = null;
    this.film?.want({ seconds: Number((event.target as HTMLInputElement).value) });
  };

  private urlOf(content: Uint8Array<ArrayBuffer> | null, type: string): string | null {
    if (content !== this.shown?.bytes) {
      this.forget();
      if (content) this.shown = { bytes: content, url: URL.createObjectURL(new Blob([content], { type })) };
    }
    return this.shown?.url ?? null;
  }

  private forget(): void {
    if (this.shown) URL.revokeObjectURL(this.shown.url);
    this.shown = null;
  }
}
