import { css, html, nothing, svg } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { base } from "../styles";

/** So many poses make a dance; what follows makes it better. */
const FIRST = 4;

/** A strip as high as a frame is far from what the poses teach; its peak asks for one. */
@customElement("rigless-coverage-strip")
export class CoverageStrip extends SessionElement {
  protected readonly topics = ["document", "solve", "coverage"] as const;

  static override styles = [
    base,
    css`
      :host { display: grid; grid-template-columns: var(--label) minmax(0, 1fr); height: 25px; }
      .label { font: var(--t-small); color: var(--ink-2); align-self: center; white-space: nowrap; }
      .lane { position: relative; margin: 0 var(--end) 0 var(--start); border-top: 1px solid var(--line); }
      svg { position: absolute; inset: 2px 0 0; width: 100%; height: calc(100% - 2px); overflow: visible; }
      path { fill: var(--pencil-soft, var(--well)); stroke: var(--pencil); stroke-width: 1.25; vector-effect: non-scaling-stroke; }
      button { position: absolute; left: clamp(48px, var(--f), calc(100% - 48px)); top: 1px; height: 22px; transform: translateX(-50%);
        padding: 0 10px; border: 0; border-radius: var(--r-full); background: var(--paper); color: var(--pencil);
        font: 600 11px/1 var(--font); box-shadow: inset 0 0 0 1.5px var(--pencil); cursor: pointer; white-space: nowrap; }
      button:hover { background: var(--well); }
      button::before { content: ""; position: absolute; inset: -11px -4px; }
      button:focus-visible { position: absolute; }
      @media (pointer: fine) { button::before { inset: -1px; } }
      @media (max-width: 719px) { :host { grid-template-columns: minmax(0, 1fr); height: 29px; } .label { display: none;
        } button { height: 26px; } }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { performance, coverage } = session;
    if (!performance || performance.frames < 2 || session.document.points.length === 0) return nothing;
    const { have, want } = performance.enough;
    const [best] = coverage.asked;
    const last = performance.frames - 1;
    const first = Math.min(FIRST, want);
    const label = have < first ? `${have} of ${first} poses` : have < want ? "Better still" : "Guesswork";
    const words =
      have < first
        ? `${have} of ${first} poses that would make a start`
        : have < want
          ? `${have} of ${want} poses that would teach this dance`
          : "your poses teach this dance";
    return html`<span class="label" title="How far each frame is from the nearest pose">${label}</span>
      <div class="lane"><svg viewBox="0 0 ${last} 1" preserveAspectRatio="none" role="img" aria-label="Guesswork: ${words}"
        >${svg`<path d=${outline(performance.coverage)} />`}</svg>
        ${best === undefined || coverage.asking !== null ? nothing : this.renderQuestion(best, last)}
      </div>`;
  }

  private renderQuestion(best: number, last: number) {
    return html`<button style="--f:${(100 * best) / last}%" title="Frame ${best} is the farthest from your poses"
      @click=${() => this.session.coverage.ask(best)}>Teach me here</button>`;
  }
}

const HIGHEST = 1.5;

/** An area under T heights, 0 taught to 1 all guesswork, in a box of T - 1 by 1. */
function outline(coverage: Float32Array): string {
  const points = Array.from(coverage, (value, frame) => `${frame} ${(1 - Math.min(1, value / HIGHEST)).toFixed(3)}`);
  return `M0 1L${points.join("L")}L${coverage.length - 1} 1Z`;
}
