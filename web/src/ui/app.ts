import { html, LitElement } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { debugPage } from "./debug";
import { handleKey } from "../app/keys";
import type { StagePort } from "../app/ports";
import type { Session } from "../app/session";
import { appStyle } from "./app-style";
import { focused, pressOf } from "./keys";
import { base } from "./styles";
import type { Assist } from "./assist";
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
  /** Phone only: the sheet shows its content. On a short one it takes the room of the stage, so not before it is asked for. */
  @state() private sheetOpen = innerHeight >= 700;
  @query(".view3d") private host!: HTMLDivElement;
  @query("rigless-intro") private intro!: Intro;
  private readonly narrow = matchMedia("(max-width: 719px)");
  private readonly resized = new ResizeObserver(() => this.measure());
  private framing = 0;
  private clicked: Element | null = null;
  private spaceIsOurs = false;
  private helped: Promise<Assist> | undefined;

  static override styles = [base, appStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    this.phone = this.narrow.matches;
    this.narrow.addEventListener("change", this.narrowed);
    addEventListener("click", this.pointed);
    addEventListener("keydown", this.keyed);
    addEventListener("keyup", this.keyUp);
    addEventListener("keydown", this.assist, { once: true });
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
    void this.helped?.then((assist) => assist.close());
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
    session.signals.on("document", (before) => {
      if (session.history.touched && !this.helped) void this.assist().then((assist) => assist.speak(before));
    });
    if (matchMedia("(any-pointer: coarse)").matches)
      void import("./touch").then(({ listenToFingers }) => listenToFingers(this.host, session));
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
      ${this.phone ? "" : html`<div class="left">${rail}${panel}</div>`}
      <main aria-label="Stage"><div class="view3d"></div></main>
      <div class="middle">
        <rigless-intro ?hidden=${this.dropping} .session=${session}></rigless-intro>
        <rigless-notices .session=${session}></rigless-notices>
        <div class="low">
          <rigless-jobs .session=${session}></rigless-jobs>
          <rigless-prompt .session=${session}></rigless-prompt>
          <div class="foot"><rigless-status .session=${session}></rigless-status
            ><rigless-view .session=${session}></rigless-view></div>
        </div>
      </div>
      ${this.phone ? "" : inspector}
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
          : ""
      }
      ${this.dropping ? html`<rigless-drop></rigless-drop>` : ""}
      <rigless-help .session=${session}></rigless-help>
      <rigless-clips .session=${session}></rigless-clips>
      <rigless-export .session=${session}></rigless-export>
    `;
  }

  private readonly assist = (): Promise<Assist> =>
    (this.helped ??= import("./assist").then(({ Assist }) => new Assist(this.session, this.renderRoot)));

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
