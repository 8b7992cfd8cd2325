// What can be done to the motion that plays: cut, turned to a loop, sped up, mirrored, and corrected where its file was read wrongly.
// Not part of the first load.

import { saidOf } from "../document/clips";
import { correctFile, editMotion, type FileEdits, type MotionEdits } from "../document/edit-clip";
import { type ClipEdits, SAID_ROLES, type SaidRole } from "../document/types";
import { EngineError, type Motion, type MotionInput } from "../engine/types";
import { roleOf } from "../skeleton/pair-joints";
import { bestLoop, type Loop } from "../sync/best-loop";
import { pointJoints } from "../sync/pairing";
import { motionEdits } from "../sync/translate";
import { SHORTEST_LOOP } from "../util/constants";
import type { Context } from "./context";

export { SAID_ROLES, type SaidRole } from "../document/types";

export const SPEEDS = [0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 3, 4] as const;

/** From a dance's first frame to its last there are at least so many. */
const SHORTEST = 2;

/** A session's one, which is made when it is wanted first. */
export function editingOf(session: { readonly context: Context; editing: MotionEditing | null }): MotionEditing {
  return (session.editing ??= new MotionEditing(session.context));
}

export class MotionEditing {
  /** All of the motion, as it is read and not cut; null until it was looked at. */
  take: Motion | null = null;
  /** Where it loops best: in all of it, or near the present cut. */
  loop: Loop | null = null;
  /** The role whose joint is to be clicked on the human. */
  waiting: SaidRole | null = null;
  private looked: { input: MotionInput; said: string } | null = null;
  private near = "";

  constructor(private readonly context: Context) {
    for (const topic of ["document", "panel"] as const) context.signals.on(topic, () => void this.look());
    context.signals.on("panel", () => this.waitFor(null));
    void this.look();
  }

  get said(): ClipEdits {
    return saidOf(this.context.document);
  }

  /** The first frame and the last of what is danced. */
  get cut(): readonly [number, number] {
    const last = Math.max(2, (this.take ?? this.context.motion)?.takeFrames ?? 2) - 1;
    const [a, b] = this.said.cut ?? [0, last];
    return [Math.min(a, last - 1), Math.min(b, last)];
  }

  /** The human from the lowest joint to the highest, where it stands tallest; metres. */
  get tall(): number {
    const { motion } = this.context;
    if (!motion) return 0;
    const { positions, joints, frames } = motion;
    let tallest = 0;
    for (let f = 0; f < frames; f += Math.ceil(frames / 60)) {
      const heights = joints.map((_, j) => positions[3 * (f * joints.length + j) + 1]);
      tallest = Math.max(tallest, Math.max(...heights) - Math.min(...heights));
    }
    return tallest;
  }

  /** Frames of the whole motion at which a cut is likely to be wanted. */
  get marks(): readonly number[] {
    const { take, loop } = this;
    if (!take) return [];
    const { left, right } = take.stands;
    const steps = Array.from({ length: take.frames }, (_, f) => f).filter(
      (f) => f > 0 && (left[f] !== left[f - 1] || right[f] !== right[f - 1]),
    );
    return [...steps, ...(loop?.cut ?? [])];
  }

  /** A cut whose end is moved to a frame, or to the mark nearest to it within `reach` frames. */
  movedEnd(end: 0 | 1, to: number, reach: number): readonly [number, number] {
    const last = (this.take?.frames ?? 2) - 1;
    const [a, b] = this.cut;
    const near = this.marks.reduce((best, mark) => (Math.abs(mark - to) < Math.abs(best - to) ? mark : best), Infinity);
    const at = Math.abs(near - to) <= reach ? near : to;
    const least = this.said.loop ? SHORTEST_LOOP - 1 : SHORTEST;
    return end === 0 ? [Math.max(0, Math.min(at, b - least)), b] : [a, Math.min(last, Math.max(at, a + least))];
  }

  /** Null: all of it. */
  setCut(cut: readonly [number, number] | null): void {
    const last = (this.take?.frames ?? Infinity) - 1;
    this.edit({ cut: cut && (cut[0] > 0 || cut[1] < last) ? cut : undefined });
  }

