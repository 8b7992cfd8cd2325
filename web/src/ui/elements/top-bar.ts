import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { SessionElement } from "../element";
import { brandMark, icon } from "../icons";
import { base } from "../styles";

@customElement("rigless-top-bar")
export class TopBar extends SessionElement {
  protected readonly topics = ["document", "files", "solve"] as const;
  @state() private menu = false;

  static override styles = [
    base,
    css`
      :host { display: flex; align-items: center; gap: var(--s-half); padding: 0 var(--s2); background: var(--desk); border-bottom: 1px solid var(--line); }
      .brand { display: flex; align-items: center; gap: var(--s1); font: var(--t-title); letter-spacing: -.015em; margin-right: var(--s1); }
      .brand svg { width: 28px; height: 28px; }
      .rule { width: 1px; height: 24px; background: var(--line); margin: 0 var(--s1); }
      .project { font: var(--t-strong); border-radius: var(--r-s); padding: 6px 8px; border: 0; background: none; color: inherit; field-sizing: content; min-width: 48px; max-width: 240px; text-overflow: ellipsis; }
      .project:hover { background: var(--well); }
      .saved { font: var(--t-small); color: var(--ink-3); white-space: nowrap; }
      .undo { display: flex; margin-left: var(--s2); }
      .menu { display: none; }
      @media (max-width: 719px) {
        :host { padding: 0 12px; gap: 0; }
        .brand span, .saved, .wide, .rule { display: none; }
        .brand { margin-right: 4px; }
        .project { min-height: 44px; font-size: 16px; flex: 1; min-width: 0; max-width: none; }
        .undo { margin: 0; }
        .primary { margin-left: 8px; }
        .menu { display: inline-flex; }
        .sheet { position: absolute; z-index: 6; top: 52px; right: 8px; padding: var(--s1); background: var(--paper); border-radius: var(--r-l); box-shadow: var(--lift-2); display: grid; }
        .sheet .btn { justify-content: flex-start; }
      }
    `,
  ];

  protected override render() {
    const { session } = this;
    return html`
      <h1 class="brand" aria-label="Rigless">${brandMark}<span aria-hidden="true">Rigless</span></h1>
      <i class="rule"></i>
      <input class="project" aria-label="Name of the project" spellcheck="false" autocomplete="off"
        .value=${session.document.name} @change=${this.rename} @keydown=${this.leave} />
      <span class="saved" aria-live="off">${session.saved ? "Saved" : "Not saved yet"}</span>
      <span class="undo">
        <button class="btn icon" aria-label="Undo" title="Undo (Ctrl+Z)" ?disabled=${!session.canUndo} @click=${() => session.undo()}>${icon("undo")}</button>
        <button class="btn icon" aria-label="Redo" title="Redo (Ctrl+Shift+Z)" ?disabled=${!session.canRedo} @click=${() => session.redo()}>${icon("redo")}</button>
      </span>
      <span class="grow wide"></span>
      <button class="btn wide" @click=${() => session.pickFiles()}>Open</button>
      <button class="btn wide" title="Save (Ctrl+S)" @click=${() => session.save()}>Save</button>
      <button class="btn icon wide" aria-label="Help and keys" title="Help and keys (?)" @click=${() => session.setHelp(true)}>${icon("help")}</button>
      <button class="btn icon menu" aria-label="File menu" aria-expanded=${this.menu} @click=${() => (this.menu = !this.menu)}>${icon("file")}</button>
      <button class="btn primary" @click=${() => session.exportModel()} ?disabled=${!session.canExport}>Export</button>
      ${this.menu ? this.renderMenu() : ""}
    `;
  }

  private renderMenu() {
    const item = (label: string, run: () => void) =>
      html`<button class="btn" @click=${() => {
        this.menu = false;
        run();
      }}>${label}</button>`;
    return html`<div class="sheet">
      ${item("Open", () => this.session.pickFiles())}
      ${item("Save", () => void this.session.save())}
      ${item("Help and keys", () => this.session.setHelp(true))}
    </div>`;
  }

  private readonly rename = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    const name = input.value.trim();
    if (name === "") input.value = this.session.document.name;
    else this.session.rename(name);
  };

  private readonly leave = (event: KeyboardEvent): void => {
    const input = event.target as HTMLInputElement;
    if (event.key === "Escape") input.value = this.session.document.name;
    if (event.key === "Enter" || event.key === "Escape") input.blur();
  };
}
