import { addPoint, freeId } from "../document/commands";
import { boundsOf } from "../document/stage-transform";
import type { Point } from "../document/types";
import type { ShapeAnalysis } from "../engine/types";
import type { Guess } from "../sync/guess";
import type { SolverModel } from "../sync/placement";
import type { Context } from "./context";

const MARK = "suggested ";

/** What a model says of itself, asked once: how it stands, and where it may well be held. */
export class Guesses {
  private readonly known = new WeakMap<SolverModel, ShapeAnalysis>();
  private latest: { model: SolverModel; guess: Guess } | null = null;

  constructor(private readonly context: Context) {
    context.signals.on("panel", () => {
      if (context.selection.panel === "points") void this.suggest();
    });
  }

  /** Null if that cannot be found out, which is no reason not to open a model. */
  async of(model: SolverModel): Promise<Guess | null> {
    const { workspace } = this.context;
    try {
      const { guessPoints } = await import("../sync/guess");
      const said = this.known.get(model) ?? (await workspace.analyseShape(model));
      this.known.set(model, said);
      return guessPoints(model, said, workspace.motion?.joints ?? []);
    } catch {
      return null;
    }
  }

  /** Finds out where else the present model may be held, and says so. */
  async suggest(): Promise<void> {
    const { model } = this.context;
    if (!model) return;
    const guess = await this.of(model);
    if (!guess || this.context.model !== model) return;
    this.latest = { model, guess };
    this.context.signals.tell("suggestions");
  }

  /** Points that are suggested: none where there is one already. */
  get suggested(): readonly Point[] {
    const { model, document } = this.context;
    if (!model || this.latest?.model !== model) return [];
    const { points, more } = this.latest.guess;
    const { min, max } = boundsOf(model.positions);
    const up = "xyz".indexOf(document.mesh.up.charAt(1));
    const reach = 0.1 * (max[up] - min[up]);
    const near = (a: Point, b: Point): boolean => Math.hypot(...a.position.map((value, k) => value - b.position[k])) < reach;
    return [...points, ...more].filter((suggested) => !document.points.some((point) => near(point, suggested)));
  }

  /** The id of the mark that stands for a suggested point. */
  markOf(suggested: Pick<Point, "id">): string {
    return MARK + suggested.id;
  }

  /** Makes a point of a suggested one, if that is what this mark stands for. */
  take(mark: string): boolean {
    const { history, selection, document } = this.context;
    const suggested = this.suggested.find((point) => this.markOf(point) === mark);
    if (!suggested) return false;
    const { points } = document;
    const id = points.some((point) => point.id === suggested.id) ? freeId(points, "p") : suggested.id;
    history.apply(addPoint({ ...suggested, id }, this.latest?.guess.roles));
    selection.select(id);
    return true;
  }
}
