import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { ContactRow } from "../../app/contacts";
import type { Pin } from "../../app/pins";
import { movedRun } from "../../app/runs";
import type { Grip, Run } from "../../app/runs";
import { FLIGHTS } from "../../app/selection";
import { SessionElement } from "../element";
import { icon } from "../icons";
import { badge, pointStyle } from "../point-colors";
import { base } from "../styles";

const GRIPS = ["begin", "end"] as const;
/** What the flag of a kind of pin says, and shows: the path of a stroke. */
const FLAGS: Readonly<Record<Pin["kind"], readonly [says: string, sign: string]>> = {
  place: ["held here", "M9 7.5h.01"],
  still: ["stands still", "M7.5 7.5h4"],
  level: ["level", "M7.5 6.5h4m-4 2.5h4"],
  moves: ["moves on", "M7.5 7.5h4l-2-2"],
};

/** A bar in the hand, or one that is being drawn. */
interface Held {
  row: string;
  at: number;
  grip: Grip;
  from: number;
  runs: readonly Run[];
  gesture: symbol;
}

/** Who stands on the ground when, as bars that can be moved, drawn and deleted; and the pins as flags. */
@customElement("rigless-contact-rows")
export class ContactRows extends SessionElement {
  protected readonly topics = ["document", "solve", "selection", "pins", "frame"] as const;
  private held: Held | null = null;

  static override styles = [
    base,
    css`
      :host { display: block; --row: 24px; --shown: 3; }
      .rows { max-height: calc(var(--shown) * var(--row) + 1px); overflow-y: auto; scrollbar-width: thin; }
      .pair { display: grid; grid-template-columns: var(--label) minmax(0, 1fr); height: var(--row); }
      .name { display: flex; align-items: center; min-width: 0; border-top: 1px solid transparent; }
      .name button { background: none; border: 0; padding: 0; color: var(--ink-2); font: var(--t-small); text-align: left;
        cursor: pointer; border-radius: var(--r-s); min-width: 0; height: 100%; }
      .who { display: flex; align-items: center; gap: var(--s1); flex: 1; }
      .who span:last-child { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
      .name [aria-pressed="true"] { color: var(--ink); font-weight: 600; }
      .name .reset { flex: none; width: 24px; display: grid; place-items: center; margin-right: 4px; }
      .reset .ico { width: 14px; height: 14px; }
      .lane { position: relative; margin: 0 var(--end) 0 var(--start); border-top: 1px solid var(--line); touch-action: pan-y; }
      .lane.sel { background: var(--well); cursor: crosshair; touch-action: none; }
      .bar { position: absolute; top: calc(var(--row) / 2 - 5px); height: 8px; left: var(--a); width: max(4px, var(--w)); border: 0;
        padding: 0;
        border-radius: 4px; background: var(--c); box-shadow: inset 0 0 0 1px color-mix(in oklab, var(--c), var(--ink) 40%);
        cursor: pointer; touch-action: none; }
      .bar.air { --c: var(--pencil-soft, var(--line));
        background: repeating-linear-gradient(135deg, var(--pencil) 0 1.5px, transparent 1.5px 5px);
        box-shadow: inset 0 0 0 1.25px var(--pencil); }
      .sel .bar { top: calc(var(--row) / 2 - 7px); height: 12px; border-radius: 6px; cursor: grab; }
      .grip { position: absolute; top: -6px; bottom: -6px; width: 12px; cursor: ew-resize; }
      .grip::after { content: ""; position: absolute; top: 4px; bottom: 4px; left: 3.5px; width: 5px; border-radius: 2px;
        background: var(--ink); }
      .grip.begin { left: -6px; }
      .grip.end { right: -6px; }
      .flag { position: absolute; z-index: 2; top: calc(var(--row) / 2 - 11px); left: var(--f); width: 20px; height: 22px;
        margin-left: -4px;
        border: 0;
        padding: 0; background: none; cursor: pointer; border-radius: var(--r-s); }
      .flag svg { width: 20px; height: 22px; overflow: visible; }
      .flag .cloth { fill: var(--c); stroke: var(--ink); stroke-width: 1.25; stroke-linejoin: round; }
      .flag .pole { stroke: var(--ink); stroke-width: 1.75; stroke-linecap: round; }
      .flag .sign { stroke: var(--on-c); stroke-width: 2.2; stroke-linecap: round; }
      .flag.on .cloth { fill: var(--now); }
      .flag.on .sign { stroke: var(--on-now); }
      .flag:focus-visible { position: absolute; }
      .bar::before, .flag::before { content: ""; position: absolute; inset: -8px 0; }
      @media (max-height: 740px) { :host { --shown: 2; } }
      @media (pointer: coarse) {
        :host { --row: 45px; --shown: 2; }
        .name .reset { width: 44px; }
        .bar::before, .flag::before { inset: -16px -12px; }
      }
      @media (max-width: 719px) {
        .pair { grid-template-columns: minmax(0, 1fr); height: auto; }
        .pair:not(.sel) { display: none; }
        .name { height: 44px; }
        .lane { height: 44px; }
        .sel .bar { top: 14px; height: 16px; }
        .grip { width: 32px; }
        .grip.begin { left: -22px; } .grip.end { right: -22px; }
        .grip.begin::after { left: auto; right: 3.5px; } .grip.end::after { left: 3.5px; }
      }
    `,
  ];

