// Numbered marks as real buttons over the picture: crisp, focusable, each projected anew every frame.

import type { Projected } from "./camera-rig";
import type { PointMark, Insets } from "../stage/port";

export type Figure = "model" | "human";

export interface PointHit {
  id: string;
  on: Figure;
}

export interface PlacedMark extends PointHit {
  readonly point: PointMark;
  readonly button: HTMLButtonElement;
  readonly at: Projected;
  behind: boolean;
}

/** Focus that shows: not the one that a press of the pointer leaves behind. */
const FOCUSED = ":focus-visible:not(.pressed)";

const COLOURS = ["#d55e00", "#56b4e9", "#e69f00", "#0072b2", "#cc79a7", "#009e73", "#17212b"];

/** A point's colour as CSS; from 8 on the order repeats. */
export function pointColour(number: number): string {
  const i = (number - 1) % COLOURS.length;
  return `var(--p${i + 1}, ${COLOURS[i]})`;
}

export class PointOverlay {
  readonly element = document.createElement("div");
  /** Model marks first, by number: the order of the Tab key. */
  marks: PlacedMark[] = [];
  insets: Insets = { left: 0, top: 0, right: 0, bottom: 0 };
  private readonly tag = document.createElement("div");
  private hover: PointHit | null = null;
  private selected: string | null = null;
  private held: string | null = null;
  private pulsing: string | null = null;

  constructor() {
    this.element.className = "marks";
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", "Points");
    this.tag.className = "tag";
    this.tag.hidden = true;
    this.element.append(this.tag);
  }

  /** `label` names a joint for people. */
  setPoints(points: readonly PointMark[], selected: string | null, label: (joint: number) => string): void {
    const old = new Map(this.marks.map((mark) => [mark.on + mark.id, mark]));
    const marks: PlacedMark[] = [];
    for (const on of ["model", "human"] as const) {
      for (const point of points) {
        if (on === "human" && point.joint < 0) continue;
        const before = old.get(on + point.id);
        old.delete(on + point.id);
        const mark: PlacedMark = {
          id: point.id,
          on,
          point,
          button: before?.button ?? this.newButton(on),
          at: before?.at ?? { x: -99, y: -99, depth: 0 },
          behind: before?.behind ?? false,
        };
        dress(mark, point.joint < 0 ? null : label(point.joint));
        marks.push(mark);
      }
    }
    for (const gone of old.values()) gone.button.remove();
    // Only what moved is moved: taking a focused button out of the tree would drop the focus.
    marks.forEach((mark, i) => {
      if (this.element.children[i] !== mark.button) this.element.insertBefore(mark.button, this.element.children[i] ?? null);
    });
    this.marks = marks;
    this.selected = selected;
    if (this.pulsing) this.pulse(this.pulsing);
    this.refresh();
  }

  find(id: string, on: Figure): PlacedMark | null {
    return this.marks.find((mark) => mark.id === id && mark.on === on) ?? null;
  }

  owner(button: EventTarget | null): PlacedMark | null {
    return this.marks.find((mark) => mark.button === button) ?? null;
  }

  setHover(hit: PointHit | null): boolean {
    if (hit?.id === this.hover?.id && hit?.on === this.hover?.on) return false;
    this.hover = hit;
    this.refresh();
    return true;
  }

  isHovering(): boolean {
    return this.hover !== null;
  }

  setHeld(id: string | null): void {
    this.held = id;
    if (id !== null && id === this.pulsing) this.pulse(null);
    this.refresh();
  }

  /** Two rings around a dot of the model, three times, for a first visit. */
  pulse(id: string | null): void {
    this.pulsing = id;
    for (const mark of this.marks) mark.button.classList.toggle("pulse", mark.id === id && mark.on === "model");
  }

  /** Gives a mark the focus from a press of the pointer, without the ring until a key is used. */
  press(mark: PlacedMark): void {
    const { button } = mark;
    button.classList.add("pressed");
    button.focus({ preventScroll: true });
    const show = (): void => button.classList.remove("pressed");
    button.addEventListener("keydown", show, { once: true });
    button.addEventListener("blur", show, { once: true });
  }

