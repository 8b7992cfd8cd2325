import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { base } from "../styles";
import { DEFAULT_SMOOTHNESS } from "../../util/constants";
import { count, figure, stem } from "../../util/words";
import type { RangeDetail } from "./range";
import "./range";
import "./switch";

const cm = (metresPerSecond: number): string => figure(metresPerSecond * 100, 1);

@customElement("rigless-inspector")
export class Inspector extends SessionElement {
  protected readonly topics = ["document", "solve", "thumbnails"] as const;

  static override styles = [
    base,
    css`
      :host { display: block; margin: var(--gap) var(--s2); width: 256px; padding: var(--s2); background: var(--paper);
        border-radius: var(--r-l);
        box-shadow: var(--lift-1); }
      header { display: flex; gap: 12px; align-items: center; margin-bottom: var(--s2); }
      header .thumb { width: 40px; height: 40px; flex: none; }
      header div { min-width: 0; }
      h2 { font: var(--t-title); line-height: 20px; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .switches { border-top: 1px solid var(--line); padding-top: var(--s-half); margin-bottom: -8px; }
      @media (max-height: 740px) { :host { padding: 4px var(--s2) 8px; } header { display: none; } }
      @media (max-width: 719px) {
        :host { margin: 0; width: auto; border-radius: 0; box-shadow: none; padding: 0 16px; }
        header { display: none; }
        .switches { display: flex; flex-wrap: wrap; gap: 8px; margin: 0; padding: 8px 0; }
      }
    `,
  ];

  protected override render() {
    const { document, thumbnails, cast, poses } = this.session;
    const { settings } = document;
    const picture = thumbnails.rest;
    const motion = stem(document.motion.files.at(-1) ?? "no motion");
    return html`
      <header>
        <span class="thumb">${picture ? html`<img src=${picture} alt="" />` : ""}</span>
        <div>
          <h2>${cast.presentName}</h2>
          <p class="sub">${count(document.points.length, "point")}, ${count(document.examples.length, "pose")}, ${motion}</p>
        </div>
      </header>
      <rigless-range label="Volume" track="volume" .value=${settings.volume} .max=${3} .rest=${1} low="flat" high="juicy"
        @range=${this.slid("volume")}></rigless-range>
      <rigless-range label="Smoothness" track="smooth" .value=${settings.smoothness} .max=${1} .rest=${DEFAULT_SMOOTHNESS}
        low="snappy" high="floaty"
        @range=${this.slid("smoothness")}></rigless-range>
      ${
        settings.paper
          ? ""
          : html`<rigless-range label="Energy" track="energy" .value=${settings.energy} .min=${-1} .max=${1} .rest=${0}
        low="calm" high="cartoon"
        @range=${this.slid("energy")}></rigless-range>`
      }
      <div class="switches">
        ${settings.paper ? "" : this.renderSwitch("groundContact", "Ground contact", this.contactEffect())}
        ${this.renderSwitch("inPlace", "In place", settings.inPlace ? "Stays on the spot" : "Travels as the dancer does")}
        ${
          poses.canMirror && !settings.paper
            ? this.renderSwitch("symmetry", "Symmetry", settings.symmetry ? "Poses teach both sides" : "Poses teach their own side")
            : ""
        }
        ${this.renderSwitch("paper", "As in the paper", "No weight, accents or swing")}
      </div>
    `;
  }

  private renderSwitch(key: "groundContact" | "inPlace" | "symmetry" | "paper", label: string, effect: string) {
    const { settings, document } = this.session;
    return html`<rigless-switch label=${label} effect=${effect} .on=${document.settings[key] ?? false}
      @switch=${(event: CustomEvent<boolean>) => settings.set(key, event.detail, false)}></rigless-switch>`;
  }

  private slid(key: "volume" | "smoothness" | "energy") {
    return ({ detail }: CustomEvent<RangeDetail>): void => this.session.settings.set(key, detail.value, detail.held);
  }

  private contactEffect(): string {
    const performance = this.session.performance;
    if (!performance) return "Feet stay where they stand";
    if (!performance.contacts.includes(1)) return "Nothing stands on the ground here";
    const { before, after } = performance.slip;
    return this.session.document.settings.groundContact ? `Slide ${cm(before)} cm/s, now ${cm(after)} cm/s` : `Slide ${cm(before)} cm/s`;
  }
}