  setSpeed(speed: number): void {
    this.edit({ speed: speed === 1 ? undefined : speed });
  }

  setMirror(on: boolean): void {
    this.edit({ mirror: on || undefined });
  }

  /** Cuts it where it loops best and makes it end as it begins; or lets it end as it does. */
  setLoop(on: boolean): void {
    const { loop } = this;
    this.edit(on ? { loop: true, ...(loop && { cut: loop.cut }) } : { loop: undefined });
  }

  correct(edits: FileEdits): void {
    this.context.history.apply(correctFile(edits));
  }

  /** A quarter turn more. */
  turn(): void {
    const turn = ((this.said.file?.turn ?? 0) + 90) % 360;
    this.correct({ turn: turn === 90 || turn === 180 || turn === 270 ? turn : undefined });
  }

  /** So many frames of the file a second; null: as it says. What was said of frames stays with them. */
  setRate(fps: number | null, own: number): void {
    const now = this.said.file?.fps ?? own;
    this.context.history.apply(correctFile({ fps: fps ?? undefined }, (fps ?? own) / now));
  }

  /** The joint that has a role. */
  jointOf(role: SaidRole): string | null {
    return this.context.motion?.joints.find((joint) => roleOf(joint) === role)?.name ?? null;
  }

  /** Says which joint has a role; null: the one that was found. If the other side has that joint, the two change places. */
  setJoint(role: SaidRole, joint: string | null): void {
    const { [role]: _, ...joints } = this.said.file?.joints ?? {};
    const part = role.split(" ").at(-1);
    const other = SAID_ROLES.find((one) => one !== role && one.split(" ").at(-1) === part && this.jointOf(one) === joint);
    const before = this.jointOf(role);
    const said = { ...joints, ...(joint !== null && { [role]: joint, ...(other && before && { [other]: before }) }) };
    this.correct({ joints: Object.keys(said).length > 0 ? said : undefined });
  }

  waitFor(role: SaidRole | null): void {
    if (role === this.waiting) return;
    this.waiting = role;
    this.context.signals.tell("pairing");
  }

  /** A joint of the human was clicked, or the dot of a point there; false: nobody asked for one. */
  takeJoint(joint: number): boolean {
    const name = this.context.motion?.joints[joint]?.name;
    if (!this.waiting || name === undefined) return false;
    this.setJoint(this.waiting, name);
    this.waitFor(null);
    return true;
  }
  takeDot(point: string): boolean {
    const { document, motion } = this.context;
    return motion !== null && this.takeJoint(pointJoints(document, motion)[document.points.findIndex(({ id }) => id === point)]);
  }

  private edit(edits: MotionEdits): void {
    this.context.history.apply(editMotion(edits));
  }

  /** Reads all of the motion by an engine of its own, so that what plays is not disturbed; then looks for loops. */
  private async look(): Promise<void> {
    const { context } = this;
    const { document, selection, workspace, signals } = context;
    const input = workspace.library.motion(document.motion.files);
    if (selection.panel !== "motion" || !input) return;
    const edits = { ...motionEdits(document), first: 0, last: 1e9, loop: false };
    const said = JSON.stringify(edits);
    if (this.looked?.input !== input || this.looked.said !== said) {
      this.looked = { input, said };
      const take = await this.read({ ...input, edits });
      if (this.looked.said !== said || this.looked.input !== input) return; // another is on its way
      this.take = take;
      this.near = "";
    }
    const near = this.said.loop ? undefined : this.said.cut;
    if (this.take && !this.said.loop && this.near !== `${near}`) {
      this.near = `${near}`;
      this.loop = bestLoop(this.take, near);
    }
    signals.tell("solve");
  }

  private async read(input: MotionInput): Promise<Motion | null> {
    const engine = this.context.workspace.createEngine();
    try {
      return await engine.setMotion(input);
    } catch (error) {
      if (error instanceof EngineError) return null; // the engine that plays it says so
      throw error;
    } finally {
      engine.close();
    }
  }
}
