import { css, html, type PropertyValues } from "lit";
import { customElement, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { Notice } from "../../app/notices";
import { count } from "../../util/words";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { base } from "../styles";

/** So long a notice stays on the stage; what went wrong stays until it is dismissed. */
const READ_MS = 10_000;

/** At once on the stage: the newest, and what went wrong. */
const MOST = 2;

/** What happened, what we did, what you can do: the newest in one line, which fades into a bell with the whole list. */
@customElement("rigless-notices")
export class NoticesElement extends SessionElement {
  protected readonly topics = ["notices"] as const;
  /** The whole list shows. */
  @state() private open = false;
  /** The newest one that has been read. */
  @state() private read = 0;
  private newest = 0;
  private fading: ReturnType<typeof setTimeout> | undefined;

  static override styles = [
    base,
    css`
      :host { display: block; max-width: 640px; pointer-events: none; }
      .list { display: grid; gap: var(--s1); justify-items: center; max-height: 34vh; overflow-y: auto; }
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
      .bell { pointer-events: auto; display: flex; gap: 4px; align-items: center; justify-content: center; margin-left: auto;
        min-width: max(36px, var(--hit)); height: max(36px, var(--hit)); padding: 0 10px; border: 0; border-radius: var(--r-full);
        background: var(--well); color: var(--ink); font: var(--t-small); cursor: pointer; }
      :host([quiet]) .bell { background: var(--paper); box-shadow: var(--lift-1); }
      .bell svg { width: 16px; height: 16px; }
      @media (max-width: 719px) {
        :host { max-width: none; }
        .list { justify-items: stretch; }
        .notice { padding: 8px; gap: 0 8px; }
        .badge { width: 32px; height: 32px; }
        h3 { line-height: 16px; }
      }
    `,
  ];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.fading);
  }

  protected override willUpdate(changed: PropertyValues): void {
    super.willUpdate(changed);
    const [newest] = this.session.context.notices.all;
    if (!newest) this.open = false;
    if (!newest || newest.id === this.newest) return;
    if (newest.id < this.newest) {
      this.read = this.newest; // one was dismissed: those before it do not come back
      return;
    }
    this.newest = newest.id;
    this.fade();
  }

  protected override updated(): void {
    this.toggleAttribute("quiet", this.shown.length === 0);
  }

  protected override render() {
    const [first] = this.shown;
    return html`<div class="list" role="status" aria-live="polite" @pointerenter=${this.stay} @pointerleave=${this.fade}
      @focusin=${this.stay} @focusout=${this.fade}>
      ${repeat(
        this.shown,
        ({ id }) => id,
        (notice) => this.renderNotice(notice, notice === first),
      )}
      </div>
      ${first ? "" : this.renderBell()}`;
  }

  private renderNotice(notice: Notice, first: boolean) {
    const { notices } = this.session.context;
    return html`<div class="notice ${notice.bad ? "bad" : ""}">
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
        ${first ? this.renderBell() : ""}
        <button class="btn icon" aria-label="Dismiss" @click=${() => notices.dismiss(notice.id)}>${icon("close")}</button>
      </div>
    </div>`;
  }

  /** Opens the whole list, and closes it. */
  private renderBell() {
    const { all } = this.session.context.notices;
    const more = all.length - this.shown.length;
    if (more === 0 && !this.open) return "";
    return html`<button class="bell" aria-expanded=${this.open} title=${this.open ? "Only the newest" : "All notices"}
      aria-label=${this.open ? "Only the newest notice" : `All ${count(all.length, "notice")}`}
      @click=${() => (this.open = !this.open)}>${icon("bell")}${this.open ? "" : more}</button>`;
  }

  private get shown(): readonly Notice[] {
    const { all } = this.session.context.notices;
    if (this.open) return all;
    return all.filter(({ id, bad }, n) => bad || (n === 0 && id > this.read)).slice(0, MOST);
  }

  private readonly stay = (): void => clearTimeout(this.fading);

  private readonly fade = (): void => {
    clearTimeout(this.fading);
    this.fading = setTimeout(() => {
      this.read = this.newest;
      this.session.signals.tell("notices"); // the stage has more room now
    }, READ_MS);
  };
}
