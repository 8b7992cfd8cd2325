import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { actionButton, caps } from "../action-button";
import { SessionElement } from "../element";
import { icon, pauseMark, playMark } from "../icons";
import { base } from "../styles";

@customElement("rigless-transport")
export class Transport extends SessionElement {
  protected readonly topics = ["frame", "play", "solve", "document", "pins"] as const;

  static override styles = [
    base,
    css`
      :host { display: flex; align-items: center; gap: var(--s-half); height: 48px; }
      .play { width: max(36px, var(--hit)); aspect-ratio: 1; border-radius: 50%; border: 0; padding: 0; display: grid; place-items: center;
        background: var(--ink); color: var(--on-ink); cursor: pointer; margin: 0 2px; flex: none;
        transition: transform var(--bounce) var(--squash); }
      .play:active { transform: scale(1.1, .88); }
      .play svg { width: 18px; height: 18px; fill: currentColor; stroke: none; }
      .frame { font: var(--t-title); margin-left: var(--s2); min-width: 132px; white-space: nowrap; }
      .frame small { font: var(--t-small); color: var(--ink-3); margin-left: 6px; }
      .watch { display: none; }
      .loop[aria-pressed="true"], .pin[aria-pressed="true"] { background: var(--well); }
      @media (max-width: 719px) {
        :host { height: 60px; gap: 0; }
        .desk { display: none !important; }
        .play { width: 48px; }
        .play svg { width: 22px; height: 22px; }
        .frame { margin-left: 8px; min-width: 40px; }
        .frame small { display: none; }
      }
      @media (max-height: 439px) and (orientation: landscape) {
        .pin, .line { display: none; }
        .desk { display: inline-flex !important; }
        .watch { display: inline; margin-right: var(--s2); }
      }
    `,
  ];

  protected override render() {
    const { actions, pins, player } = this.session;
    return html`
      ${actionButton(actions.poseBefore, { class: "btn icon", drawing: icon("previous") })}
      ${actionButton(actions.play, { class: "play", drawing: player.playing ? pauseMark : playMark })}
      ${actionButton(actions.poseAfter, { class: "btn icon", drawing: icon("next") })}
      <span class="frame">${player.frame}<small>of ${Math.max(0, player.frames - 1)} &nbsp;·&nbsp; ${player.clockWords}</small></span>
      <span class="grow"></span>
      <span class="sub watch">Hold it upright for all the rest.</span>
      ${actionButton(actions.loop, { class: "btn icon loop desk", drawing: icon("loop"), pressed: player.loop })}
      ${actionButton(actions.speed, { class: "btn desk", drawing: html`${player.speed}×`, says: `Speed ${player.speed} times` })}
      ${actionButton(actions.armPin, { class: "btn icon pin", drawing: icon("pin"), pressed: pins.armed })}
      ${actionButton(actions.addPose, { class: "btn line", before: icon("addPose"), after: html` ${caps(actions.addPose)}` })}
    `;
  }
}
