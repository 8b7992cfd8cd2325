import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";
import { withArticle } from "../../util/words";

/** The part of the stage that the words and the chips take, for whoever frames figures. */
export interface IntroBoxes {
  line: Element | null;
  chips: Element | null;
}

/** The first line and the ways on from it; leaves with the first drag. */
@customElement("rigless-intro")
export class Intro extends SessionElement {
  protected readonly topics = ["intro", "document", "panel", "notices", "pins", "coverage"] as const;

  static override styles = [
    base,
    css`
      :host { display: block; pointer-events: none; container-type: inline-size; }
      :host([hidden]) { display: none; }
      .line { position: absolute; top: 20px; left: 0; right: 0; text-align: center; font: var(--t-display); font-weight: 400;
        letter-spacing: -.01em; padding: 0 16px; text-wrap: balance; }
      .chips { position: absolute; bottom: var(--s2); left: 0; right: 0; display: flex; flex-wrap: wrap; gap: 8px;
        justify-content: center; }
      /* over the switch of views, where both would not fit in one line */
      @media (min-width: 720px) { @container (max-width: 940px) { .chips { bottom: 68px; } } }
      .chip { pointer-events: auto; display: inline-flex; align-items: center; gap: 6px; min-height: max(36px, var(--hit));
        padding: 0 16px; border: 0; border-radius: var(--r-full); background: var(--paper); color: var(--ink); font: var(--t-strong);
        --frame: var(--lift-1); box-shadow: var(--frame); cursor: pointer; white-space: nowrap;
        transition: transform var(--bounce) var(--squash); }
      .chip:hover { background: var(--desk); }
      .chip:active { transform: scale(1.04, .92); }
      .chip .ico { width: 18px; height: 18px; }
      @media (max-width: 1100px) { .line { font-size: 22px; line-height: 28px; top: 16px; } }
      @media (max-width: 719px) { .line { font-size: 20px; line-height: 26px; top: 12px; } .chips { bottom: 8px; } }
      /* three in one line of a phone */
      @container (max-width: 480px) { .chips { gap: 4px; } .chip { padding: 0 8px; font-size: 12px; } .chip svg { display: none; } }
    `,
  ];

  get boxes(): IntroBoxes {
    return { line: this.renderRoot.querySelector(".line"), chips: this.renderRoot.querySelector(".chips") };
  }

  protected override render() {
    const { cast, motions, opening, selection, context, asks } = this.session;
    const performer = cast.next;
    const motion = motions.next;
    if (!selection.intro || selection.panel !== null || asks) return "";
    const name = cast.presentName.toLowerCase();
    const chip = (words: unknown, choose: () => void) => html`<button class="chip" @click=${choose}>${words}</button>`;
    return html`
      ${context.notices.all.length > 0 ? "" : html`<p class="line">This ${name} has no bones. <b>Drag any dot.</b></p>`}
      <div class="chips">
        ${performer ? chip(`Try ${withArticle(performer.name.toLowerCase())}`, () => void opening.usePerformer(performer)) : ""}
        ${motion ? chip("Try another dance", () => void opening.useMotion(motion)) : ""}
        ${chip(html`${icon("file")}Use my model`, () => void opening.pick())}
      </div>
    `;
  }
}
