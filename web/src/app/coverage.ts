import type { Context } from "./context";
import type { Poses } from "./poses";

/** Guesswork that is not worth a question. */
const ENOUGH = 0.35;

/** Asks for the pose that would teach most. */
export class Coverage {
  /** The frame that is asked about now. */
  asking: number | null = null;

  constructor(
    private readonly context: Context,
    private readonly poses: Poses,
  ) {
    context.signals.on("document", () => this.follow());
  }

  /** Frames worth a pose, best first: none once there are enough. */
  get asked(): readonly number[] {
    const { performance, document, motion } = this.context;
    if (!performance || !motion || document.points.length === 0) return [];
    const { ask, enough, coverage } = performance;
    if (enough.have >= enough.want) return [];
    const taken = new Set(this.poses.here.map((pose) => this.poses.frameOf(pose)));
    return ask
      .map(({ frame }) => frame)
      .filter((frame) => !taken.has(frame) && (coverage[frame] ?? 0) > ENOUGH)
      .slice(0, 3);
  }

  ask(frame: number | undefined = this.asked[0]): void {
    if (frame === undefined) return;
    this.poses.visit(frame);
    this.context.selection.endIntro();
    this.set(frame);
  }

  /** What the hand holds, or the shape that is there, is the answer. */
  answer(): void {
    if (this.asking === null) return;
    this.set(null);
    this.poses.add();
  }

  skip(): void {
    this.set(null);
  }

  /** The question is over once a pose answers it, or the document changes while the playhead is elsewhere. */
  private follow(): void {
    const { asking } = this;
    if (asking === null) return;
    if (this.context.player.frame !== asking || this.poses.here.some((pose) => this.poses.frameOf(pose) === asking)) this.set(null);
  }

  private set(frame: number | null): void {
    if (frame === this.asking) return;
    this.asking = frame;
    this.context.signals.tell("coverage");
  }
}
