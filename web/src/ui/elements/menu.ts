import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { actionButton } from "../action-button";
import { SessionElement } from "../element";
import { base } from "../styles";
import { views } from "./views";

/** What a phone has no room for in its bars. */
@customElement("rigless-menu")
export class Menu extends SessionElement {
  protected readonly topics = ["play", "layout", "document"] as const;

  static override styles = [
    base,
    css`
      :host { inset: 60px 8px auto auto; margin: 0; padding: var(--s1); border: 0; background: var(--paper); color: var(--ink);
        border-radius: var(--r-l); box-shadow: var(--lift-2); max-height: calc(100dvh - 76px); overflow-y: auto; }
      div { display: grid; }
      .btn { justify-content: flex-start; }
      .btn[aria-pressed="true"] { background: var(--well); }
      div + div { border-top: 1px solid var(--line); margin-top: 4px; padding-top: 4px; }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("toggle", this.opened);
    this.addEventListener("keydown", this.keyed);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("toggle", this.opened);
    this.removeEventListener("keydown", this.keyed);
  }

  protected override render() {
    const { actions, player, selection } = this.session;
    const over = selection.layout === "overlay";
    return html`<div @click=${() => this.hidePopover()}>
        ${[actions.open, actions.save, actions.help].map((action) => actionButton(action))}
      </div>
      <div @click=${() => this.hidePopover()}>${views(this.session)}</div>
      <div>
        ${actionButton(actions.loop, { pressed: player.loop })}
        ${actionButton(actions.speed, { after: html` ${player.speed}×` })}
        <button class="btn" aria-pressed=${over} @click=${() => selection.setLayout(over ? "side" : "overlay")}>Overlay</button>
      </div>`;
  }

  private readonly opened = (event: Event): void => {
    if ((event as ToggleEvent).newState === "open") this.renderRoot.querySelector("button")?.focus();
  };

  /** Esc closes it, and nothing behind it. */
  private readonly keyed = (event: KeyboardEvent): void => {
    if (event.key === "Escape") event.stopPropagation();
  };
}
