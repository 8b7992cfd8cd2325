import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { actionButton } from "../action-button";
import { SessionElement } from "../element";
import { brandMark, icon } from "../icons";
import { base } from "../styles";

@customElement("rigless-top-bar")
export class TopBar extends SessionElement {
  protected readonly topics = ["document", "saved", "solve"] as const;

  static override styles = [
    base,
    css`
      :host { display: flex; align-items: center; gap: var(--s-half); padding: 0 var(--s2); background: var(--desk);
        border-bottom: 1px solid var(--line); }
      .brand { display: flex; align-items: center; gap: var(--s1); font: var(--t-title); letter-spacing: -.015em; margin-right: var(--s1); }
      .brand svg { width: 28px; height: 28px; }
      .rule { width: 1px; height: 24px; background: var(--line); margin: 0 var(--s1); }
      .project { font: var(--t-strong); border-radius: var(--r-s); padding: 0 8px; min-height: var(--hit); border: 0; background: none;
        color: inherit;
        field-sizing: content; min-width: 48px; max-width: 240px; text-overflow: ellipsis; }
      .project:hover { background: var(--well); }
      .saved { font: var(--t-small); color: var(--ink-3); white-space: nowrap; }
      .undo { display: flex; margin-left: var(--s2); }
      .menu { display: none; }
      @media (max-width: 719px) {
        :host { padding: 0 12px; gap: 0; }
        .brand span, .saved, .wide, .rule { display: none; }
        .brand { margin-right: 4px; }
        .project { font-size: 16px; flex: 1; min-width: 0; max-width: none; }
        .undo { margin: 0; }
        .primary { margin-left: 8px; }
        .menu { display: inline-flex; }
      }
    `,
  ];

  protected override render() {
    const { actions, document, history } = this.session;
    return html`
      <h1 class="brand" aria-label="Rigless">${brandMark}<span aria-hidden="true">Rigless</span></h1>
      <i class="rule"></i>
      <input class="project" aria-label="Name of the project" spellcheck="false" autocomplete="off"
        .value=${document.name} @change=${this.rename} @keydown=${this.leave} />
      <span class="saved" aria-live="off">${history.saved ? "Saved" : history.unkept ? "Not saved yet" : "Kept in this browser"}</span>
      <span class="undo">
        ${actionButton(actions.undo, { class: "btn icon", drawing: icon("undo") })}
        ${actionButton(actions.redo, { class: "btn icon", drawing: icon("redo") })}
      </span>
      <span class="grow wide"></span>
      ${actionButton(actions.open, { class: "btn wide" })}
      ${actionButton(actions.save, { class: "btn wide" })}
      ${actionButton(actions.help, { class: "btn icon wide", drawing: icon("help") })}
      <button class="btn icon menu" aria-label="Menu" popovertarget="menu" @click=${this.bringMenu}>${icon("more")}</button>
      ${actionButton(actions.export, { class: "btn primary" })}
      <rigless-menu id="menu" popover .session=${this.session}></rigless-menu>
    `;
  }

  private bringMenu(): void {
    void import("./late");
  }

  private readonly rename = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    const name = input.value.trim();
    if (name === "") input.value = this.session.document.name;
    else this.session.settings.rename(name);
  };

  private readonly leave = (event: KeyboardEvent): void => {
    const input = event.target as HTMLInputElement;
    if (event.key === "Escape") input.value = this.session.document.name;
    if (event.key === "Enter" || event.key === "Escape") input.blur();
  };
}
