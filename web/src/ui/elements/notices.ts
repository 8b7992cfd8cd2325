import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

/** What happened, what we did, what you can do. Stays until dismissed; one live region for the page. */
@customElement("rigless-notices")
export class NoticesElement extends SessionElement {
  protected readonly topics = ["notices"] as const;

  static override styles = [
    base,
    css`
      :host { display: block; max-width: 640px; pointer-events: none; }
      .list { display: grid; gap: var(--s1); justify-items: center; }
      .notice { pointer-events: auto; display: grid; grid-template-columns: auto 1fr auto; gap: 0 12px; align-items: center;
        background: var(--paper); border-radius: var(--r-l); box-shadow: var(--lift-1); padding: 10px 8px 10px 12px;
        animation: come var(--slow) var(--ease); max-width: 100%; }
      @keyframes come { from { opacity: 0; transform: translateY(-8px); } }
      .badge { width: 36px; height: 36px; border-radius: 50%; display: grid; place-items: center; background: var(--well);
        color: var(--ink); }
      .bad .badge { background: var(--bad-soft); color: var(--bad); }
      h3 { font: var(--t-strong); overflow-wrap: anywhere; }
      p { font: var(--t-small); color: var(--ink-2); overflow-wrap: anywhere; }
      .acts { display: flex; gap: var(--s-half); align-items: center; }
      .rest { pointer-events: auto; justify-self: center; font: var(--t-small); color: var(--ink-2); background: var(--paper);
        border-radius: var(--r-full); padding: 4px 12px; box-shadow: var(--lift-1); }
      @media (max-width: 719px) {
        :host { max-width: none; }
        .list { justify-items: stretch; }
        .notice { padding: 8px; gap: 0 8px; }
        .badge { width: 32px; height: 32px; }
        h3 { line-height: 16px; }
      }
    `,
  ];

  protected override render() {
    const { notices } = this.session.context;
    return html`<div class="list" role="status" aria-live="polite">
      ${repeat(
        notices.shown,
        (notice) => notice.id,
        (notice) => html`
        <div class="notice ${notice.bad ? "bad" : ""}">
          <span class="badge">${icon(notice.icon)}</span>
          <div><h3>${notice.title}</h3>${notice.text ? html`<p>${notice.text}</p>` : ""}</div>
          <div class="acts">
            ${notice.actions.map(
              (action) =>
                html`<button class="btn line" @click=${() => {
                  notices.dismiss(notice.id);
                  action.run();
                }}>${action.label}</button>`,
            )}
            <button class="btn icon" aria-label="Dismiss" @click=${() => notices.dismiss(notice.id)}>${icon("close")}</button>
          </div>
        </div>`,
      )}
      ${notices.hidden > 0 ? html`<p class="rest">${notices.hidden} more</p>` : ""}
    </div>`;
  }
}
