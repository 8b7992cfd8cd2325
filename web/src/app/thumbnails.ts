import type { Example } from "../document/types";
import { EngineError } from "../engine/types";
import type { Session } from "./session";

const SIZE = 80;
/** The first moments belong to the dance: a picture that is read back stops the graphics card. */
const AFTER_OPENING_MS = 1500;

/** Small pictures of the rest shape and of each pose, made while nobody drags. */
export class Thumbnails {
  rest: string | null = null;
  private pictures = new WeakMap<Example, string>();
  private restPositions: Float32Array | null = null;
  private working = false;
  private readonly opened = new Promise((resolve) => setTimeout(resolve, AFTER_OPENING_MS));

  constructor(private readonly session: Session) {}

  of(pose: Example): string | null {
    return this.pictures.get(pose) ?? null;
  }

  /** The mesh changed: no picture is true any more. */
  reset(restPositions: Float32Array): void {
    this.pictures = new WeakMap();
    this.restPositions = restPositions;
    this.rest = null;
    this.session.emit("thumbs", undefined);
    void this.update();
  }

  /** Makes what is missing, one by one. */
  async update(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      await this.opened;
      for (;;) {
        await idle();
        const { session } = this;
        if (session.solving) return;
        if (this.rest === null && this.restPositions && session.viewport) {
          this.rest = session.viewport.thumbnail(this.restPositions, SIZE);
          session.emit("thumbs", undefined);
          continue;
        }
        const pose = session.document.examples.find((example) => !this.pictures.has(example));
        if (!pose || !session.viewport || session.drag || !session.performance) return;
        const targets = session.poses.targetsOf(pose);
        if (!targets) return;
        // A drag takes a few iterations from where the last one left the surface; a picture wants the end of it.
        for (let k = 0; k < 4; k++) {
          const frame = await session.workspace.drag(targets, k === 0);
          if (session.drag) return;
          if (k === 3) this.pictures.set(pose, session.viewport.thumbnail(frame.positions, SIZE));
        }
        session.emit("thumbs", undefined);
      }
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
    } finally {
      this.working = false;
    }
  }
}

/** Pictures cost the graphics card; the dance comes first. */
function idle(): Promise<void> {
  return new Promise((resolve) => {
    if ("requestIdleCallback" in window) requestIdleCallback(() => resolve(), { timeout: 250 });
    else setTimeout(resolve, 100);
  });
}
