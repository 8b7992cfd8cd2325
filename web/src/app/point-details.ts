// What few points say: how much they listen to the whole pose, how poses turn them, and what keeps its shape. Not part of the
// first load.

import * as commands from "../document/commands";
import { pairMirror } from "../document/pair-mirror";
import { removeStiff, setStiff } from "../document/stiff";
import type { Command, Gesture } from "../document/store";
import type { Point, StiffPart, Vec3 } from "../document/types";
import { turnOfFile, turnOnStage } from "../sync/turns";
import type { Context } from "./context";
import type { Pairing } from "./pairing";
import type { Poses } from "./poses";

export { DEFAULT_WHOLE_POSE } from "../document/types";
export type { StiffPart } from "../document/types";

/** Ways to turn, as the model stands: about the axis across, the vertical, and the one that it looks along. */
export const TURNS = ["Nod", "Turn", "Tilt"] as const;
/** Either way; degrees. */
export const MOST_TURN = 120;
/** Of a new stiff part, in model heights: about a head. */
const REACH = 0.15;
export const MOST_REACH = 0.5;

const DEGREE = Math.PI / 180;

export class PointDetails {
  private slide: { key: string; gesture: Gesture } | null = null;

  constructor(private readonly session: { readonly context: Context; readonly poses: Poses; readonly pairing: Pairing }) {}

  /** While a slider is held, all its values are one step. */
  setWhole({ id }: Point, wholePose: number, held: boolean): void {
    this.apply(commands.setPoint(id, { wholePose }), `whole ${id}`, held);
  }

  /** Its partner on the other side, itself in the middle, or nobody. */
  pairMirror({ id }: Point, partner: string | null): void {
    this.session.context.history.apply(pairMirror(id, partner));
  }

  /** By how much a point is turned at the present frame, degrees about each axis; null: there is no dance. */
  turnOf({ id }: Point): Vec3 | null {
    const { model, document, performance, player } = this.session.context;
    if (!performance || !model) return null;
    const own = this.poseHere?.turns?.[id];
    const at = 3 * (player.frame * document.points.length + document.points.findIndex((point) => point.id === id));
    const [x = 0, y = 0, z = 0] = own ? turnOnStage(model, document, own) : (performance.turns?.subarray(at, at + 3) ?? []);
    return [x / DEGREE, y / DEGREE, z / DEGREE];
  }

  /** The pose at this frame turns the point; without one the present shape becomes a pose. */
  setTurn(point: Point, axis: number, degrees: number, held: boolean): void {
    const { context, poses } = this.session;
    const { model, document, player } = context;
    const { frame } = player;
    const now = this.turnOf(point);
    const controls = context.controlsAt(frame);
    if (!model || !now || !controls) return;
    player.pause();
    const [x, y, z] = now.map((value, k) => (k === axis ? degrees : value) * DEGREE);
    const turn = { [point.id]: turnOfFile(model, document, [x, y, z]) };
    const old = this.poseHere;
    const said = old ? null : poses.pairAt(frame, controls);
    const key = `turn ${point.id} ${axis} ${frame}`;
    if (old) this.apply(commands.replaceExample({ ...old, turns: { ...old.turns, ...turn } }), key, held);
    else if (said) {
      const { roles, ...pair } = said;
      const id = commands.freeId(document.examples, "e");
      const pose = { id, source: poses.sourceAt(frame), ...pair, turns: { ...pair.turns, ...turn } };
      this.apply(commands.addExample(pose, roles), key, held);
    }
  }

  get stiff(): readonly StiffPart[] {
    return this.session.context.document.stiff ?? [];
  }

  /** The next click on the model says what keeps its shape. */
  askForStiff(): void {
    const { pairing, context } = this.session;
    pairing.ask((vertex) => {
      const [x, y, z] = context.model?.positions.subarray(3 * vertex, 3 * vertex + 3) ?? [];
      if (x !== undefined) this.keepStiff([x, y, z]);
    });
  }

  keepStiff(position: Vec3): void {
    const id = commands.freeId(this.stiff, "s");
    this.session.context.history.apply(setStiff({ id, position, radius: REACH }));
  }

  /** How far it reaches, in model heights; null: over the whole piece. */
  setReach({ id, position }: StiffPart, radius: number | null, held: boolean): void {
    this.apply(setStiff(radius === null ? { id, position } : { id, position, radius }), `stiff ${id}`, held);
  }

  soften(part: StiffPart): void {
    const { history, notices } = this.session.context;
    history.apply(removeStiff(part.id));
    notices.say({ title: "It is soft again.", text: "It bends as the rest does.", icon: "points", actions: [history.undoAction()] });
  }

  /** The stiff part around a point, if there is one. */
  around({ position }: Point): StiffPart | undefined {
    return this.stiff.find((part) => part.position.every((value, k) => value === position[k]));
  }

  private get poseHere() {
    const { poses, context } = this.session;
    return poses.here.find((pose) => poses.frameOf(pose) === context.player.frame);
  }

  private apply(command: Command, key: string, held: boolean): void {
    if (held && this.slide?.key !== key) this.slide = { key, gesture: Symbol(key) };
    this.session.context.history.apply(command, this.slide?.key === key ? this.slide.gesture : undefined);
    if (!held) this.slide = null;
  }
}
