import { addPoint, freeId } from "../document/commands";
import type { Point } from "../document/types";
import type { ShapeAnalysis } from "../engine/types";
import type { Guess } from "../sync/guess";
import type { SolverModel } from "../sync/prepare";
import type { Session } from "./session";

/** Marks the dot of a place that is offered. */
const OFFER = "offer ";

/** What a model says of itself, asked once: how it stands, and where it may well be held. */
export class Guesses {
  private readonly known = new WeakMap<SolverModel, ShapeAnalysis>();
  private offered: { model: SolverModel; guess: Guess } | null = null;

  constructor(private readonly session: Session) {}

  /** Null if that cannot be found out, which is no reason not to open a model. */
  async of(model: SolverModel): Promise<Guess | null> {
    const { workspace } = this.session;
    try {
      const { guessPoints } = await import("../sync/guess");
      const said = this.known.get(model) ?? (await workspace.analyseShape(model));
      this.known.set(model, said);
      return guessPoints(model, said, workspace.motion?.joints ?? []);
    } catch {
      return null;
    }
  }

  /** Finds out where else the present model may be held, and shows it. */
  async offer(): Promise<void> {
    const { model } = this.session;
    if (!model) return;
    const guess = await this.of(model);
    if (!guess || this.session.model !== model) return;
    this.offered = { model, guess };
    this.session.showPoints();
    this.session.emit("pairing", undefined);
  }

  offerId(place: string): string {
    return OFFER + place;
  }

  /** Makes a point of an offered place, if that is what this dot stands for. */
  take(mark: string): boolean {
    const { session } = this;
    const place = this.places.find(({ id }) => this.offerId(id) === mark);
    if (!place) return false;
    const { points } = session.document;
    const id = points.some((point) => point.id === place.id) ? freeId(points, "p") : place.id;
    session.apply(addPoint({ ...place, id }, this.offered?.guess.roles));
    session.select(id);
    return true;
  }

  /** Places that are offered: none where a point is already. */
  get places(): readonly Point[] {
    const { model, document } = this.session;
    if (!model || this.offered?.model !== model) return [];
    const { points, more } = this.offered.guess;
    const { mesh } = document;
    const reach = 0.1 * heightOf(model, mesh.up.charAt(1));
    const near = (a: Point, b: Point): boolean => Math.hypot(...a.position.map((value, k) => value - b.position[k])) < reach;
    return [...points, ...more].filter((place) => !document.points.some((point) => near(point, place)));
  }
}

function heightOf(model: SolverModel, axis: string): number {
  let low = Infinity;
  let high = -Infinity;
  for (let i = "xyz".indexOf(axis); i < model.positions.length; i += 3) {
    low = Math.min(low, model.positions[i]);
    high = Math.max(high, model.positions[i]);
  }
  return high - low;
}
