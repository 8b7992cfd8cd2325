import * as clips from "../document/clips";
import type { Gesture } from "../document/store";
import type { Context } from "./context";
import { runsOf } from "./runs";
import type { Run } from "./runs";
import { FLIGHTS } from "./selection";

export interface ContactRow {
  /** A point's id, or FLIGHTS. */
  readonly id: string;
  readonly name: string;
  /** From 1; null for the flights. */
  readonly number: number | null;
  readonly runs: readonly Run[];
  /** Not as in the motion. */
  readonly edited: boolean;
}

/** Who stands on the ground when, and when nobody does: from the motion, until somebody says otherwise. */
export class Contacts {
  constructor(private readonly context: Context) {}

  /** Points that ever stand, are held by a pin or are selected, and the flights. */
  get rows(): readonly ContactRow[] {
    const { document, performance, selection } = this.context;
    if (!performance) return [];
    const { contacts = {}, flights, pins = [] } = clips.clipOf(document);
    const points = document.points
      .map(({ id, name }, control): ContactRow => {
        const said = Object.hasOwn(contacts, id) ? contacts[id] : undefined;
        return {
          id,
          name,
          number: control + 1,
          runs: said ?? runsOf(performance, control, document.points.length),
          edited: said !== undefined,
        };
      })
      .filter(({ id, runs, edited }) => runs.length > 0 || edited || id === selection.point || pins.some((pin) => pin.point === id));
    const air: ContactRow = {
      id: FLIGHTS,
      name: "In the air",
      number: null,
      runs: flights ?? performance.flights,
      edited: flights !== undefined,
    };
    return points.length === 0 || (air.runs.length === 0 && !air.edited) ? points : [...points, air];
  }

  /** One gesture is one step. */
  say(row: string, runs: readonly Run[], gesture?: Gesture): void {
    this.context.history.apply(row === FLIGHTS ? clips.setFlights(runs) : clips.setContacts(row, runs), gesture);
  }

  /** As in the motion again. */
  reset(row: string): void {
    this.context.history.apply(row === FLIGHTS ? clips.setFlights(null) : clips.setContacts(row, null));
  }
}
