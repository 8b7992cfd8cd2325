import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { actionButton } from "../action-button";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

@customElement("rigless-view")
export class ViewToggle extends SessionElement {
  protected readonly topics = ["layout"] as const;

  static override styles = [
    base,
    css`
      :host { margin: var(--s2); display: flex; padding: 2px; border-radius: var(--r-m); background: var(--paper);
        box-shadow: var(--lift-1); }
      div { display: flex; }
      .btn { min-height: 28px; border-radius: 8px; font: var(--t-small); padding: 0 10px; }
      .btn[aria-pressed="true"] { background: var(--well); font-weight: 600; }
      rigless-views { inset: var(--at); }
      @media (pointer: coarse) { .btn { min-height: 44px; } }
    `,
  ];

  /** Its list stands over it, at the right. */
  private readonly place = (): void => {
    void import("./late");
    const { right, top } = this.getBoundingClientRect();
    this.style.setProperty("--at", `auto ${innerWidth - right}px ${innerHeight - top + 4}px auto`);
  };

  protected override render() {
    const { actions, selection } = this.session;
    const choice = (layout: "side" | "overlay", label: string) => html`
      <button class="btn" aria-pressed=${selection.layout === layout} @click=${() => selection.setLayout(layout)}>${label}</button>`;
    return html`<div role="group" aria-label="View">
      ${choice("side", "Side by side")}${choice("overlay", "Overlay")}
      ${actionButton(actions.fit, { class: "btn icon", drawing: icon("fit") })}
      <button class="btn icon" aria-label="Views" title="Views" popovertarget="views" @click=${this.place}>${icon("view")}</button>
    </div><rigless-views id="views" popover .session=${this.session}></rigless-views>`;
  }
}
