import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SessionElement } from "../element";
import { base } from "../styles";

/** What to click next while points are being made. Pencil edge, because it asks. */
@customElement("rigless-prompt")
export class Prompt extends SessionElement {
  protected readonly topics = ["pairing", "document", "verb"] as const;

  static override styles = [
    base,
    css`
      :host { display: block; margin: var(--s2); }
      .prompt { background: var(--paper); border-radius: var(--r-l); box-shadow: inset 0 0 0 1.5px var(--pencil), var(--lift-1); padding: 12px 12px 12px 16px; display: flex; align-items: center; gap: var(--s2); }
      h3 { font: var(--t-strong); }
      p { font: var(--t-small); color: var(--ink-2); }
      .acts { display: flex; gap: var(--s-half); flex: none; }
      @media (max-width: 719px) { :host { margin: 8px; } }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { pairing } = session;
    const { points } = session.document;
    const waiting = points.find((point) => point.id === pairing.waiting);
    if (session.verb !== "points" || (!waiting && !pairing.adding)) return "";
    const paired = points.filter((point) => point.joint !== null).length;
    return html`<section class="prompt" aria-label="Points">
      <div class="grow">
        ${waiting
          ? html`<h3>Click the joint that moves ${waiting.name}.</h3><p>${paired} of ${points.length} paired. Any joint of the dancer will do.</p>`
          : html`<h3>Click a place on the model${points.length === 0 ? ", then the joint that moves it" : ""}.</h3><p>${
              points.length === 0 ? "It dances as soon as one place has its joint." : `${paired} of ${points.length} paired.`}</p>`}
      </div>
      <div class="acts">
        ${waiting ? html`<button class="btn" @click=${() => pairing.setWaiting(null)}>Skip</button>` : ""}
        <button class="btn line" @click=${() => pairing.stop()}>Done <kbd>Esc</kbd></button>
      </div>
    </section>`;
  }
}