  protected override render() {
    const { session } = this;
    const { rows } = session.contacts;
    if (rows.length === 0) return nothing;
    const last = Math.max(1, session.player.frames - 1);
    return html`<div class="rows" tabindex=${rows.length > 3 ? 0 : nothing} role="group" aria-label="Ground contacts">
      ${rows.map((row) => this.renderRow(row, last))}</div>`;
  }

  private renderRow(row: ContactRow, last: number) {
    const { session } = this;
    const on = session.selection.point === row.id;
    const mark = row.number === null ? nothing : badge(row.number, { now: on });
    return html`<div class="pair ${on ? "sel" : ""}">
      <div class="name">
        <button class="who" aria-pressed=${on} @click=${() => this.pick(row, !on)}>${mark}<span>${row.name}</span></button>
        ${row.edited ? this.renderReset(row) : nothing}
      </div>
      <div class="lane ${on ? "sel" : ""}" style=${row.number === null ? "" : pointStyle(row.number)}
        @pointerdown=${(event: PointerEvent) => this.draw(event, row)} @pointermove=${this.move}
        @pointerup=${this.release} @pointercancel=${this.release}>
        ${row.runs.map((run, at) => this.renderBar(row, run, at, last, on))}
        ${session.pins.here
          .filter(({ point, frame }) => point === row.id && frame >= 0 && frame <= last)
          .map((pin) => this.renderFlag(pin, last))}
      </div></div>`;
  }

  private renderReset({ id, name }: ContactRow) {
    return html`<button class="reset" title="As in the motion again" aria-label="${name}: as in the motion again"
      @click=${() => this.session.contacts.reset(id)}>${icon("undo")}</button>`;
  }

  private renderBar(row: ContactRow, [from, b]: Run, at: number, last: number, on: boolean) {
    const a = Math.max(0, from);
    if (b <= a || a > last) return nothing; // cut off
    const where = row.id === FLIGHTS ? `In the air between ${a} and ${b}` : `On the ground from ${a} to ${b - 1}`;
    const how = "Arrows move its end, with Shift its beginning; Delete takes it away.";
    const grab = (grip: Grip) => (event: PointerEvent) => this.grab(event, row, at, grip);
    return html`<button class="bar ${row.id === FLIGHTS ? "air" : ""}" title=${where} aria-label="${row.name}: ${where}. ${how}"
      style="--a:${(100 * a) / last}%;--w:${(100 * (Math.min(b, last) - a)) / last}%"
      @pointerdown=${grab("all")} @keydown=${(event: KeyboardEvent) => this.key(event, row, at)}>
      ${on ? GRIPS.map((grip) => html`<span class="grip ${grip}" @pointerdown=${grab(grip)}></span>`) : nothing}
    </button>`;
  }

