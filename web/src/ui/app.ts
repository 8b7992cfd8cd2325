import { css, html, LitElement } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { debugPage } from "./debug";
import { handleKey } from "../app/keys";
import type { StagePort } from "../app/ports";
import type { Session } from "../app/session";
import { focused, pressOf } from "./keys";
import { base } from "./styles";
import type { Intro } from "./elements/intro";
import "./elements/intro";
import "./elements/inspector";
import "./elements/notices";
import "./elements/rail";
import "./elements/status";
import "./elements/timeline";
import "./elements/top-bar";
import "./elements/transport";
import "./elements/view";

const PANELS = {
  model: (session: Session) => html`<rigless-panel-model .session=${session}></rigless-panel-model>`,
  motion: (session: Session) => html`<rigless-panel-motion .session=${session}></rigless-panel-motion>`,
  points: (session: Session) => html`<rigless-panel-points .session=${session}></rigless-panel-points>`,
  poses: (session: Session) => html`<rigless-panel-poses .session=${session}></rigless-panel-poses>`,
} as const;

/** Notices may take this part of the stage's height from the figures; beyond it they cover. */
const MOST_WORDS = 0.3;

/** The page: where each part stands, what is dropped on it, and its keys. */
@customElement("rigless-app")
export class App extends LitElement {
  session!: Session;
  /** Builds the stage in an element of the page. */
  buildStage!: (host: HTMLElement) => StagePort;
  @state() private dropping = false;
  @state() private phone = false;
  /** Phone only: the sheet shows its content. */
  @state() private sheetOpen = true;
  @query(".view3d") private host!: HTMLDivElement;
  @query("rigless-intro") private intro!: Intro;
  private readonly narrow = matchMedia("(max-width: 719px)");
  private readonly resized = new ResizeObserver(() => this.measure());
  private framing = 0;
  private clicked: Element | null = null;
  private spaceIsOurs = false;

