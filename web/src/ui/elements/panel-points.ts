import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { DEFAULT_FOLLOW, FOLLOWS, type Driver, type FollowThrough, type Point } from "../../app/points";
import { DEFAULT_WHOLE_POSE, MOST_REACH, MOST_TURN, PointDetails, type StiffPart, TURNS } from "../../app/point-details";
import { SessionElement } from "../element";
import { badge } from "../point-colors";
import { base, panel } from "../styles";
import { slider, sliderStyle } from "./slider";

/** The keyboard twin of the dots: every point is a button here. */
@customElement("rigless-panel-points")
export class PointsPanel extends SessionElement {
  protected readonly topics = ["document", "selection", "solve", "pairing", "suggestions", "frame"] as const;
  private details: PointDetails | null = null;
  static override styles = [base, panel, sliderStyle];

  protected override render() {
    const { session } = this;
    const { pairing } = session;
    const { points } = session.document;
    const { drivers, paired } = session.points;
    return html`<section class="panel" aria-label="Points">
      <h2>Points <button class="btn line" aria-pressed=${pairing.adding} @click=${() => pairing.toggleAdd()}
        >${pairing.adding ? "Done" : "Add"}</button></h2>
      ${points.length === 0 ? html`<p class="note">Click a place on the model, then the joint that moves it.</p>` : nothing}
      <ul>${points.map((point, k) => this.renderPoint(point, k + 1, drivers, paired[k]))}</ul>
      ${this.renderSuggested()}
      ${points.length > 0 ? this.renderStiff() : nothing}
      ${points.length > 0 ? KEYS : nothing}
    </section>`;
  }

  private renderSuggested() {
    const { guesses } = this.session;
    if (guesses.suggested.length === 0) return nothing;
    return html`<p class="note">Other good places:</p><div class="row-acts">${guesses.suggested.map(
      (point) => html`<button class="btn pencil" @click=${() => guesses.take(guesses.markOf(point))}>+ ${point.name}</button>`,
    )}</div>`;
  }

  /** `driver`: which of the drivers moves it, -1 where the whole pose does. */
  private renderPoint(point: Point, number: number, drivers: readonly Driver[], driver: number) {
    const { session } = this;
    const on = session.selection.point === point.id;
    return html`<li>
      <button class="item" aria-pressed=${on} @click=${() => session.selection.select(on ? null : point.id)}
        @keydown=${(event: KeyboardEvent) => this.nudge(event, point)}>
        ${badge(number, { weak: point.joint === null })}<span>${point.name}</span
        ><small>${drivers[driver]?.label ?? (point.joint === null ? "not paired" : "not in this motion")}</small></button>
      ${on ? this.renderDetails(point, drivers, driver) : nothing}
    </li>`;
  }

  private renderDetails(point: Point, drivers: readonly Driver[], driver: number) {
    const { session } = this;
    const { points } = session.document;
    return html`<div class="more">
      <label class="pair">Name <input .value=${point.name} autocomplete="off" spellcheck="false"
        @change=${(event: Event) => this.rename(event, point)} /></label>
      <label class="pair">Moved by <select @change=${(event: Event) =>
        session.points.pair(point.id, (event.target as HTMLSelectElement).value || null)}>
        <option value="" ?selected=${driver < 0}>the whole pose</option>
        ${drivers.map(({ name, label }, j) => html`<option value=${name} ?selected=${j === driver}>${label}</option>`)}
      </select></label>
      ${point.joint === null ? this.renderFollow(point) : this.renderWhole(point)}
      <label class="pair">Mirrors <select @change=${(event: Event) =>
        this.said.pairMirror(point, (event.target as HTMLSelectElement).value || null)}>
        <option value="" ?selected=${point.mirror === undefined}>nothing</option>
        ${points.map(
          (other) => html`<option value=${other.id} ?selected=${other.id === point.mirror}
            >${other === point ? "itself (in the middle)" : other.name}</option>`,
        )}
      </select></label>
      ${this.renderTurns(point)}
      <div class="row-acts"><button class="btn" ?disabled=${this.said.around(point) !== undefined}
        @click=${() => this.said.keepStiff(point.position)}>Keep stiff</button
      ><button class="btn" @click=${() => session.points.remove(point.id)}>Delete</button></div>
    </div>`;
  }

  private get said(): PointDetails {
    return (this.details ??= new PointDetails(this.session));
  }

  private renderWhole(point: Point) {
    const { wholePose = DEFAULT_WHOLE_POSE } = point;
    return slider("Listens to", wholePose, { max: 2, rest: DEFAULT_WHOLE_POSE, words: wholeWords(wholePose) }, (value, held) =>
      this.said.setWhole(point, value, held),
    );
  }

  /** A pose may turn a point. */
  private renderTurns(point: Point) {
    const turn = this.said.turnOf(point);
    if (!turn) return nothing;
    const range = { min: -MOST_TURN, max: MOST_TURN, step: 1 };
    return html`<p class="note">At frame ${this.session.player.frame}, as a pose:</p>${TURNS.map((label, axis) =>
      slider(label, turn[axis], { ...range, words: `${Math.round(turn[axis])}°` }, (value, held) =>
        this.said.setTurn(point, axis, value, held),
      ),
    )}`;
  }

  private renderStiff() {
    const { pairing } = this.session;
    return html`<div class="more"><div class="row-acts"><button class="btn" aria-pressed=${pairing.asksPlace}
      @click=${() => (pairing.asksPlace ? pairing.stop() : this.said.askForStiff())}>Keep a part stiff</button></div>
      ${this.said.stiff.map((part, n) => this.renderPart(part, n + 1))}</div>`;
  }

  private renderPart(part: StiffPart, number: number) {
    const { radius = null } = part;
    const words = radius === null ? "the whole piece" : `${Math.round(100 * radius)} % of its height`;
    return html`${slider(`Stiff ${number}`, radius ?? MOST_REACH, { min: 0.02, max: MOST_REACH, rest: 0.15, words }, (value, held) =>
      this.said.setReach(part, value === MOST_REACH ? null : value, held),
    )}<div class="row-acts"><button class="btn" aria-label="Soften stiff part ${number}" @click=${() => this.said.soften(part)}
      >Soften</button></div>`;
  }

  /** How a part that no joint moves hangs on the body. */
  private renderFollow({ id, follow = DEFAULT_FOLLOW }: Point) {
    return html`<label class="pair">Hangs on <select @change=${(event: Event) =>
      this.session.points.set(id, { follow: (event.target as HTMLSelectElement).value as FollowThrough })}>
      ${FOLLOWS.map((one) => html`<option value=${one} ?selected=${one === follow}>${one}</option>`)}
    </select></label>`;
  }

  private nudge(event: KeyboardEvent, { id }: Point): void {
    if (this.session.dragging.nudge(id, event.key, event.shiftKey)) event.preventDefault();
  }

  private rename(event: Event, { id, name }: Point): void {
    const input = event.target as HTMLInputElement;
    if (!this.session.points.set(id, { name: input.value })) input.value = name;
  }
}

/** What a point's weight of the whole pose comes to. */
function wholeWords(weight: number): string {
  if (weight < 0.25) return "its joint alone";
  if (weight < 0.75) return "its joint, and the body";
  return weight < 1.25 ? "both alike" : "the body more";
}

const KEYS = html`<p class="keys"><span><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd> move 1 cm</span
  ><span><kbd>Shift</kbd> finer</span></p>`;
