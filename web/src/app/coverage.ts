import type { Session } from "./session";

/** Guesswork that is not worth a question. */
const ENOUGH = 0.35;

/** Asks for the pose that would teach most. */
export class Coverage {
  /** The frame that is asked about now. */
  asking: number | null = null;

  constructor(private readonly session: Session) {}

  /** Frames worth a pose, best first: none once there are enough. */
  get asked(): readonly number[] {
    const { performance, document, motion } = this.session;
    if (!performance || !motion || document.points.length === 0) return [];
    const { ask, enough, coverage } = performance;
    if (enough.have >= enough.want) return [];
    const taken = new Set(this.session.poses.here.map((pose) => pose.source.frame));
    return ask
      .map(({ frame }) => frame)
      .filter((frame) => !taken.has(frame) && (coverage[frame] ?? 0) > ENOUGH)
      .slice(0, 3);
  }

  ask(frame: number | undefined = this.asked[0]): void {
    if (frame === undefined) return;
    const { session } = this;
    session.player.pause();
    session.player.seek(frame);
    session.endIntro();
    this.set(frame);
  }

  /** What the hand holds, or the shape that is there, is the answer. */
  keep(): void {
    const { session } = this;
    if (this.asking === null) return;
    this.set(null);
    session.keepShape();
  }

  skip(): void {
    this.set(null);
  }

  /** The question is over once the playhead leaves it or a pose answers it. */
  follow(): void {
    const { asking, session } = this;
    if (asking === null) return;
    if (session.player.frame !== asking || session.poses.here.some((pose) => pose.source.frame === asking)) this.set(null);
  }

  private set(frame: number | null): void {
    if (frame === this.asking) return;
    this.asking = frame;
    this.session.viewport?.setAsking(frame !== null);
    this.session.emit("coverage", undefined);
  }
}
