import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base } from "../styles";

/** A switch whose second line says its effect. Fires `switch` with the new state. */
@customElement("rigless-switch")
export class Switch extends LitElement {
  @property() label = "";
  @property() effect = "";
  @property({ type: Boolean }) on = false;

  static override styles = [
    base,
    css`
      label { display: flex; align-items: center; gap: var(--s1); min-height: 44px; cursor: pointer; }
      .txt { flex: 1; }
      b { display: block; font: var(--t-strong); line-height: 16px; }
      .sub { display: block; }
      input { appearance: none; margin: 0; width: 36px; height: 22px; border-radius: var(--r-full); background: var(--paper);
        --frame: inset 0 0 0 var(--stroke) var(--edge); box-shadow: var(--frame); position: relative; cursor: pointer;
        transition: background var(--base); flex: none; }
      input::after { content: ""; position: absolute; left: 4px; top: 4px; width: 14px; height: 14px; border-radius: 50%;
        background: var(--edge); transition: transform var(--bounce) var(--squash); }
      input:checked { background: var(--ink); --frame: 0 0 transparent; }
      input:checked::after { transform: translateX(14px); background: var(--on-ink); }
      @media (max-height: 740px) { label { min-height: max(36px, var(--hit)); } .sub { display: none; } }
      @media (max-width: 719px) {
        :host { flex: 1 1 auto; }
        label { justify-content: center; border-radius: var(--r-m); box-shadow: inset 0 0 0 var(--stroke) var(--edge); padding: 0 8px; }
        .txt { flex: none; }
        .sub { display: none; }
        b { display: inline; white-space: nowrap; }
        input { position: absolute; opacity: 0; }
        label:has(:checked) { background: var(--well); box-shadow: inset 0 0 0 var(--stroke) var(--ink); }
        label:has(:checked) .txt::before { content: ""; display: inline-block; width: 10px; height: 5px; margin-right: 8px;
          border: solid var(--ink); border-width: 0 0 2px 2px; transform: translateY(-3px) rotate(-45deg); }
        label:has(:focus-visible) { box-shadow: 0 0 0 2px var(--paper), 0 0 0 4px var(--ink), 0 0 0 7px var(--now); }
      }
    `,
  ];

  protected override render() {
    return html`<label>
      <span class="txt"><b id="name">${this.label}</b><span class="sub" id="effect">${this.effect}</span></span>
      <input type="checkbox" role="switch" aria-labelledby="name" aria-describedby="effect" .checked=${this.on} @change=${this.change} />
    </label>`;
  }

  private readonly change = (event: Event): void => {
    this.on = (event.target as HTMLInputElement).checked;
    this.dispatchEvent(new CustomEvent<boolean>("switch", { detail: this.on }));
  };
}
