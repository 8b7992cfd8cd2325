import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { badge } from "../point-colors";
import { base } from "../styles";

/** Which point is in hand, and how fast we solve. */
@customElement("rigless-status")
export class Status extends SessionElement {
  protected readonly topics = ["selection", "document", "meter", "drag", "solve", "panel", "pairing", "pins", "coverage", "intro"] as const;

  static override styles = [
    base,
    css`
      :host { margin: var(--s2); display: flex; align-items: center; gap: 10px; height: 28px; padding: 0 12px 0 6px;
        border-radius: var(--r-full); background: var(--paper); box-shadow: var(--lift-1); font: var(--t-small); color: var(--ink-2);
        white-space: nowrap; min-width: 0; overflow: hidden; }
      :host([plain]) { padding-left: 12px; }
      b { color: var(--ink); font-weight: 600; }
      i { width: 1px; height: 12px; background: var(--line); }
      @media (max-width: 719px) { :host { margin: 8px; } :host([asking]) { display: none; } }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { selection, context } = session;
    const { points } = session.document;
    const held = session.dragging.active;
    const id = held?.id ?? selection.point;
    const index = points.findIndex((point) => point.id === id);
    const point = points[index];
    this.toggleAttribute("plain", !point);
    this.toggleAttribute("asking", session.asks || (selection.intro && selection.panel === null)); // the chips take its room
    const solved = context.meter.median;
    const speed =
      context.solving && !held
        ? html`<span>solving</span>`
        : solved === null
          ? html`<span>ready</span>`
          : html`<span>solved in <b>${Math.max(1, Math.round(solved))} ms</b></span>`;
    return html`
      ${point ? html`${badge(index + 1)}<span><b>${point.name}</b> ${held ? "held" : "selected"}</span><i></i>` : ""}
      ${held ? html`<span>frame <b>${held.frame}</b></span><i></i>` : ""}
      ${speed}
    `;
  }
}
