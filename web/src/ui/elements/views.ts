import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import type { Session } from "../../app/session";
import { actionButton } from "../action-button";
import { SessionElement } from "../element";
import { base } from "../styles";

/** From where the stage is seen. */
export function views({ actions, selection }: Session) {
  return html`${actionButton(actions.fit)}${actionButton(actions.threeQuarter)}${actionButton(actions.side)}${actionButton(actions.top)}
    ${actionButton(actions.turn, { pressed: selection.turning })}`;
}

/** The same over a button of the stage. */
@customElement("rigless-views")
export class Views extends SessionElement {
  protected readonly topics = ["layout"] as const;

  static override styles = [
    base,
    css`
      :host { margin: 0; padding: var(--s1); border: 0; background: var(--paper); color: var(--ink); border-radius: var(--r-l);
        box-shadow: var(--lift-2); }
      div { display: grid; }
      .btn { justify-content: flex-start; }
      .btn[aria-pressed="true"] { background: var(--well); }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener("toggle", this.opened);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener("toggle", this.opened);
  }

  protected override render() {
    return html`<div @click=${() => this.hidePopover()}>${views(this.session)}</div>`;
  }

  private readonly opened = (event: Event): void => {
    if ((event as ToggleEvent).newState === "open") this.renderRoot.querySelector("button")?.focus();
  };
}
