import * as commands from "../document/commands";
import type { Vec3 } from "../document/types";
import type { Context } from "./context";

export type { Point } from "../document/types";

/** Making, naming, pairing and taking away points. */
export class Points {
  constructor(private readonly context: Context) {}

  /** A new point at a vertex of the model, or the one that is there; answers its id. */
  add(vertex: number): string | null {
    const { model, document, history, selection } = this.context;
    if (!model || vertex < 0) return null;
    const [x, y, z] = model.positions.subarray(3 * vertex, 3 * vertex + 3);
    const position: Vec3 = [x, y, z];
    const taken = document.points.find((point) => point.position.every((value, k) => value === position[k]));
    if (taken) return taken.id;
    const id = commands.freeId(document.points, "p");
    history.apply(commands.addPoint({ id, name: `Point ${document.points.length + 1}`, position, joint: null }));
    selection.select(id);
    return id;
  }

  /** Answers false to an empty name: every point has one. */
  rename(id: string, name: string): boolean {
    if (name.trim() === "") return false;
    this.context.history.apply(commands.renamePoint(id, name.trim()));
    return true;
  }

  pair(id: string, joint: string | null): void {
    this.context.history.apply(commands.pairPoint(id, joint));
  }

  /** Its partner on the other side, itself in the middle, or nobody. */
  pairMirror(id: string, partner: string | null): void {
    this.context.history.apply(commands.pairMirror(id, partner));
  }

  remove(id: string): void {
    const { document, history, notices } = this.context;
    const name = document.points.find((point) => point.id === id)?.name ?? "A point";
    history.apply(commands.removePoint(id));
    notices.say({ title: `${name} is gone.`, text: "Poses forgot it too.", icon: "points", actions: [history.undoAction()] });
  }

  /** The selected point's id; null if none is. */
  get selected(): string | null {
    const { document, selection } = this.context;
    return document.points.some(({ id }) => id === selection.point) ? selection.point : null;
  }
}
