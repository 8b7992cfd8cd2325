import { startOf } from "../document/clips";
import * as commands from "../document/commands";
import type { Example } from "../document/types";
import type { Motion } from "../engine/types";
import { sayPose } from "../sync/pairing";
import type { SaidPose } from "../sync/pairing";
import { exampleControls, pointPartners, pointsOfControls, turnsOfControls } from "../sync/point-controls";
import type { Context } from "./context";
import type { Dragging, Dropped } from "./dragging";
import { mirroredFrame } from "./mirrored";

export type { Example } from "../document/types";

const POSED = "You made a pose.";

/** "When the human does this, my model does that": making, changing and finding poses. */
export class Poses {
  private readonly mirrors = new WeakMap<Example, { motion: Motion; frame: number | null }>();

  constructor(
    private readonly context: Context,
    private readonly dragging: Dragging,
  ) {}

  /** The frame of the dance at which a pose was made; on the motion that plays, it may be cut off. */
  frameOf(pose: Example): number {
    return pose.source.frame - startOf(this.context.document);
  }

  /** Poses made on what is danced of the motion that plays, by frame. */
  get here(): readonly Example[] {
    return this.context.document.examples.filter((pose) => this.isHere(pose)).sort((a, b) => a.source.frame - b.source.frame);
  }

  isHere(pose: Example): boolean {
    const { motionName, motion } = this.context;
    const frame = this.frameOf(pose);
    return pose.source.motion === motionName && frame >= 0 && frame < (motion?.frames ?? Infinity);
  }

  /** Points have partners on the other side. */
  get canMirror(): boolean {
    return pointPartners(this.context.document.points) !== null;
  }

  /** Every pose teaches its mirror image too. */
  get teachBothSides(): boolean {
    return this.context.document.settings.symmetry && this.canMirror;
  }

  /** Where the clip shows the mirror images of poses that teach theirs too; none beside a pose of its own. */
  get mirrored(): readonly { pose: Example; frame: number }[] {
    const { document, motion } = this.context;
    if (!motion || !this.teachBothSides) return [];
    const own = this.here.map((pose) => this.frameOf(pose));
    return document.examples.flatMap((pose) => {
      const frame = this.mirrorOf(pose, motion);
      return frame === null || own.some((other) => Math.abs(other - frame) < 4) ? [] : [{ pose, frame }];
    });
  }

  private mirrorOf(pose: Example, motion: Motion): number | null {
    const known = this.mirrors.get(pose);
    if (known?.motion === motion) return known.frame;
    const frame = mirroredFrame(pose, this.context.document, motion);
    this.mirrors.set(pose, { motion, frame });
    return frame;
  }

  /** C x 3 body-local: where a pose puts the points. */
  targetsOf(pose: Example): Float32Array | null {
    const { model, document } = this.context;
    return model ? exampleControls(model, document, pose) : null;
  }

  /** Makes what the hand dropped an example at its frame; one that is there already changes. */
  take({ frame, targets, wasPlaying }: Pick<Dropped, "frame" | "targets" | "wasPlaying">): void {
    const { document, history, notices, signals } = this.context;
    const said = this.pairAt(frame, targets);
    if (!said) return;
    const { roles, ...pair } = said;
    const old = this.here.find((pose) => this.frameOf(pose) === frame);
    signals.emit("freeze", { frame, playOn: wasPlaying });
    if (old) history.apply(commands.replaceExample({ ...old, ...pair }, roles));
    else {
      const id = commands.freeId(document.examples, "e");
      history.apply(commands.addExample({ id, source: this.sourceAt(frame), ...pair }, roles));
    }
    const instead = old ? `It took the place of the one at frame ${frame}. ` : "";
    notices.say({ title: POSED, text: `${instead}The whole dance followed.`, icon: "poses", actions: [history.undoAction()] });
  }

  /** What the hand holds, or else the present shape, becomes a pose. */
  add(): void {
    const { player, selection } = this.context;
    if (this.dragging.active) return this.dragging.drop();
    const targets = this.context.controlsAt(player.frame);
    if (!targets) return;
    selection.endIntro();
    this.take({ frame: player.frame, targets, wasPlaying: player.playing });
  }

  /** Moves a pose to this frame, with the human and the shape that are there. */
  update(id: string): void {
    const { player, history } = this.context;
    const { frame } = player;
    const pose = this.find(id);
    const controls = this.context.controlsAt(frame);
    const said = controls && this.pairAt(frame, controls);
    if (!pose || !said) return;
    const { roles, ...pair } = said;
    history.apply(commands.replaceExample({ ...pose, source: this.sourceAt(frame), ...pair }, roles));
  }

  remove(id: string): void {
    const { history, notices } = this.context;
    const pose = this.find(id);
    if (!pose) return;
    history.apply(commands.removeExample(id));
    const title = `The pose at frame ${this.frameOf(pose)} is gone.`;
    notices.say({ title, text: "The dance goes on without it.", icon: "poses", actions: [history.undoAction()] });
  }

  goTo(id: string): void {
    const pose = this.find(id);
    if (pose && this.isHere(pose)) this.visit(this.frameOf(pose));
  }

  visit(frame: number): void {
    this.context.player.pause();
    this.context.player.seek(frame);
  }

  /** The next pose before (-1) or after (1) the playhead, around the ends. */
  step(direction: 1 | -1): void {
    const { here } = this;
    const now = this.context.player.frame;
    const next =
      direction > 0
        ? (here.find((pose) => this.frameOf(pose) > now) ?? here[0])
        : (here.findLast((pose) => this.frameOf(pose) < now) ?? here.at(-1));
    if (next) this.goTo(next.id);
  }

  sourceAt(frame: number): Example["source"] {
    return { motion: this.context.motionName, frame: frame + startOf(this.context.document) };
  }

  private find(id: string): Example | undefined {
    return this.context.document.examples.find((example) => example.id === id);
  }

  /** The human at a frame and the model as these controls have it. */
  pairAt(frame: number, controls: Float32Array): (SaidPose & Pick<Example, "points" | "turns">) | null {
    const { motion, model, document } = this.context;
    const turns = this.context.workspace.turnsAt(frame);
    if (!motion || !model) return null;
    const size = 3 * motion.joints.length;
    return {
      ...sayPose(document, motion, motion.local.subarray(frame * size, (frame + 1) * size)),
      points: pointsOfControls(model, document, controls),
      ...(turns && { turns: turnsOfControls(model, document, turns) }),
    };
  }
}
