import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { base, panel } from "../styles";
import { count, figure, seconds } from "../../util/words";
import "./edit-motion";
import { gallery, galleryStyle } from "./gallery";

@customElement("rigless-panel-motion")
export class MotionPanel extends SessionElement {
  protected readonly topics = ["document", "solve", "coming"] as const;
  static override styles = [
    base,
    panel,
    galleryStyle,
    css`
      /* what can be done to the motion is seen without scrolling */
      @media (min-width: 720px) and (min-height: 741px) { .gallery { max-height: 212px; overflow-y: auto; scrollbar-width: thin; } }
      .more { margin-top: 0; }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { builtins, motions, opening } = session;
    const { motion } = session.context;
    return html`<section class="panel" aria-label="Motion">
      <h2>Motion <button class="btn line" @click=${() => opening.pick("motion")}>Open</button></h2>
      ${gallery(
        motions.list.map((entry) => {
          const file = entry.files.at(-1) ?? "";
          const dance = entry.builtin ? builtins.motions.find((other) => other.file === file) : undefined;
          return {
            name: entry.name,
            detail: dance ? `${entry.name}, ${seconds(dance.seconds)}` : file,
            picture: dance ? builtins.picture(dance) : null,
            fallback: "motion",
            chosen: motions.isPlaying(entry),
            coming: opening.coming === file,
            choose: () => void opening.useMotion(entry),
          };
        }),
      )}
      ${
        motion
          ? html`<p class="note">${count(motion.takeFrames, "frame")} at 30 a second, ${seconds(motion.takeFrames / 30)};
        ${count(motion.joints.length, "joint")}.
        ${Math.abs(motion.source.fps - 30) > 0.01 ? `The file has ${figure(motion.source.fps)} a second.` : ""}</p>
        <rigless-edit-motion .session=${session}></rigless-edit-motion>`
          : ""
      }
    </section>`;
  }
}
