import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { labelOf } from "../../app/actions";
import { PANELS } from "../../app/panels";
import type { PanelName } from "../../app/panels";
import { actionButton } from "../action-button";
import { base } from "../styles";

@customElement("rigless-rail")
export class Rail extends SessionElement {
  protected readonly topics = ["panel"] as const;

  static override styles = [
    base,
    css`
      :host { display: block; margin: var(--gap) var(--s2); padding: var(--s-half); width: 72px; background: var(--paper);
        border-radius: var(--r-l);
        box-shadow: var(--lift-1); }
      ul { display: grid; gap: var(--s-half); }
      .panel { display: flex; flex-direction: column; align-items: center; justify-content: center; gap: 2px; width: 64px; height: 64px;
        border: 0; border-radius: 12px; background: none; color: var(--ink-2); font: 600 12px/16px var(--font); cursor: pointer; }
      .panel .ico { width: 26px; height: 26px; }
      .panel:hover { background: var(--well); color: var(--ink); }
      .panel[aria-pressed="true"] { background: var(--ink); color: var(--on-ink); }
      @media (max-height: 740px) { .panel { height: 48px; } }
      @media (max-width: 719px) {
        :host { margin: 0; width: auto; border-radius: 0; box-shadow: none; padding: 4px 8px; border-top: 1px solid var(--line);
          background: var(--desk); }
        ul { grid-template-columns: repeat(4, 1fr); }
        .panel { width: 100%; height: 52px; }
      }
    `,
  ];

  protected override render() {
    return html`<nav aria-label="What to work on"><ul>
      ${PANELS.map(({ id }) => html`<li>${this.renderButton(id)}</li>`)}
    </ul></nav>`;
  }

  private renderButton(panel: PanelName) {
    const { actions, selection } = this.session;
    const label = labelOf(actions[panel]);
    return actionButton(actions[panel], { class: "panel", pressed: selection.panel === panel, drawing: html`${icon(panel)}${label}` });
  }
}
