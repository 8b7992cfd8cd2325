import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base, panel } from "../styles";
import { count, figure, seconds } from "../../util/words";
import "./edit-motion";
import { gallery, galleryStyle } from "./gallery";

@customElement("rigless-panel-motion")
export class MotionPanel extends SessionElement {
  protected readonly topics = ["document", "solve", "coming", "song"] as const;
  static override styles = [
    base,
    panel,
    galleryStyle,
    css`
      /* what can be done to the motion is seen without scrolling */
      @media (min-width: 720px) and (min-height: 741px) { .gallery { max-height: 212px; overflow-y: auto; scrollbar-width: thin; } }
      .more { margin-top: 0; }
      .song { display: flex; align-items: center; gap: 4px; }
      .song span { flex: 1; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .song [aria-pressed="true"] { background: var(--well); }
    `,
  ];

  /** What plays with the dance, whichever that is. */
  private renderSong() {
    const { song, opening } = this.session;
    if (!song?.kept) return html`<div class="more"><button class="btn" @click=${() => opening.pick("song")}>Add a song</button></div>`;
    const { name, muted } = song.kept;
    return html`<div class="more song"><span title=${name}>${name}</span>
      <button class="btn" aria-pressed=${muted} @click=${() => song.mute(!muted)}>Mute</button>
      <button class="btn icon" aria-label="Remove ${name}" title="Remove it" @click=${() => song.remove()}>${icon("close")}</button></div>`;
  }

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
      ${this.renderSong()}
    </section>`;
  }
}
