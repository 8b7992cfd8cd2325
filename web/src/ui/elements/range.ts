import { css, html, svg, LitElement } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { base } from "../styles";

const TRACKS = {
  volume: "M2 10.5C70 9 150 5 212 1C222 .5 224 6 224 12S222 23.5 212 23C150 19 70 15 2 13.5C.5 13 .5 11 2 10.5Z",
  smooth: [
    "M1 12L6 5L12 19L18 5L25 19L33 5.5L42 18.5C47.9 18.5 50.1 5.5 56 5.5",
    "C63.6 5.5 66.4 18.5 74 18.5C84.1 18.5 87.9 5.5 98 5.5C111.4 5.5 116.6 18.5 130 18.5",
    "C148.5 18.5 155.5 5.5 174 5.5C196 5.5 214 12 223 12",
  ].join(""),
  energy: "M2 12Q9 10 16 12T30 12T44 12Q53 7 62 12T80 12T98 12Q109 3 120 12T142 12T164 12Q178 -1 192 12T220 12",
} as const;

/** `change` while the thumb moves (with `held`), and once more when it is let go. */
export interface RangeDetail {
  value: number;
  held: boolean;
}

/** A slider whose track draws what the number does. */
@customElement("rigless-range")
export class Range extends LitElement {
  @property() label = "";
  @property() track: keyof typeof TRACKS = "volume";
  @property({ type: Number }) value = 0;
  @property({ type: Number }) min = 0;
  @property({ type: Number }) max = 1;
  /** Where a double-click goes. */
  @property({ type: Number }) rest = 0;
  @property() low = "";
  @property() high = "";
  @state() private held = false;

  static override styles = [
    base,
    css`
      :host { display: block; padding-bottom: 6px; }
      .field-head { display: flex; justify-content: space-between; font: var(--t-strong); }
      output { font: var(--t-body); color: var(--ink-2); }
      .field-ends { display: flex; justify-content: space-between; font: var(--t-small); color: var(--ink-3); margin-top: -5px; }
      .range { position: relative; height: 28px; --x: calc(var(--thumb) / 2 + var(--p) * (100% - var(--thumb))); }
      svg { position: absolute; inset: 2px 0; width: 100%; height: 24px; overflow: visible; }
      path { vector-effect: non-scaling-stroke; }
      .volume path { fill: var(--well); stroke: var(--edge); stroke-width: 1; }
      .volume .on path { fill: var(--ink); stroke: var(--ink); }
      :is(.smooth, .energy) path { fill: none; stroke: var(--edge); stroke-width: 2; stroke-linejoin: round; stroke-linecap: round; }
      :is(.smooth, .energy) .on path { stroke: var(--ink); stroke-width: 3; }
      .on { clip-path: inset(-4px calc(100% - var(--x)) -4px -4px); }
      input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; background: none; appearance: none; cursor: grab;
        border-radius: var(--r-full); }
      input::-webkit-slider-thumb { appearance: none; width: var(--thumb); height: var(--thumb); border-radius: 50%;
        background: var(--paper); border: 2.5px solid var(--ink); transition: transform var(--bounce) var(--squash); }
      input::-moz-range-thumb { width: var(--thumb); height: var(--thumb); border-radius: 50%; background: var(--paper);
        border: 2.5px solid var(--ink); box-sizing: border-box; }
      .is-held input { cursor: grabbing; }
      .is-held input::-webkit-slider-thumb { transform: scale(1.25, .85); background: var(--now); border-color: var(--on-now); }
      @media (max-width: 719px), (max-height: 740px) {
        :host { display: grid; grid-template-columns: 84px 1fr 34px; align-items: center; column-gap: 8px; padding: 0; min-height: 52px; }
        .field-head { display: contents; }
        label { order: 1; }
        .range { order: 2; height: 44px; min-width: 0; }
        output { order: 3; text-align: right; }
        svg { inset: 10px 0; }
        .field-ends { order: 4; grid-column: 2; margin-top: -12px; }
      }
      @media (min-width: 720px) and (max-height: 740px) { :host { min-height: 0; } .field-ends { display: none; } .range { height: 36px; }
        svg { inset: 6px 0; } }
    `,
  ];

  protected override render() {
    const { min, max, value } = this;
    const exact = String(Math.round(100 * value) / 100);
    const shown = (Math.round(10 * value) / 10 || 0).toFixed(1);
    const drawing = svg`<path d=${TRACKS[this.track]}/>`;
    return html`
      <div class="field-head"><label for="slider">${this.label}</label><output for="slider">${shown}</output></div>
      <div class="range ${this.track} ${this.held ? "is-held" : ""}" style="--p:${(value - min) / (max - min)}">
        <svg viewBox="0 0 224 24" preserveAspectRatio="none" aria-hidden="true">${drawing}</svg>
        <svg class="on" viewBox="0 0 224 24" preserveAspectRatio="none" aria-hidden="true">${svg`<path d=${TRACKS[this.track]}/>`}</svg>
        <input id="slider" type="range" min=${min} max=${max} step="0.01" .value=${exact} aria-valuetext=${shown}
          @input=${this.input} @change=${this.change} @dblclick=${this.reset}
          @pointerdown=${() => (this.held = true)} @pointerup=${this.letGo} @pointercancel=${this.letGo} />
      </div>
      <div class="field-ends" aria-hidden="true"><span>${this.low}</span><span>${this.high}</span></div>
    `;
  }

  private readonly input = (event: Event): void => {
    this.value = Number((event.target as HTMLInputElement).value);
    this.tell(true);
  };

  private readonly change = (): void => this.tell(false);

  private readonly letGo = (): void => {
    this.held = false;
  };

  private readonly reset = (): void => {
    this.value = this.rest;
    this.tell(false);
  };

  private tell(held: boolean): void {
    this.dispatchEvent(new CustomEvent<RangeDetail>("range", { detail: { value: this.value, held } }));
  }
}