  private renderFlag(pin: Pin, last: number) {
    const { pins, player } = this.session;
    const on = pins.chosen === pin.id || pin.frame === player.frame;
    const [says, sign] = FLAGS[pin.kind];
    const chosen = pins.chosen === pin.id;
    return html`<button class="flag ${on ? "on" : ""}" style="--f:${(100 * pin.frame) / last}%" aria-pressed=${chosen}
      title="Pin at ${pin.frame}: ${says}" aria-label="Pin at frame ${pin.frame}: ${says}"
      @pointerdown=${(event: Event) => event.stopPropagation()} @click=${() => pins.choose(chosen ? null : pin.id)}
      @keydown=${(event: KeyboardEvent) => this.flagKey(event, pin)}>
      <svg viewBox="0 0 20 22" aria-hidden="true"><path class="pole" d="M4 3v18"/><path class="cloth" d="M4 3h13l-3 4.5 3 4.5H4Z"/>
        <path class="sign" d=${sign} /></svg></button>`;
  }

  private pick(row: ContactRow, on: boolean): void {
    this.session.selection.select(on ? row.id : null);
  }

  /** The frame under the pointer. */
  private frameAt(event: PointerEvent, lane: Element): number {
    const { left, width } = lane.getBoundingClientRect();
    const last = Math.max(1, this.session.player.frames - 1);
    return Math.max(0, Math.min(last, Math.round(((event.clientX - left) / width) * last)));
  }

  private grab(event: PointerEvent, row: ContactRow, at: number, grip: Grip): void {
    event.stopPropagation();
    if (this.session.selection.point !== row.id) {
      this.pick(row, true);
      return;
    }
    const lane = (event.currentTarget as Element).closest(".lane")!;
    lane.setPointerCapture(event.pointerId);
    this.held = { row: row.id, at, grip, from: this.frameAt(event, lane), runs: row.runs, gesture: Symbol("run") };
  }

  /** On the empty lane of the chosen row a new bar is drawn. */
  private draw(event: PointerEvent, row: ContactRow): void {
    if (this.session.selection.point !== row.id) {
      this.pick(row, true);
      return;
    }
    const lane = event.currentTarget as Element;
    lane.setPointerCapture(event.pointerId);
    const from = this.frameAt(event, lane);
    const runs = [...row.runs, [from, from + 1] as const];
    this.held = { row: row.id, at: runs.length - 1, grip: "end", from, runs, gesture: Symbol("run") };
  }

  private readonly move = (event: PointerEvent): void => {
    const { held, session } = this;
    if (!held) return;
    const by = this.frameAt(event, event.currentTarget as Element) - held.from;
    if (by === 0 && held.grip !== "end") return;
    const back = held.grip === "end" && by < 0 && (held.runs[held.at]?.[1] ?? 0) - (held.runs[held.at]?.[0] ?? 0) === 1;
    session.contacts.say(held.row, movedRun(held.runs, held.at, back ? "begin" : held.grip, by, session.player.frames), held.gesture);
  };

  private readonly release = (): void => {
    this.held = null;
  };

  private key(event: KeyboardEvent, row: ContactRow, at: number): void {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const { contacts, player } = this.session;
    if (by !== undefined) contacts.say(row.id, movedRun(row.runs, at, event.shiftKey ? "begin" : "end", by, player.frames));
    else if (event.key === "Delete" || event.key === "Backspace") contacts.say(row.id, row.runs.toSpliced(at, 1));
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private flagKey(event: KeyboardEvent, pin: Pin): void {
    if (event.key !== "Delete" && event.key !== "Backspace") return;
    event.preventDefault();
    event.stopPropagation();
    this.session.pins.remove(pin.id);
  }
}
