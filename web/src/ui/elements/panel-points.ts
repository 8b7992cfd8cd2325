import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { Point } from "../../document/types";
import type { JointName } from "../../skeleton/joint-names";
import { describeJoints } from "../../skeleton/pair-joints";
import { pointJoints } from "../../sync/pairing";
import { SessionElement } from "../element";
import { badge } from "../point-colors";
import { base, panel } from "../styles";

/** The keyboard twin of the dots: every point is a button here. */
@customElement("rigless-panel-points")
export class PointsPanel extends SessionElement {
  protected readonly topics = ["document", "selection", "solve", "pairing"] as const;
  static override styles = [base, panel];

  protected override render() {
    const { session } = this;
    const { document, motion } = session;
    const { points } = document;
    const joints = motion ? describeJoints(motion.joints) : [];
    const drivers = motion ? pointJoints(document, motion) : [];
    return html`<section class="panel" aria-label="Points">
      <h2>Points <button class="btn line" aria-pressed=${session.pairing.adding} @click=${() => session.pairing.toggleAdd()}>${session.pairing.adding ? "Done" : "Add"}</button></h2>
      ${points.length === 0 ? html`<p class="note">Click a place on the model, then the joint that moves it.</p>` : nothing}
      <ul>${points.map((point, k) => this.renderPoint(point, k + 1, joints, drivers[k] ?? -1))}</ul>
      ${this.renderPlaces()}
      ${points.length > 0 ? html`<p class="keys"><span><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd> move 1 cm</span><span><kbd>Shift</kbd> finer</span></p>` : nothing}
    </section>`;
  }

  private renderPlaces() {
    const { guesses } = this.session;
    if (guesses.places.length === 0) return nothing;
    return html`<p class="note">Other good places:</p><div class="row-acts">${guesses.places.map(
      ({ id, name }) => html`<button class="btn pencil" @click=${() => guesses.take(guesses.offerId(id))}>+ ${name}</button>`,
    )}</div>`;
  }

  /** `driver`: the joint that moves it, -1 where the whole pose does. */
  private renderPoint(point: Point, number: number, joints: readonly JointName[], driver: number) {
    const { session } = this;
    const unpaired = point.joint === null ? "not paired" : "not in this motion";
    const on = session.selected === point.id;
    return html`<li>
      <button class="item" aria-pressed=${on} @click=${() => session.select(on ? null : point.id)} @keydown=${(event: KeyboardEvent) => session.dragging.key(point.id, event)}>
        ${badge(number, { weak: point.joint === null })}<span>${point.name}</span><small>${joints[driver]?.label ?? unpaired}</small></button>
      ${on ? this.renderDetails(point, joints, driver) : nothing}
    </li>`;
  }

  private renderDetails(point: Point, joints: readonly JointName[], driver: number) {
    const { session } = this;
    return html`<div class="more">
      <label class="pair">Name <input .value=${point.name} autocomplete="off" spellcheck="false" @change=${(event: Event) =>
        session.points.rename(point.id, (event.target as HTMLInputElement).value)} /></label>
      <label class="pair">Moved by <select @change=${(event: Event) =>
        session.points.pair(point.id, (event.target as HTMLSelectElement).value || null)}>
        <option value="" ?selected=${driver < 0}>the whole pose</option>
        ${joints.map(({ label }, j) => html`<option value=${session.motion?.joints[j]?.name} ?selected=${j === driver}>${label}</option>`)}
      </select></label>
      <label class="pair">Mirrors <select @change=${(event: Event) =>
        session.points.pairMirror(point.id, (event.target as HTMLSelectElement).value || null)}>
        <option value="" ?selected=${point.mirror === undefined}>nothing</option>
        ${session.document.points.map((other) => html`<option value=${other.id} ?selected=${other.id === point.mirror}>${other === point ? "itself (in the middle)" : other.name}</option>`)}
      </select></label>
      <div class="row-acts"><button class="btn" @click=${() => session.points.remove(point.id)}>Delete</button></div>
    </div>`;
  }
}
