import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { FPS } from "../../engine/types";
import { SessionElement } from "../element";
import { icon, pauseMark, playMark } from "../icons";
import { SPEEDS } from "../../app/player";
import { base } from "../styles";
import { seconds } from "../../util/words";

@customElement("rigless-transport")
export class Transport extends SessionElement {
  protected readonly topics = ["frame", "play", "solve", "document", "pins"] as const;

  static override styles = [
    base,
    css`
      :host { display: flex; align-items: center; gap: var(--s-half); height: 48px; }
      .play { width: 36px; height: 36px; border-radius: 50%; border: 0; padding: 0; display: grid; place-items: center; background: var(--ink); color: var(--on-ink); cursor: pointer; margin: 0 2px; flex: none; transition: transform var(--bounce) var(--squash); }
      .play:active { transform: scale(1.1, .88); }
      .play svg { width: 18px; height: 18px; fill: currentColor; stroke: none; }
      .frame { font: var(--t-title); margin-left: var(--s2); min-width: 132px; white-space: nowrap; }
      .frame small { font: var(--t-small); color: var(--ink-3); margin-left: 6px; }
      .rule { width: 1px; height: 24px; background: var(--line); margin: 0 var(--s1); }
      .loop[aria-pressed="true"], .pin[aria-pressed="true"] { background: var(--well); }
      @media (max-width: 719px) {
        :host { height: 60px; gap: 0; }
        .desk { display: none !important; }
        .play { width: 48px; height: 48px; }
        .play svg { width: 22px; height: 22px; }
        .frame { margin-left: 8px; min-width: 40px; }
        .frame small { display: none; }
      }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { player } = session;
    const empty = player.frames === 0;
    const poses = session.poses.here.length > 0;
    return html`
      <button class="btn icon" aria-label="Previous pose" title="Previous pose ([)" ?disabled=${!poses} @click=${() => session.poses.step(-1)}>${icon("previous")}</button>
      <button class="play" aria-label=${player.playing ? "Pause" : "Play"} title="${player.playing ? "Pause" : "Play"} (Space)" ?disabled=${empty}
        @click=${() => session.togglePlay()}>${player.playing ? pauseMark : playMark}</button>
      <button class="btn icon" aria-label="Next pose" title="Next pose (])" ?disabled=${!poses} @click=${() => session.poses.step(1)}>${icon("next")}</button>
      <span class="frame">${player.frame}<small>of ${Math.max(0, player.frames - 1)} &nbsp;·&nbsp; ${seconds(player.frame / FPS)}</small></span>
      <span class="grow"></span>
      <i class="rule desk" hidden></i>
      <button class="btn icon loop desk" aria-pressed=${player.loop} aria-label="Loop" title="Loop" @click=${() => player.setLoop(!player.loop)}>${icon("loop")}</button>
      <button class="btn desk" aria-label="Speed ${player.speed} times" title="Speed" @click=${this.nextSpeed}>${player.speed}×</button>
      <button class="btn icon pin" aria-pressed=${session.pins.armed} aria-label="Pin" title="The next drag pins a point at this frame and makes no pose (C)" ?disabled=${!session.canPose} @click=${() => session.pins.arm(!session.pins.armed)}>${icon("pin")}</button>
      <button class="btn line" title="Add a pose at this frame (K)" ?disabled=${!session.canPose} @click=${() => session.keepShape()}>${icon("addPose")}Add pose <kbd>K</kbd></button>
    `;
  }

  private readonly nextSpeed = (): void => {
    const { player } = this.session;
    const at = SPEEDS.findIndex((speed) => speed === player.speed);
    player.setSpeed(SPEEDS[(at + 1) % SPEEDS.length] ?? 1);
  };
}
