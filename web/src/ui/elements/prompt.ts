import { css, html } from "lit";
import type { TemplateResult } from "lit";
import { customElement } from "lit/decorators.js";
import { movingOn, PIN_KINDS, velocityOf, withSpeed } from "../../app/pin-kinds";
import type { Pin } from "../../app/pins";
import { actionButton, caps } from "../action-button";
import { SessionElement } from "../element";
import { base, panel } from "../styles";
import { type Option, select } from "./select";

/** What is asked for now: a place, a joint, a pose; or what a pin says. Pencil edge, because it asks. */
@customElement("rigless-prompt")
export class Prompt extends SessionElement {
  protected readonly topics = ["pairing", "document", "panel", "pins", "coverage"] as const;

  static override styles = [
    base,
    panel,
    css`
      :host { display: block; margin: var(--s2); }
      .prompt { background: var(--paper); border-radius: var(--r-l); box-shadow: inset 0 0 0 1.5px var(--pencil), var(--lift-1);
        padding: 12px 12px 12px 16px; display: flex; align-items: center; gap: var(--s2); }
      h3 { font: var(--t-strong); }
      p { font: var(--t-small); color: var(--ink-2); }
      .fields { display: flex; flex-wrap: wrap; gap: 8px; font: var(--t-small); color: var(--ink-2); }
      .fields input { width: 72px; min-height: var(--hit); padding: 0 8px; border: 0; border-radius: var(--r-m); background: var(--paper);
        color: var(--ink); font: var(--t-body); box-shadow: inset 0 0 0 var(--stroke) var(--edge); }
      .acts { display: flex; gap: var(--s-half); flex: none; }
      @media (max-width: 719px) { :host { margin: 8px; } }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { escape } = session.actions;
    if (session.coverage.asking !== null) return this.renderAsked();
    if (session.pins.chosenPin) return this.renderPin(session.pins.chosenPin);
    if (session.pins.armed)
      return card(
        "Pins",
        html`<h3>Drag a dot to where it shall be at this frame.</h3><p>A pin holds for its frame and teaches nothing else.</p>`,
        html`<button class="btn line" @click=${() => session.pins.arm(false)}>Cancel ${caps(escape)}</button>`,
      );
    return this.renderPairing();
  }

  private renderAsked() {
    const { coverage, poses, actions } = this.session;
    const free = poses.teachBothSides ? " Its mirror comes free." : "";
    return card(
      "Asked for",
      html`<h3>Show me this one.</h3><p>It is the farthest from your poses: drag the dots until it means the same.${free}</p>`,
      html`<button class="btn" @click=${() => coverage.skip()}>Skip ${caps(actions.escape)}</button>
        ${actionButton(actions.answer, { class: "btn primary", after: html` ${caps(actions.answer)}` })}`,
    );
  }

  private renderPin(pin: Pin) {
    const { session } = this;
    const { pins, document, actions } = session;
    const name = document.points.find(({ id }) => id === pin.point)?.name ?? "The point";
    const { is, means } = PIN_KINDS[pin.kind];
    const others = (Object.keys(PIN_KINDS) as Pin["kind"][]).filter((kind) => kind !== pin.kind);
    return card(
      "Pin",
      html`<h3>${name} ${is} at frame ${pin.frame}.</h3><p>${means}</p>${this.renderFields(pin)}`,
      html`${others.map(
        (kind) => html`<button class="btn" ?disabled=${!pins.canBe(pin, kind)} @click=${() => this.turnInto(pin, kind)}
          >${PIN_KINDS[kind].make}</button>`,
      )}
        <button class="btn" @click=${() => pins.remove(pin.id)}>Delete</button>
        <button class="btn line" @click=${() => pins.choose(null)}>Done ${caps(actions.escape)}</button>`,
    );
  }

  private turnInto(pin: Pin, kind: Pin["kind"]): void {
    const { pins, context } = this.session;
    if (kind === "moves") pins.change(movingOn(context, pin));
    else pins.setKind(pin, kind);
  }

  /** Which point it is level with; how fast it moves on. */
  private renderFields(pin: Pin) {
    const { pins, document, context } = this.session;
    if (pin.kind === "level")
      return select(
        "As high as",
        pin.other ?? "",
        document.points.filter(({ id }) => id !== pin.point).map(({ id, name }): Option => [id, name]),
        (other) => pins.change({ ...pin, other }),
      );
    const velocity = pin.kind === "moves" ? velocityOf(context, pin) : null;
    if (!velocity) return "";
    const changed = (axis: number) => (event: Event) =>
      pins.change(withSpeed(context, pin, axis, Number((event.target as HTMLInputElement).value) / 100));
    return html`<span class="fields">${["Across", "Up", "On"].map(
      (label, axis) => html`<label>${label} <input type="number" step="5" .value=${String(Math.round(100 * velocity[axis]))}
        @change=${changed(axis)} /></label>`,
    )}</span>`;
  }

  private renderPairing() {
    const { session } = this;
    const { pairing, selection, actions } = session;
    const { points } = session.document;
    const waiting = points.find((point) => point.id === pairing.waiting);
    if (selection.panel !== "points" || !pairing.asks) return "";
    if (pairing.asksPlace)
      return card(
        "Stiff",
        html`<h3>Click the part that shall keep its shape.</h3><p>A head, a hat, a shell: the rest bends for it.</p>`,
        html`<button class="btn line" @click=${() => pairing.stop()}>Cancel ${caps(actions.escape)}</button>`,
      );
    const paired = points.filter((point) => point.joint !== null).length;
    const words = waiting
      ? html`<h3>Click the joint that moves ${waiting.name}.</h3><p>${
          paired
        } of ${points.length} paired. Any joint of the dancer will do.</p>`
      : html`<h3>Click a place on the model${points.length === 0 ? ", then the joint that moves it" : ""}.</h3><p>${
          points.length === 0 ? "It dances as soon as one place has its joint." : `${paired} of ${points.length} paired.`
        }</p>`;
    return card(
      "Points",
      words,
      html`${waiting ? html`<button class="btn" @click=${() => pairing.waitFor(null)}>Skip</button>` : ""}
      <button class="btn line" @click=${() => pairing.stop()}>Done ${caps(actions.escape)}</button>`,
    );
  }
}

function card(label: string, words: TemplateResult, acts: TemplateResult): TemplateResult {
  return html`<section class="prompt" aria-label=${label}><div class="grow">${words}</div><div class="acts">${acts}</div></section>`;
}