  static override styles = [
    base,
    css`
      :host { display: grid; height: 100%; overflow: hidden; grid-template: 48px minmax(0, 1fr) auto / auto minmax(0, 1fr) auto;
        color: var(--ink); }
      rigless-top-bar { grid-area: 1 / 1 / 2 / -1; z-index: 4; position: relative; }
      main { grid-area: 2 / 1 / 3 / -1; position: relative; background: var(--stage); overflow: hidden; min-height: 0; }
      .view3d { position: absolute; inset: 0; }
      .left { grid-area: 2 / 1; align-self: stretch; display: flex; align-items: flex-start; pointer-events: none; z-index: 2;
        min-height: 0; padding-bottom: 52px; }
      .left > * { pointer-events: auto; }
      .panel { margin: var(--s2) 0; max-height: calc(100% - 16px); display: flex; min-height: 0; }
      .panel > * { display: flex; min-height: 0; }
      rigless-inspector { grid-area: 2 / 3; align-self: start; z-index: 2; max-height: calc(100% - 32px); overflow-y: auto; }
      .middle { grid-area: 2 / 2; position: relative; z-index: 2; pointer-events: none; display: grid; grid-template-rows: auto 1fr auto;
        min-width: 0; min-height: 0; }
      rigless-notices { justify-self: center; margin: var(--s2) var(--s1) 0; }
      rigless-intro { position: absolute; inset: 0; }
      .low { grid-row: 3; display: grid; justify-items: end; align-content: end; }
      .low > * { pointer-events: auto; }
      rigless-prompt { justify-self: stretch; margin-bottom: 0; }
      rigless-view { margin-right: 0; }
      rigless-status { grid-area: 2 / 1 / 3 / 3; align-self: end; justify-self: start; z-index: 2; }
      .dock { grid-area: 3 / 1 / 4 / -1; background: var(--desk); border-top: 1px solid var(--line); padding: 0 var(--s2) var(--s1);
        z-index: 3; }
      @media (max-width: 719px) {
        :host { grid-template: 56px minmax(0, 1fr) auto auto auto / minmax(0, 1fr); }
        rigless-top-bar { grid-area: 1 / 1; }
        main, .middle { grid-area: 2 / 1; }
        rigless-notices { justify-self: stretch; margin: 8px 8px 0; }
        rigless-view { display: none; }
        rigless-status { grid-area: 2 / 1; }
        .dock { grid-area: 3 / 1; padding: 0 12px 8px; }
        .sheet { grid-area: 4 / 1; background: var(--paper); border-top: 1px solid var(--line); max-height: 38vh; overflow-y: auto;
          z-index: 3; }
        .handle { display: block; width: 100%; height: 20px; border: 0; background: none; padding: 0; cursor: pointer; position: relative; }
        .handle::before { content: ""; position: absolute; inset: -12px 0; }
        .handle::after { content: ""; display: block; width: 40px; height: 4px; border-radius: 2px; background: var(--edge);
          margin: 0 auto; }
        .handle:focus-visible { position: relative; }
        rigless-rail { grid-area: 5 / 1; z-index: 3; }
        .panel { margin: 0; max-height: none; }
        .panel > * { display: block; flex: 1; min-width: 0; }
        rigless-inspector { max-height: none; overflow: visible; }
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.phone = this.narrow.matches;
    this.narrow.addEventListener("change", this.narrowed);
    addEventListener("click", this.pointed);
    addEventListener("keydown", this.keyed);
    addEventListener("keyup", this.keyUp);
    for (const name of ["dragenter", "dragover", "dragleave", "drop"] as const) addEventListener(name, this.dragged);
    addEventListener("beforeunload", this.leaving);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.narrow.removeEventListener("change", this.narrowed);
    removeEventListener("click", this.pointed);
    removeEventListener("keydown", this.keyed);
    removeEventListener("keyup", this.keyUp);
    for (const name of ["dragenter", "dragover", "dragleave", "drop"] as const) removeEventListener(name, this.dragged);
    removeEventListener("beforeunload", this.leaving);
    this.resized.disconnect();
    this.session.close();
  }

  protected override firstUpdated(): void {
    const { session } = this;
    void session.start(() => this.buildStage(this.host));
    globalThis.rigless = debugPage(session);
    for (const topic of ["panel", "help", "jobs", "pins", "coverage", "clips", "export"] as const)
      session.signals.on(topic, () => this.loadLate());
    for (const topic of ["panel", "notices", "intro", "jobs", "pairing", "pins", "coverage", "stage"] as const)
      session.signals.on(topic, () => this.reframe());
    session.signals.on("panel", () => {
      this.sheetOpen = true;
      this.requestUpdate();
    });
    this.resized.observe(this);
    this.reframe();
  }

  protected override updated(): void {
    this.reframe();
  }

  protected override render() {
    const { session } = this;
    const { panel: name } = session.selection;
    const panel = name ? html`<div class="panel">${PANELS[name](session)}</div>` : "";
    const inspector = html`<rigless-inspector role="complementary" aria-label="Inspector" .session=${session}></rigless-inspector>`;
    const rail = html`<rigless-rail .session=${session}></rigless-rail>`;
    return html`
      <rigless-top-bar role="banner" .session=${session}></rigless-top-bar>
      <main aria-label="Stage"><div class="view3d"></div></main>
      <div class="middle">
        <rigless-intro ?hidden=${this.dropping} .session=${session}></rigless-intro>
        <rigless-notices .session=${session}></rigless-notices>
        <div class="low">
          <rigless-jobs .session=${session}></rigless-jobs>
          <rigless-prompt .session=${session}></rigless-prompt>
          <rigless-view .session=${session}></rigless-view>
        </div>
      </div>
      <rigless-status .session=${session}></rigless-status>
      <section class="dock" aria-label="Timeline">
        <rigless-transport .session=${session}></rigless-transport>
        <rigless-timeline .session=${session}></rigless-timeline>
      </section>
      ${
        this.phone
          ? html`<div class="sheet">
            <button class="handle" aria-label=${this.sheetOpen ? "Fold the sheet" : "Unfold the sheet"} aria-expanded=${this.sheetOpen}
              @click=${() => (this.sheetOpen = !this.sheetOpen)}></button>
            ${this.sheetOpen ? (name ? panel : inspector) : ""}</div>${rail}`
          : html`<div class="left">${rail}${panel}</div>${inspector}`
      }
      ${this.dropping ? html`<rigless-drop></rigless-drop>` : ""}
      <rigless-help .session=${session}></rigless-help>
      <rigless-clips .session=${session}></rigless-clips>
      <rigless-export .session=${session}></rigless-export>
    `;
  }

  private readonly narrowed = (): void => {
    this.phone = this.narrow.matches;
  };

  /** A button that was clicked has had its turn: the next Space plays. */
  private readonly pointed = (event: MouseEvent): void => {
    if (event.detail > 0) this.clicked = focused();
  };

  private readonly keyed = (event: KeyboardEvent): void => {
    if (event.key === "Tab") this.clicked = null;
    if (event.defaultPrevented || !handleKey(this.session.actions, pressOf(event, this.clicked))) return;
    event.preventDefault();
    if (event.key === " ") this.spaceIsOurs = true;
  };

  /** Some browsers press a button when Space comes up again. */
  private readonly keyUp = (event: KeyboardEvent): void => {
    if (event.key !== " " || !this.spaceIsOurs) return;
    event.preventDefault();
    this.spaceIsOurs = false;
  };

  private readonly leaving = (event: BeforeUnloadEvent): void => {
    void this.session.keeping?.flush();
    if (this.session.history.unsaved) event.preventDefault();
  };

  private readonly dragged = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    if (event.type === "drop") {
      this.dropping = false;
      const files = [...event.dataTransfer.files];
      void this.session.opening.files(files);
    } else if (event.type === "dragleave") {
      if (event.relatedTarget === null) this.dropping = false;
    } else {
      this.loadLate();
      this.dropping = true;
    }
  };

  /** Elements in the page come alive when their code is there. */
  private loadLate(): void {
    void import("./elements/late").then(() => this.reframe());
  }

  /** Measures once what has been drawn by then. */
  private reframe(): void {
    cancelAnimationFrame(this.framing);
    this.framing = requestAnimationFrame(() => this.measure());
  }

  /** Tells the viewport which part of the stage the cards leave free. */
  private measure(): void {
    const stage = this.host.getBoundingClientRect();
    const box = (element: Element | null | undefined): DOMRect | null => {
      const rect = element?.getBoundingClientRect();
      return rect && rect.width > 0 && rect.height > 0 ? rect : null;
    };
    const card = (selector: string): DOMRect | null => box(this.renderRoot.querySelector(selector));
    const intro = this.intro.boxes;
    const desk = !this.phone;
    const left = desk ? Math.max(card("rigless-rail")?.right ?? 0, card(".panel > *")?.right ?? 0) : stage.left;
    const job = card("rigless-jobs");
    const right = desk ? Math.min(job?.left ?? stage.right, card("rigless-inspector")?.left ?? stage.right) : stage.right;
    const words = Math.max(stage.top, card("rigless-notices:not([quiet])")?.bottom ?? 0, box(intro.line)?.bottom ?? 0);
    const top = Math.min(words, stage.top + MOST_WORDS * stage.height);
    const lows = [card("rigless-status"), card("rigless-prompt"), desk ? null : job, box(intro.chips)].map(
      (rect) => rect?.top ?? stage.bottom,
    );
    this.session.presenter.setInsets({
      left: Math.max(0, left - stage.left),
      top: top - stage.top,
      right: Math.max(0, stage.right - right),
      bottom: Math.max(0, stage.bottom - Math.min(...lows)),
    });
  }
}
