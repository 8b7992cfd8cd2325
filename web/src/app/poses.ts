import * as commands from "../document/commands";
import type { Example, Vec3 } from "../document/types";
import type { Motion } from "../engine/types";
import { sayPose } from "../sync/pairing";
import type { SaidPose } from "../sync/pairing";
import { exampleControls, pointPartners, pointsOfControls } from "../sync/prepare";
import type { Drag } from "./dragging";
import { mirroredFrame } from "./mirrored";
import type { Session } from "./session";

const POSED = "You made a pose.";

/** "When the human does this, my model does that": making, changing and finding poses. */
export class Poses {
  private readonly mirrors = new WeakMap<Example, { motion: Motion; frame: number | null }>();

  constructor(private readonly session: Session) {}

  /** Poses made on the motion that plays, by frame. */
  get here(): readonly Example[] {
    return this.session.document.examples.filter((pose) => this.isHere(pose)).sort((a, b) => a.source.frame - b.source.frame);
  }

  isHere(pose: Example): boolean {
    return pose.source.motion === this.session.motionName;
  }

  /** Where the clip shows the mirror images of poses that teach theirs too; none beside a pose of its own. */
  get mirrored(): readonly { pose: Example; frame: number }[] {
    const { document, motion } = this.session;
    if (!motion || !document.settings.symmetry || !pointPartners(document.points)) return [];
    const own = this.here.map((pose) => pose.source.frame);
    return document.examples.flatMap((pose) => {
      const frame = this.mirrorOf(pose, motion);
      return frame === null || own.some((other) => Math.abs(other - frame) < 4) ? [] : [{ pose, frame }];
    });
  }

  private mirrorOf(pose: Example, motion: Motion): number | null {
    const known = this.mirrors.get(pose);
    if (known?.motion === motion) return known.frame;
    const frame = mirroredFrame(pose, this.session.document, motion);
    this.mirrors.set(pose, { motion, frame });
    return frame;
  }

  /** C x 3 body-local: where a pose puts the points. */
  targetsOf(pose: Example): Float32Array | null {
    const { model, document } = this.session;
    return model ? exampleControls(model, document, pose) : null;
  }

  /** Makes what the hand holds an example at its frame; one that is there already changes. */
  keep({ frame, targets, wasPlaying }: Pick<Drag, "frame" | "targets" | "wasPlaying">): void {
    const { session } = this;
    const said = this.pairAt(frame, targets);
    if (!said) return;
    const { roles, ...pair } = said;
    const old = this.here.find((pose) => pose.source.frame === frame);
    session.holdShape(frame, wasPlaying);
    if (old) session.apply(commands.replaceExample({ ...old, ...pair }, roles));
    else {
      const id = commands.freeId(session.document.examples, "e");
      session.apply(commands.addExample({ id, source: { motion: session.motionName, frame }, ...pair }, roles));
    }
    const instead = old ? `It took the place of the one at frame ${frame}. ` : "";
    session.notices.say({ title: POSED, text: `${instead}The whole dance followed.`, icon: "poses", actions: [session.undoAction()] });
  }

  /** The present shape as a pose at this frame. */
  add(): void {
    const { session } = this;
    const { player } = session;
    if (!session.performance) return;
    session.endIntro();
    this.keep({ frame: player.frame, targets: this.controlsAt(player.frame), wasPlaying: player.playing });
  }

  /** Moves a pose to this frame, with the human and the shape that are there. */
  update(id: string): void {
    const { session } = this;
    const { frame } = session.player;
    const pose = this.find(id);
    const said = session.performance && this.pairAt(frame, this.controlsAt(frame));
    if (!pose || !said) return;
    const { roles, ...pair } = said;
    session.apply(commands.replaceExample({ ...pose, source: { motion: session.motionName, frame }, ...pair }, roles));
  }

  remove(id: string): void {
    const pose = this.find(id);
    if (!pose) return;
    const { session } = this;
    session.apply(commands.removeExample(id));
    const title = `The pose at frame ${pose.source.frame} is gone.`;
    session.notices.say({ title, text: "The dance goes on without it.", icon: "poses", actions: [session.undoAction()] });
  }

  goTo(id: string): void {
    const pose = this.find(id);
    if (!pose || !this.isHere(pose)) return;
    this.visit(pose.source.frame);
  }

  visit(frame: number): void {
    this.session.player.pause();
    this.session.player.seek(frame);
  }

  /** The next pose before (-1) or after (1) the playhead, around the ends. */
  step(direction: 1 | -1): void {
    const { here } = this;
    const now = this.session.player.frame;
    const next =
      direction > 0
        ? (here.find((pose) => pose.source.frame > now) ?? here[0])
        : (here.findLast((pose) => pose.source.frame < now) ?? here.at(-1));
    if (next) this.goTo(next.id);
  }

  private find(id: string): Example | undefined {
    return this.session.document.examples.find((example) => example.id === id);
  }

  private controlsAt(frame: number): Float32Array {
    const { performance, document } = this.session;
    const size = 3 * document.points.length;
    return performance?.controls.slice(frame * size, (frame + 1) * size) ?? new Float32Array(size);
  }

  /** The human at a frame and the model as these controls have it. */
  private pairAt(frame: number, controls: Float32Array): (SaidPose & { points: Record<string, Vec3> }) | null {
    const { motion, model, document } = this.session;
    if (!motion || !model) return null;
    const size = 3 * motion.joints.length;
    return {
      ...sayPose(document, motion, motion.local.subarray(frame * size, (frame + 1) * size)),
      points: pointsOfControls(model, document, controls),
    };
  }
}
