import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { sayLater } from "../../app/beside-words";
import type { Duet } from "../../app/duet";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { figure, move } from "../../util/words";
import { gallery, galleryStyle } from "./gallery";
import { book, shelfStyle } from "./shelf";
import { slider, sliderStyle } from "./slider";
import "./switch";

const DEGREES = 180 / Math.PI;

/** Who dances beside the one in hand: who that is, when and where. */
@customElement("rigless-duet")
export class DuetCard extends SessionElement {
  protected readonly topics = ["document", "duet", "kept", "solve"] as const;
  /** Somebody is being looked for. */
  @state() private choosing = false;
  static override styles = [
    base,
    panel,
    galleryStyle,
    shelfStyle,
    sliderStyle,
    css`
      :host { display: block; border-top: 1px solid var(--line); margin-top: 8px; padding: 8px 8px 0; }
      h3 { display: flex; justify-content: space-between; align-items: center; gap: 8px; font: var(--t-strong); min-height: var(--hit); }
      rigless-switch { display: block; margin: 8px 0; }
      h3 span { min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .rows { display: grid; gap: 8px; padding: 4px 0; }
      .row-acts .btn { flex: 1; }
      .gallery { margin: 4px -8px; }
    `,
  ];

  protected override render() {
    const { duet } = this.session;
    const { companion } = this.session.document;
    if (!companion || !duet)
      return html`<h3><span>Second dancer</span>
          <button class="btn line" aria-expanded=${this.choosing} @click=${this.choose}>${this.choosing ? "Close" : "Add"}</button></h3>
        ${this.choosing ? this.renderChoice() : ""}`;
    return html`<h3><span>${duet.name} dances beside</span>
        <button class="btn icon" aria-label="Remove ${duet.name}" title="Remove it" @click=${() => duet.remove()}
          >${icon("close")}</button></h3>
      <div class="row-acts">
        <button class="btn line" title="${duet.name} gets the points, poses and settings" @click=${() => duet.swap()}>Take in hand</button>
        <button class="btn line" aria-expanded=${this.choosing} @click=${this.choose}>${this.choosing ? "Close" : "Somebody else"}</button>
      </div>
      ${this.choosing ? this.renderChoice() : ""}
      ${this.renderMotion(duet)}
      ${this.renderOffset(duet)}`;
  }

  private renderChoice() {
    const { session } = this;
    const { cast, keeping, duet } = session;
    const partners = duet?.partners;
    if (!partners) return html`<p class="note">One moment.</p>`;
    const kept = keeping?.list.filter(({ id }) => id !== keeping.present) ?? [];
    return html`${gallery(
      cast.list.map((performer) => ({
        name: performer.name,
        detail: performer.file,
        picture: performer.character && session.builtins.picture(performer.character),
        fallback: performer.character ? "model" : "file",
        chosen: false,
        coming: partners.coming === performer.file,
        choose: () => void partners.usePerformer(performer).then(this.done),
      })),
    )}
      <div class="row-acts"><button class="btn line" @click=${() => void partners.pick().then(this.done)}>From a file</button></div>
      ${
        kept.length > 0
          ? html`<ul class="shelf">${kept.map(
              (one) =>
                html`<li>${book(one, `Let ${one.name} dance beside`, () => void partners.useKept(one.id, one.name).then(this.done))}</li>`,
            )}</ul>`
          : ""
      }`;
  }

  private renderMotion({ companion, partners }: Duet) {
    const { motions } = this.session;
    const own = companion?.motion;
    const key = own?.files.join("\n");
    const entries = motions.list;
    const playing = entries.find((entry) => motions.isPlaying(entry)) ?? null;
    return html`<rigless-switch label="Same motion" effect=${own ? "Dances to its own" : "Dances to that of the one in hand"} .on=${!own}
        @switch=${(event: CustomEvent<boolean>) => void partners.useMotion(event.detail ? null : playing)}></rigless-switch>
      ${
        own
          ? html`<label class="pair">Motion <select @change=${(event: Event) =>
              void partners.useMotion(entries[(event.target as HTMLSelectElement).selectedIndex] ?? null)}>${entries.map(
              ({ name, files }) => html`<option ?selected=${files.join("\n") === key}>${name}</option>`,
            )}</select></label>`
          : ""
      }`;
  }

  private renderOffset(duet: Duet) {
    const { companion } = duet;
    if (!companion) return "";
    const { seconds, place, yaw } = companion.offset;
    const [x, z] = place;
    const degrees = Math.round(yaw * DEGREES);
    return html`<div class="rows">
      ${slider("When", seconds, { min: -4, max: 4, step: 0.1, words: sayLater(seconds) }, (value, held) =>
        duet.move("seconds", () => ({ seconds: value }), held),
      )}
      ${slider("Across", x, { min: -5, max: 5, step: 0.05, rest: 1.6, words: move([x, 0, 0]) }, (value, held) =>
        duet.move("across", ({ place }) => ({ place: [value, place[1]] }), held),
      )}
      ${slider("Depth", z, { min: -5, max: 5, step: 0.05, words: move([0, 0, z]) }, (value, held) =>
        duet.move("depth", ({ place }) => ({ place: [place[0], value] }), held),
      )}
      ${slider("Turned", degrees, { min: -180, max: 180, step: 5, words: `${figure(degrees)}°` }, (value, held) =>
        duet.move("yaw", () => ({ yaw: value / DEGREES }), held),
      )}
    </div>`;
  }

  private readonly choose = (): void => {
    this.choosing = !this.choosing;
    void this.session.accompany().then(() => this.look());
  };

  /** Somebody came, or could not. */
  private readonly done = (): void => {
    this.choosing = this.choosing && this.session.document.companion === undefined;
    void this.look();
  };

  /** What has opened is seen. */
  private async look(): Promise<void> {
    this.requestUpdate();
    await this.updateComplete;
    this.scrollIntoView({ block: "nearest" });
  }
}
