import type { Example } from "../../document/types";
import { EngineError } from "../../engine/types";
import type { Session } from "./session";

const SIZE = 80;

/** Small pictures of the rest shape and of each pose, made while nobody drags. */
export class Thumbnails {
  rest: string | null = null;
  private pictures = new WeakMap<Example, string>();
  private working = false;

  constructor(private readonly session: Session) {}

  of(pose: Example): string | null {
    return this.pictures.get(pose) ?? null;
  }

  /** The mesh changed: no picture is true any more. */
  reset(restPositions: Float32Array): void {
    this.pictures = new WeakMap();
    this.rest = this.session.viewport?.thumbnail(restPositions, SIZE) ?? null;
    this.session.emit("thumbs", undefined);
  }

  /** Makes what is missing, one by one. */
  async update(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      for (;;) {
        const { session } = this;
        const pose = session.document.examples.find((example) => !this.pictures.has(example));
        if (!pose || !session.viewport || session.drag || session.solving || !session.performance) return;
        const targets = session.targetsOf(pose);
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
