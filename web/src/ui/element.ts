import { LitElement, type PropertyValues } from "lit";
import { property } from "lit/decorators.js";
import type { Session } from "../app/session";
import type { Topics } from "../app/signals";

/** A part of the page: draws what the session says, again whenever one of its topics changes. */
export abstract class SessionElement extends LitElement {
  @property({ attribute: false }) session!: Session;
  protected abstract readonly topics: readonly (keyof Topics)[];
  private stops: (() => void)[] = [];

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.listen();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.unlisten();
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (changed.has("session")) this.listen();
  }

  private listen(): void {
    this.unlisten();
    if (!this.session) return;
    this.stops = this.topics.map((topic) => this.session.signals.on(topic, () => this.requestUpdate()));
  }

  private unlisten(): void {
    for (const stop of this.stops) stop();
    this.stops = [];
  }
}
