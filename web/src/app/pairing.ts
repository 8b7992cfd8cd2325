import type { Context } from "./context";
import type { Guesses } from "./guesses";
import type { Points } from "./points";

/** Making pairs on the stage: click a place on the model, then the joint that moves it. */
export class Pairing {
  /** A click on the mesh makes a point. */
  adding = false;
  /** The point that waits for its joint. */
  waiting: string | null = null;
  /** Takes the next click on the mesh. */
  private next: ((vertex: number) => void) | null = null;

  constructor(
    private readonly context: Context,
    private readonly points: Points,
    private readonly guesses: Guesses,
  ) {
    const { signals, selection } = context;
    signals.on("panel", () => {
      if (selection.panel !== "points") this.stop();
      else if (context.model && context.document.points.length === 0) this.start();
    });
    signals.on("document", () => {
      if (this.waiting !== null && !context.document.points.some(({ id }) => id === this.waiting)) this.waitFor(null);
    });
  }

  /** Something is to be clicked on the stage. */
  get asks(): boolean {
    return this.adding || this.waiting !== null || this.next !== null;
  }

  toggleAdd(): void {
    this.adding = !this.adding;
    this.waitFor(null);
  }

  start(): void {
    this.adding = true;
    this.waitFor(null);
  }

  stop(): void {
    this.adding = false;
    this.waitFor(null);
  }

  /** Where the next click on the mesh is, instead of a point there. */
  ask(next: (vertex: number) => void): void {
    this.stop();
    this.next = next;
    this.context.signals.tell("pairing");
  }

  get asksPlace(): boolean {
    return this.next !== null;
  }

  surface(vertex: number): void {
    const { next } = this;
    if (next) this.waitFor(null);
    next?.(vertex);
    if (!this.adding) return;
    const id = this.points.add(vertex);
    if (id) this.waitFor(id);
  }

  joint(joint: number): void {
    const name = this.context.motion?.joints[joint]?.name;
    const id = this.waiting ?? this.context.selection.point;
    if (!name || !id) return;
    this.points.pair(id, name);
    this.waitFor(null);
  }

  /** A click on a dot of either figure. */
  pick(mark: string, on: "model" | "human"): void {
    const { document, selection } = this.context;
    if (this.guesses.take(mark)) return;
    if (this.waiting && on === "human") {
      const point = document.points.find((other) => other.id === mark);
      if (point?.joint) {
        this.points.pair(this.waiting, point.joint);
        this.waitFor(null);
        return;
      }
    }
    selection.select(mark);
    this.waitFor(on === "model" && selection.panel === "points" ? mark : null);
  }

  waitFor(id: string | null): void {
    this.waiting = id;
    this.next = null;
    this.context.signals.tell("pairing");
  }
}
