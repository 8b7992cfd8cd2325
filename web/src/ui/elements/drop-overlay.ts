import { css, html, LitElement } from "lit";
import { customElement } from "lit/decorators.js";
import { TAKEN } from "../../app/file-words";
import { icon } from "../icons";
import { base } from "../styles";

/** Shown while files hang over the window. Browsers hide their names until the drop, so it says what we take. */
@customElement("rigless-drop")
export class DropOverlay extends LitElement {
  static override styles = [
    base,
    css`
      :host { position: fixed; inset: 0; z-index: 20; pointer-events: none; }
      .drop { position: absolute; inset: 12px; border-radius: 20px; border: 2.5px dashed var(--ink);
        background: light-dark(rgb(255 255 255 / .72), rgb(26 35 42 / .72)); }
      .words { position: absolute; left: 0; right: 0; top: 12%; text-align: center; padding: 0 32px; }
      h2 { font: var(--t-display); letter-spacing: -.02em; }
      p { color: var(--ink-2); }
      .card { position: absolute; top: 40%; display: flex; align-items: center; gap: 8px; padding: 10px 16px 10px 10px;
        background: var(--paper); border-radius: 12px; box-shadow: inset 0 0 0 1.5px var(--ink); }
      .card b { display: block; font: var(--t-strong); line-height: 18px; }
      .card span span { display: block; font: var(--t-small); color: var(--ink-3); }
      .left { left: 12%; transform: rotate(-5deg); }
      .right { right: 12%; transform: rotate(4deg); }
      @media (max-width: 719px) { .left { left: 24px; top: 34%; } .right { right: 24px; top: 48%; } }
    `,
  ];

  protected override render() {
    return html`<div class="drop"></div>
      <div class="words"><h2>Drop it anywhere.</h2><p>Models, motions, a song, projects: all at once, in any order.</p></div>
      <div class="card left">${icon("file")}<span><b>A model</b><span>${TAKEN.models}</span></span></div>
      <div class="card right">${icon("file")}<span><b>A motion</b><span>${TAKEN.motions}</span></span></div>`;
  }
}
