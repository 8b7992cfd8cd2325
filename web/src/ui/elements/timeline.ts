import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Example } from "../../app/poses";
import { SessionElement } from "../element";
import { rulerStep } from "../ruler";
import { base } from "../styles";
import "./contact-rows";
import "./coverage-strip";

/** Cels at least this far apart show: pixels. */
const CEL = 34;

/** Ruler, poses as cels on diamonds, and who stands on the ground when. */
@customElement("rigless-timeline")
export class Timeline extends SessionElement {
  protected readonly topics = ["frame", "play", "document", "solve", "thumbnails", "coverage", "panel"] as const;
  @state() private width = 1000;
  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry) this.width = entry.contentRect.width;
  });

  static override styles = [
    base,
    css`
      :host { display: block; --label: 136px; --end: 20px; --start: 0px; }
      .tl { position: relative; display: grid; grid-template-columns: var(--label) 1fr; }
      .tl-label { display: flex; align-items: center; font: var(--t-small); color: var(--ink-2); min-width: 0; }
      rigless-contact-rows, rigless-coverage-strip { grid-column: 1 / -1; }
      .lane { position: relative; margin: 0 var(--end) 0 var(--start); }
      .ruler { height: 20px; border-bottom: 1px solid var(--edge); background:
        repeating-linear-gradient(90deg, var(--edge) 0 1px, transparent 1px var(--major)) 0 100% / calc(100% + 1px) 8px no-repeat,
        repeating-linear-gradient(90deg, var(--line) 0 1px, transparent 1px var(--minor)) 0 100% / calc(100% + 1px) 5px no-repeat; }
      .ruler span { position: absolute; top: 0; left: var(--f); transform: translateX(-50%); font: 400 11px/12px var(--font);
        color: var(--ink-3); pointer-events: none; }
      /* the hit area of the playhead reaches over the ruler and into the poses */
      .scrub { position: absolute; inset: -6px -1px -6px -1px; width: calc(100% + 2px); height: 32px; margin: 0; appearance: none;
        background: none; cursor: ew-resize; touch-action: none; border-radius: var(--r-s); }
      .scrub::-webkit-slider-thumb { appearance: none; width: 2px; height: 32px; background: none; }
      .scrub::-moz-range-thumb { width: 2px; height: 32px; background: none; border: 0; }
      .poses { height: 52px; }

      .pose { position: absolute; z-index: 3; left: var(--f); top: 4px; width: 40px; height: 48px; margin-left: -20px; border: 0;
        background: none; padding: 0; cursor: pointer; border-radius: var(--r-s); }
      .pose .thumb { width: 40px; height: 38px; transition: transform var(--bounce) var(--squash); }
      .pose:hover .thumb { transform: translateY(-2px); }
      .pose::after { content: ""; position: absolute; left: 50%; bottom: 2px; width: 11px; height: 11px; margin-left: -5.5px;
        transform: rotate(45deg); border-radius: 2px; background: var(--ink); box-shadow: 0 0 0 2px var(--desk); }
      /* where poses crowd, the diamond is enough until one is looked at */
      .pose.crowded:not(.sel, :hover, :focus-visible) .thumb { visibility: hidden; }
      .pose.sel, .pose:hover { z-index: 4; }
      .pose.sel .thumb { box-shadow: inset 0 0 0 2px var(--ink); }
      .pose.sel::after { background: var(--now); box-shadow: inset 0 0 0 1.5px var(--on-now), 0 0 0 2px var(--desk); }
      .pose:focus-visible { position: absolute; }
      .pose.mirrored .thumb { opacity: .5; transform: scaleX(-1); }
      .pose.mirrored:hover .thumb { transform: scaleX(-1) translateY(-2px); }
      .pose.mirrored::after { background: var(--desk); box-shadow: inset 0 0 0 1.75px var(--ink), 0 0 0 2px var(--desk); }
      .pose.asked { z-index: 2; }
      .pose.asked .thumb { background: none; box-shadow: none; outline: 1.5px dashed var(--pencil); outline-offset: -1.5px; display: grid;
        place-items: center; color: var(--pencil); font: 600 18px/1 var(--font); }
      .pose.asked::after { background: var(--desk); box-shadow: inset 0 0 0 1.5px var(--pencil), 0 0 0 2px var(--desk); }
      .pose.asked.sel .thumb { background: var(--paper); }
      .hint { position: absolute; inset: 0; display: flex; align-items: center; font: var(--t-small); color: var(--ink-3);
        pointer-events: none; }

      .playhead { position: absolute; z-index: 2;
        left: calc(var(--label) + var(--start) + var(--k) * (100% - var(--label) - var(--start) - var(--end))); top: 0; bottom: 0;
        width: 0; pointer-events: none; }
      .playhead::before { content: ""; position: absolute; left: -.75px; top: 16px; bottom: 0; width: 1.5px; background: var(--now-edge); }
      .playhead b { position: absolute; top: 0; left: 0; transform: translateX(-50%); height: 18px; min-width: 30px; padding: 0 6px;
        display: grid; place-items: center; font: 700 11px/1 var(--font); background: var(--now); color: var(--on-now);
        border-radius: 5px; box-shadow: 0 0 0 1.5px var(--on-now); }
      @media (pointer: coarse) { .pose { width: 44px; margin-left: -22px; justify-items: center; } }
      @media (max-width: 719px) {
        :host { --label: 0px; --end: 20px; --start: 20px; }
        .tl { grid-template-columns: 1fr; }
        .tl-label { display: none; }
        :host([cutting]) :is(.poses, rigless-coverage-strip) { display: none; }
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
  }

  protected override render() {
    const { player } = this.session;
    const last = Math.max(1, player.frames - 1);
    const cutting = this.session.selection.panel === "motion";
    this.toggleAttribute("cutting", cutting);
    return html`${cutting ? html`<rigless-take .session=${this.session}></rigless-take>` : nothing}
      <div class="tl">
      <span class="tl-label"></span>${this.renderRuler(last)}
      <span class="tl-label">Poses</span>${this.renderPoses(last)}
      <rigless-contact-rows .session=${this.session}></rigless-contact-rows>
      <rigless-coverage-strip .session=${this.session}></rigless-coverage-strip>
      ${player.frames > 0 ? html`<div class="playhead" style="--k:${player.frame / last}"><b>${player.frame}</b></div>` : nothing}
    </div>`;
  }

  private get laneWidth(): number {
    return this.width - (this.width < 700 ? 40 : 156);
  }

  private renderRuler(last: number) {
    const { player } = this.session;
    const step = rulerStep(last, this.laneWidth);
    const labels = Array.from({ length: Math.floor(last / step) + 1 }, (_, k) => k * step);
    return html`<div class="lane ruler" style="--major:${(100 * step) / last}%;--minor:${(20 * step) / last}%">
      ${labels.map((frame) => html`<span style="--f:${(100 * frame) / last}%">${frame}</span>`)}
      <input class="scrub" type="range" min="0" max=${last} step="1" aria-label="Frame" ?disabled=${player.frames === 0}
        .value=${String(player.frame)} @input=${this.scrub} @keydown=${this.arrowKeys} />
    </div>`;
  }

  private renderPoses(last: number) {
    const { session } = this;
    const poses = session.poses.here;
    const now = session.player.frame;
    let cel = -Infinity; // the last frame whose cel shows
    const room = (CEL * last) / (this.laneWidth || 1);
    const at = (frame: number): string => `--f:${(100 * Math.min(frame, last)) / last}%`;
    return html`<div class="lane poses">
      ${session.coverage.asked.map(
        (frame) => html`<button class="pose asked ${frame === session.coverage.asking ? "sel" : ""}" style=${at(frame)}
          title="Frame ${frame} would teach much" aria-label="Make the pose that is asked for at frame ${frame}"
          @click=${() => session.coverage.ask(frame)}><span class="thumb">+</span></button>`,
      )}
      ${session.poses.mirrored.map(
        ({ pose, frame }) => html`<button class="pose mirrored" style=${at(frame)}
          title="Mirror image of the pose at ${session.poses.frameOf(pose)}" aria-label="Mirrored pose at frame ${frame}"
          @click=${() => session.poses.visit(frame)}>${this.renderThumbnail(pose)}</button>`,
      )}
      ${poses.map((pose) => {
        const frame = session.poses.frameOf(pose);
        const crowded = frame - cel < room;
        if (!crowded) cel = frame;
        return html`<button class="pose ${frame === now ? "sel" : ""} ${crowded ? "crowded" : ""}" style=${at(frame)}
          aria-label="Pose at frame ${frame}" aria-current=${frame === now ? "true" : nothing}
          @click=${() => session.poses.goTo(pose.id)}>${this.renderThumbnail(pose)}</button>`;
      })}
      ${
        poses.length === 0 && session.player.frames > 0 ? html`<span class="hint">Drag a dot at any frame: that becomes a pose.</span>` : ""
      }
    </div>`;
  }

  private renderThumbnail(pose: Example) {
    const picture = this.session.thumbnails.of(pose);
    return html`<span class="thumb">${picture ? html`<img src=${picture} alt="" />` : ""}</span>`;
  }

  private readonly scrub = (event: Event): void => {
    const { player } = this.session;
    player.pause();
    player.seek(Number((event.target as HTMLInputElement).value));
  };

  /** Arrows move the playhead; the page's own keys still reach the page. */
  private readonly arrowKeys = (event: KeyboardEvent): void => {
    if (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End") event.stopPropagation();
  };
}
