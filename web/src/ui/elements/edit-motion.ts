import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { editingOf, SPEEDS } from "../../app/motion-editing";
import { FPS } from "../../util/constants";
import { seconds } from "../../util/words";
import { SessionElement } from "../element";
import { base, panel } from "../styles";
import "./file-facts";
import { type Option, select } from "./select";
import "./switch";

/** Farther apart than this the ends of a loop are not alike: metres. */
const GAP = 0.12;

/** What can be done to the motion that plays. */
@customElement("rigless-edit-motion")
export class EditMotion extends SessionElement {
  protected readonly topics = ["document", "solve"] as const;

  static override styles = [
    base,
    panel,
    css`
      :host { display: block; }
      .cut { display: flex; align-items: center; gap: 8px; min-height: var(--hit); font: var(--t-body); color: var(--ink-2); }
      .cut b { font: var(--t-strong); color: var(--ink); }
      .pair { grid-template-columns: 72px minmax(0, 1fr); }
      .switches { margin: -6px 0; }
      @media (max-width: 719px) { .switches { display: flex; gap: 8px; margin: 0; } }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { motion } = session.context;
    if (!motion || motion.takeFrames < 3) return nothing;
    const editing = editingOf(session);
    const { speed = 1, mirror = false, loop = false, cut } = editing.said;
    const [a, b] = editing.cut;
    const speeds = [...new Set([...SPEEDS, speed])].sort((p, q) => p - q);
    return html`<div class="more">
      <p class="cut"><span class="grow">Danced from <b>${seconds(a / FPS)}</b> to <b>${seconds(b / FPS)}</b></span>
        ${cut ? html`<button class="btn line" title="Dance all of it" @click=${() => editing.setCut(null)}>All</button>` : nothing}</p>
      <div class="switches">
        <rigless-switch label="Make it a loop" effect=${this.loopEffect(loop)} .on=${loop}
          @switch=${(event: CustomEvent<boolean>) => editing.setLoop(event.detail)}></rigless-switch>
        <rigless-switch label="Mirrored" effect=${mirror ? "Left and right have changed places" : "Left is left"} .on=${mirror}
          @switch=${(event: CustomEvent<boolean>) => editing.setMirror(event.detail)}></rigless-switch>
      </div>
      ${select(
        "Speed",
        `${speed}`,
        speeds.map((one): Option => [`${one}`, one === 1 ? "As filmed" : `${one} times as fast`]),
        (value) => editing.setSpeed(Number(value)),
      )}
      <rigless-file-facts .session=${session}></rigless-file-facts>
    </div>`;
  }

  private loopEffect(on: boolean): string {
    const { loop, cut } = editingOf(this.session);
    if (on) return `It comes round every ${seconds((cut[1] - cut[0]) / FPS)}`;
    if (!loop) return "It ends as filmed";
    const [a, b] = loop.cut.map((frame) => seconds(frame / FPS));
    return loop.gap > GAP ? `Best from ${a} to ${b}, with a stir` : `It comes round from ${a} to ${b}`;
  }
}
