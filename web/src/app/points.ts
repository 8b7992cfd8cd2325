import * as commands from "../document/commands";
import type { FollowThrough, Vec3 } from "../document/types";
import { describeJoints } from "../skeleton/pair-joints";
import { pointJoints, sayJoint } from "../sync/pairing";
import type { Context } from "./context";

export { DEFAULT_FOLLOW } from "../document/types";
export type { FollowThrough, Point } from "../document/types";

export const FOLLOWS: readonly FollowThrough[] = ["stiff", "bouncy", "floppy"];

export interface Driver {
  /** As the motion calls it. */
  readonly name: string;
  readonly label: string;
}

/** Making, setting, pairing and taking away points. */
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

  /** Its name or how it holds the model. Answers false to an empty name: every point has one. */
  set(id: string, settings: commands.PointSettings): boolean {
    const name = settings.name?.trim();
    if (name === "") return false;
    this.context.history.apply(commands.setPoint(id, name === undefined ? settings : { ...settings, name }));
    return true;
  }

  pair(id: string, joint: string | null): void {
    const { document, motion, history } = this.context;
    const driver = motion?.joints.find(({ name }) => name === joint);
    const { name, roles } = driver ? sayJoint(document, driver) : { name: joint, roles: {} };
    history.apply(commands.pairPoint(id, name, roles));
  }

  /** The joints that may move a point, as people read them. */
  get drivers(): readonly Driver[] {
    const joints = this.context.motion?.joints ?? [];
    return describeJoints(joints).map(({ label }, j) => ({ name: joints[j].name, label }));
  }

  /** C: which of the drivers moves each point; -1 where the whole pose does. */
  get paired(): Int32Array {
    const { document, motion } = this.context;
    return motion ? pointJoints(document, motion) : new Int32Array(document.points.length).fill(-1);
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
