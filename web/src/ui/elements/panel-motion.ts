import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { count, figure, seconds, stem } from "../words";

@customElement("rigless-panel-motion")
export class MotionPanel extends SessionElement {
  protected readonly topics = ["document", "solve"] as const;
  static override styles = [base, panel];

  protected override render() {
    const { session } = this;
    const motion = session.motion;
    return html`<section class="panel" aria-label="Motion">
      <h2>Motion <button class="btn line" @click=${() => session.pickFiles("motion")}>Open</button></h2>
      <ul>${session.motions.list.map((entry) => html`<li>
        <button class="item" aria-pressed=${session.motions.isPlaying(entry)} @click=${() => session.useMotion(entry)}>
          ${icon("motion")}<span>${stem(entry.files.at(-1) ?? "")}</span><small>${entry.builtin ? "built in" : ""}</small></button></li>`)}
      </ul>
      ${motion ? html`<p class="note">${count(motion.frames, "frame")} at 30 a second, ${seconds(motion.frames / 30)}; ${count(motion.joints.length, "joint")}.
        ${Math.abs(motion.source.fps - 30) > 0.01 ? `The file has ${figure(motion.source.fps)} a second.` : ""}</p>` : ""}
    </section>`;
  }
}
