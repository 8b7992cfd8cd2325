import type { Example } from "../document/types";
import { EngineError } from "../engine/types";
import type { Shape, StagePort } from "../stage/port";
import type { Context } from "./context";
import type { Dragging } from "./dragging";
import type { Poses } from "./poses";
import type { ClockPort } from "./ports";

const SIZE = 80;
/** A model's first moments belong to its dance: a picture that is read back stops the graphics card. */
const AFTER_STAGED_MS = 1500;

/** Who draws a small picture of a shape, once a model has been put on the stage. */
export type ThumbnailPort = Pick<StagePort, "thumbnail">;

/** Small pictures of the rest shape and of each pose, made while nobody drags. */
export class Thumbnails {
  rest: string | null = null;
  private pictures = new WeakMap<Example, string>();
  private restShape: Shape | null = null;
  private working = false;
  private opened = Promise.resolve();

  constructor(
    private readonly context: Context,
    private readonly poses: Poses,
    private readonly dragging: Dragging,
    private readonly stage: ThumbnailPort,
    private readonly clock: Pick<ClockPort, "idle">,
  ) {
    context.signals.on("staged", (rest) => this.reset(rest));
    context.workspace.on("busy", (busy) => {
      if (!busy) void this.update();
    });
  }

  of(pose: Example): string | null {
    return this.pictures.get(pose) ?? null;
  }

  /** The mesh changed: no picture is true any more. */
  private reset(restShape: Shape): void {
    this.pictures = new WeakMap();
    this.restShape = restShape;
    this.rest = null;
    this.opened = new Promise((resolve) => setTimeout(resolve, AFTER_STAGED_MS));
    this.context.signals.tell("thumbnails");
    void this.update();
  }

  /** Makes what is missing, one by one. */
  private async update(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      do {
        await this.opened;
        await this.clock.idle();
      } while (!this.context.solving && (await this.makeNext()));
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
    } finally {
      this.working = false;
    }
  }

  /** Answers false once there is nothing to make, or something in the way. */
  private async makeNext(): Promise<boolean> {
    const { context, stage, restShape } = this;
    if (restShape === null) return false; // nobody draws yet
    if (this.rest === null) {
      this.rest = stage.thumbnail(restShape, SIZE);
      context.signals.tell("thumbnails");
      return true;
    }
    const pose = context.document.examples.find((example) => !this.pictures.has(example));
    if (!pose || this.dragging.active || !context.performance) return false;
    const targets = this.poses.targetsOf(pose);
    if (!targets) return false;
    // A drag takes a few iterations from where the last one left the surface; a picture wants the end of it.
    for (let k = 0; k < 4; k++) {
      const frame = await context.workspace.drag(targets, k === 0);
      if (this.dragging.active) return false;
      if (k === 3) this.pictures.set(pose, stage.thumbnail(frame.shape, SIZE));
    }
    context.signals.tell("thumbnails");
    return true;
  }
}
