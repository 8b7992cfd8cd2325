import * as commands from "../document/commands";
import type { Vec3 } from "../document/types";
import { sayJoint } from "../sync/pairing";
import type { Session } from "./session";

/** Making, naming, pairing and taking away points. */
export class Points {
  constructor(private readonly session: Session) {}

  /** A new point at a vertex of the model, or the one that is there; answers its id. */
  add(vertex: number): string | null {
    const { model, document } = this.session;
    if (!model || vertex < 0) return null;
    const [x, y, z] = model.positions.subarray(3 * vertex, 3 * vertex + 3);
    const position: Vec3 = [x, y, z];
    const taken = document.points.find((point) => point.position.every((value, k) => value === position[k]));
    if (taken) return taken.id;
    const id = commands.freeId(document.points, "p");
    this.session.apply(commands.addPoint({ id, name: `Point ${document.points.length + 1}`, position, joint: null }));
    this.session.select(id);
    return id;
  }

  rename(id: string, name: string): void {
    if (name.trim() !== "") this.session.apply(commands.renamePoint(id, name.trim()));
    else this.session.emit("document", undefined);
  }

  pair(id: string, joint: string | null): void {
    const { document, motion } = this.session;
    const driver = motion?.joints.find(({ name }) => name === joint);
    const { name, roles } = driver ? sayJoint(document, driver) : { name: joint, roles: {} };
    this.session.apply(commands.pairPoint(id, name, roles));
  }

  /** Its partner on the other side, itself in the middle, or nobody. */
  pairMirror(id: string, partner: string | null): void {
    this.session.apply(commands.pairMirror(id, partner));
  }

  remove(id: string): void {
    const { session } = this;
    const name = session.document.points.find((point) => point.id === id)?.name ?? "A point";
    session.apply(commands.removePoint(id));
    if (session.pairing.waiting === id) session.pairing.setWaiting(null);
    session.notices.say({ title: `${name} is gone.`, text: "Poses forgot it too.", icon: "points", actions: [session.undoAction()] });
  }

  removeSelected(): boolean {
    const { selected, drag } = this.session;
    if (selected === null || drag || !this.session.document.points.some(({ id }) => id === selected)) return false;
    this.remove(selected);
    return true;
  }
}
