import type { Session } from "./session";

/** The Points panel: click a place on the model, then the joint that moves it. */
export class Pairing {
  /** A click on the mesh makes a point. */
  adding = false;
  /** The point that waits for its joint. */
  waiting: string | null = null;

  constructor(private readonly session: Session) {}

  toggleAdd(): void {
    this.adding = !this.adding;
    this.setWaiting(null);
  }

  start(): void {
    this.adding = true;
    this.setWaiting(null);
  }

  stop(): void {
    this.adding = false;
    this.setWaiting(null);
  }

  surface(vertex: number): void {
    if (!this.adding) return;
    const id = this.session.points.add(vertex);
    if (id) this.setWaiting(id);
  }

  joint(joint: number): void {
    const name = this.session.motion?.joints[joint]?.name;
    const id = this.waiting ?? this.session.selected;
    if (!name || !id) return;
    this.session.points.pair(id, name);
    this.setWaiting(null);
  }

  pick(id: string, on: "model" | "human"): void {
    if (this.session.guesses.take(id)) return;
    if (this.waiting && on === "human") {
      const point = this.session.document.points.find((other) => other.id === id);
      if (point?.joint) {
        this.session.points.pair(this.waiting, point.joint);
        this.setWaiting(null);
        return;
      }
    }
    this.session.select(id);
    this.setWaiting(on === "model" && this.session.panel === "points" ? id : null);
  }

  setWaiting(id: string | null): void {
    this.waiting = id;
    this.session.viewport?.setLivePair(id ? { id } : null);
    this.session.emit("pairing", undefined);
  }
}