  /** Of the dots within reach the nearest, but one in front before any behind the mesh. */
  nearest(x: number, y: number, reach: number): PointHit | null {
    let best: PlacedMark | null = null;
    let least = Infinity;
    for (const mark of this.marks) {
      if (mark.button.hidden) continue;
      const away = Math.hypot(mark.at.x - x, mark.at.y - y);
      const cost = away + (mark.behind ? 1e3 : 0);
      if (away <= reach && cost < least) {
        best = mark;
        least = cost;
      }
    }
    return best && { id: best.id, on: best.on };
  }

  /** Puts every button at its mark's projection, on whole device pixels so that numbers stay sharp. */
  place(): void {
    const ratio = window.devicePixelRatio || 1;
    const snap = (value: number): number => Math.round(value * ratio) / ratio;
    for (const { button, at, behind } of this.marks) {
      button.hidden = at.depth <= 0.05;
      button.style.transform = `translate(${snap(at.x)}px, ${snap(at.y)}px)`;
      button.classList.toggle("behind", behind);
    }
  }

  /** Shows words beside a point, or over it where a card or the edge is near at the right; null hides them. */
  showTag(words: string | null, at: Projected | null, gap: number): void {
    this.tag.hidden = words === null || at === null;
    if (words === null || at === null) return;
    if (this.tag.textContent !== words) this.tag.textContent = words;
    const { offsetWidth: width, offsetHeight: height } = this.tag;
    const most = this.element.clientWidth - this.insets.right - width - 4;
    const beside = at.x + gap <= most;
    const x = beside ? at.x + gap : Math.max(4, Math.min(at.x - width / 2, most));
    const y = beside ? at.y - height / 2 : Math.max(4, at.y - gap - height);
    this.tag.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  /** The mark that the tag names: in the hand, else under the pointer, else with the keyboard's focus, else selected. */
  named(): PlacedMark | null {
    const focused = this.marks.find((mark) => mark.button.matches(FOCUSED));
    return (
      (this.held !== null && this.find(this.held, "model")) ||
      (this.hover && this.find(this.hover.id, this.hover.on)) ||
      focused ||
      (this.selected !== null ? this.find(this.selected, "model") : null)
    );
  }

  /** Pairs whose line shows even outside the mode for points. */
  hoveredPair(): string | null {
    if (this.held !== null) return null;
    return this.hover?.id ?? this.marks.find((mark) => mark.button.matches(FOCUSED))?.id ?? null;
  }

  private newButton(on: Figure): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.tabIndex = on === "model" ? 0 : -1; // one stop per pair
    button.append(document.createElement("span"));
    return button;
  }

  private refresh(): void {
    for (const mark of this.marks) {
      const on = mark.id === this.selected || mark.id === this.held;
      mark.button.classList.toggle("on", on);
      mark.button.setAttribute("aria-pressed", String(mark.id === this.selected));
      mark.button.classList.toggle("hover", mark.id === this.hover?.id && mark.on === this.hover.on && !on);
    }
  }
}

function dress({ button, point, on }: PlacedMark, joint: string | null): void {
  button.classList.add("point", on);
  button.classList.toggle("unpaired", joint === null);
  button.classList.toggle("suggested", point.suggested ?? false);
  button.classList.toggle("twin", point.twin ?? false);
  button.classList.toggle("square", point.number > COLOURS.length);
  button.dataset["point"] = point.id;
  const i = ((point.number - 1) % COLOURS.length) + 1;
  button.style.setProperty("--c", pointColour(point.number));
  button.style.setProperty("--on-c", `var(--on-p${i}, ${i === 4 || i === 7 ? "#fff" : "#0b1117"})`);
  const span = button.firstElementChild as HTMLSpanElement;
  span.className = "mark";
  span.textContent = point.suggested ? "+" : String(point.number);
  const pair = joint === null ? "not paired" : on === "model" ? `follows ${joint}` : `on the human: ${joint}`;
  button.setAttribute("aria-label", point.suggested ? `Add a point: ${point.name}` : `${point.number}, ${point.name}, ${pair}`);
}
