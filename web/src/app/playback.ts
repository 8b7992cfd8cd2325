import type { Context } from "./context";

/** What plays: as long as the motion, made first where the playhead is, and going on by itself once a frame is there. */
export class Playback {
  /** Go on playing once the frame at the playhead has been solved. */
  private resume: boolean;

  constructor(
    private readonly context: Context,
    begins: boolean,
  ) {
    const { player, workspace, signals } = context;
    this.resume = begins;
    player.on("frame", (frame) => workspace.focus(frame));
    workspace.on("motion", (motion) => player.setFrames(motion.frames));
    workspace.on("performance", () => player.setFrames(context.performance?.frames ?? context.motion?.frames ?? 0));
    workspace.on("frame", (frame) => {
      if (frame !== player.frame || !this.resume) return;
      this.resume = false;
      player.play();
    });
    signals.on("freeze", ({ playOn }) => {
      this.resume ||= playOn;
    });
  }

  /** Plays or pauses; whoever does so wants no more surprises. */
  toggle(): void {
    this.resume = false;
    this.context.player.toggle();
  }
}
