import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { editingOf, type MotionEditing } from "../../app/motion-editing";
import { FPS } from "../../util/constants";
import { seconds } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

const ENDS = ["Begin", "End"] as const;
/** Pixels within which a handle snaps. */
const SNAP = 7;

/** All of the motion, and handles at both ends of what is danced of it. */
@customElement("rigless-take")
export class Take extends SessionElement {
  protected readonly topics = ["document", "solve"] as const;
  /** The handle in the hand, and the cut as it would be. */
  @state() private held: { end: 0 | 1; cut: readonly [number, number] } | null = null;

  static override styles = [
    base,
    css`
      :host { display: grid; grid-template-columns: var(--label) minmax(0, 1fr); height: 36px; align-items: center;
        border-bottom: 1px solid var(--line); margin-bottom: 4px; }
      .label { font: var(--t-small); color: var(--ink-2); white-space: nowrap; }
      .lane { position: relative; margin: 0 var(--end) 0 var(--start); height: 24px; border-radius: 6px; background: var(--well);
        touch-action: pan-y; }
      .steps { position: absolute; inset: 4px 0; width: 100%; height: 16px; }
      .steps path { stroke: var(--edge); stroke-width: 5; vector-effect: non-scaling-stroke; fill: none; }
      .kept { position: absolute; inset: 0 auto 0 var(--a); width: var(--w); border-radius: 6px; background: var(--paper);
        box-shadow: inset 0 0 0 2px var(--ink); overflow: hidden; }
      .best { position: absolute; top: 0; left: var(--f); width: 0; height: 100%; border-left: 2px dashed var(--pencil); }
      .best .ico { position: absolute; top: 5px; left: -7px; width: 14px; height: 14px; padding: 1px; background: var(--paper);
        color: var(--pencil); border-radius: 50%; }
      .handle { position: absolute; z-index: 1; top: -3px; left: var(--f); width: 24px; height: 30px; margin-left: -12px; border: 0;
        padding: 0; background: none; cursor: ew-resize; touch-action: none; border-radius: var(--r-s); }
      .handle::before { content: ""; position: absolute; inset: 3px 7px; border-radius: 4px; background: var(--ink); }
      .handle::after { content: ""; position: absolute; inset: 10px 11px; background: var(--on-ink); }
      .handle:active::before { background: var(--now); }
      .handle:active::after { background: var(--on-now); }
      .handle:focus-visible { position: absolute; }
      .tip { position: absolute; bottom: 100%; left: var(--f); transform: translateX(-50%); padding: 2px 8px; border-radius: var(--r-s);
        background: var(--ink); color: var(--on-ink); font: var(--t-small); white-space: nowrap; pointer-events: none; z-index: 5; }
      @media (max-width: 719px) { :host { grid-template-columns: minmax(0, 1fr); } .label { display: none; } }
      @media (pointer: coarse), (max-width: 719px) {
        :host { height: 48px; }
        .lane { height: 32px; }
        .steps { inset: 8px 0; }
        .best .ico { top: 9px; }
        .handle { width: 44px; height: 44px; top: -6px; margin-left: -22px; }
        .handle::before { inset: 4px 16px; }
        .handle::after { inset: 16px 21px; }
      }
    `,
  ];

  private get editing(): MotionEditing {
    return editingOf(this.session);
  }

  protected override render() {
    const { editing } = this;
    const { take, loop, said } = editing;
    if (!take || take.frames < 3) return html`<span class="label">Whole motion</span><div class="lane"></div>`;
    const last = take.frames - 1;
    const [a, b] = this.held?.cut ?? editing.cut;
    const at = (frame: number): string => `--f:${(100 * frame) / last}%`;
    const suggested = loop && !said.loop && !(loop.cut[0] === a && loop.cut[1] === b) ? loop.cut : [];
    return html`<span class="label" title="All of the file. The handles say what of it is danced.">Whole motion</span>
      <div class="lane">
        <div class="kept" style="--a:${(100 * a) / last}%;--w:${(100 * (b - a)) / last}%"></div>
        ${steps(take.stands, last)}
        ${suggested.map((frame) => html`<span class="best" style=${at(frame)} title="It loops best here">${icon("loop")}</span>`)}
        ${ENDS.map((name, end) => this.renderHandle(name, end as 0 | 1, [a, b][end], last))}
        ${this.held ? html`<span class="tip" style=${at(this.held.cut[this.held.end])}>${this.words()}</span>` : nothing}
      </div>`;
  }

  private renderHandle(name: string, end: 0 | 1, frame: number, last: number) {
    return html`<button class="handle" role="slider" aria-label="${name} of the dance" aria-valuemin="0" aria-valuemax=${last}
      aria-valuenow=${frame} aria-valuetext=${seconds(frame / FPS)} style="--f:${(100 * frame) / last}%"
      title="${name} of the dance, at ${seconds(frame / FPS)}"
      @pointerdown=${(event: PointerEvent) => this.grab(event, end)} @pointermove=${this.move} @pointerup=${this.letGo}
      @pointercancel=${() => (this.held = null)} @keydown=${(event: KeyboardEvent) => this.key(event, end)}></button>`;
  }

  private words(): string {
    const [a, b] = this.held?.cut ?? this.editing.cut;
    return `${seconds(a / FPS)} to ${seconds(b / FPS)}`;
  }

  private grab(event: PointerEvent, end: 0 | 1): void {
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.held = { end, cut: this.editing.cut };
  }

  private readonly move = (event: PointerEvent): void => {
    if (!this.held) return;
    const { left, width } = this.renderRoot.querySelector(".lane")!.getBoundingClientRect();
    const perPixel = ((this.editing.take?.frames ?? 2) - 1) / width;
    const to = Math.round((event.clientX - left) * perPixel);
    this.held = { ...this.held, cut: this.editing.movedEnd(this.held.end, to, event.altKey ? 0 : SNAP * perPixel) };
  };

  private readonly letGo = (): void => {
    const { held } = this;
    this.held = null;
    if (held) this.editing.setCut(held.cut);
  };

  private key(event: KeyboardEvent, end: 0 | 1): void {
    const { editing } = this;
    const by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -FPS, PageUp: FPS }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    editing.setCut(editing.movedEnd(end, editing.cut[end] + by, 0));
  }
}

/** When the left foot stands, over when the right one does. */
function steps({ left, right }: { left: Uint8Array; right: Uint8Array }, last: number) {
  const line = (labels: Uint8Array, y: number): string => {
    let path = "";
    labels.forEach((on, f) => {
      if (!on) return;
      if (!labels[f - 1]) path += `M${f} ${y}`;
      if (!labels[f + 1]) path += `H${f + 0.5}`;
    });
    return path;
  };
  return html`<svg class="steps" viewBox="0 0 ${last} 16" preserveAspectRatio="none" aria-hidden="true">
    <path d="${line(left, 4)}${line(right, 12)}"/></svg>`;
}
