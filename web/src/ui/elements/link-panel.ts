import { css, html } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { Linking } from "../../app/linking";
import { figure } from "../../util/words";
import { SessionElement } from "../element";
import { base } from "../styles";
import { choiceStyle } from "./choice-row";

/** The project as an address, or the word why there is none. */
@customElement("rigless-link")
export class LinkPanel extends SessionElement {
  protected readonly topics = ["export"] as const;
  @state() private copied = false;
  @query("input") private field!: HTMLInputElement;

  static override styles = [
    base,
    choiceStyle,
    css`
      :host { display: grid; grid-template-columns: minmax(0, 1fr); gap: 12px; }
      p { font: var(--t-body); }
      input { min-height: var(--hit); width: 100%; padding: 0 8px; border: 0; border-radius: var(--r-m); background: var(--paper);
        color: var(--ink); font: var(--t-body); --frame: inset 0 0 0 var(--stroke) var(--edge); box-shadow: var(--frame); }
      @media (pointer: coarse), (max-width: 719px) { input { font-size: 16px; } }
    `,
  ];

  private get link(): Linking | null {
    return this.session.saving.exporting?.link ?? null;
  }

  protected override firstUpdated(): void {
    void this.link?.make(location.href.replace(/#.*/, ""));
  }

  protected override render() {
    const { state: made } = this.link ?? { state: { kind: "making" } as const };
    if (made.kind === "none")
      return html`<p>${made.why} The project file holds all of it.</p>
        <div class="acts"><button class="btn primary" @click=${() => this.session.saving.save()}>Save the project file</button></div>`;
    const address = made.kind === "made" ? made.address : "";
    return html`
      <p>Whoever opens it sees this dance and can make it theirs. The link holds it all: nothing is stored anywhere.</p>
      <input aria-label="The link" readonly .value=${address} @focus=${() => this.field.select()} />
      <p class="sub" aria-live="polite">${
        this.copied ? "Copied." : address ? `${figure(address.length)} characters` : "Comparing it with the character"
      }</p>
      <div class="acts"><button class="btn primary" ?disabled=${!address} @click=${() => this.copy(address)}>Copy the link</button></div>`;
  }

  private async copy(address: string): Promise<void> {
    this.field.select();
    await navigator.clipboard.writeText(address).then(
      () => (this.copied = true),
      () => this.field.focus(), // not allowed: it stands there selected
    );
  }
}
