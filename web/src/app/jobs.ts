import { Emitter } from "../util/emitter";

export interface Job {
  title: string;
  /** Named steps in order; the one at `step` is under way. */
  steps: readonly string[];
  step: number;
  /** 0..1 of the step under way, or null while it has no measure. */
  done: number | null;
  cancel: () => void;
}

export interface JobHandle {
  readonly signal: AbortSignal;
  /** Moves to a named step. */
  step(index: number): void;
  progress(done: number): void;
}

const PATIENCE_MS = 700;

/** Long work under way. A job is shown only once it has lasted a while. */
export class Jobs extends Emitter<{ change: void }> {
  private list: (Job & { shown: boolean })[] = [];

  get shown(): readonly Job[] {
    return this.list.filter((job) => job.shown);
  }

  /** Runs the work with a card that can cancel it. Rejects as the work does. */
  async run<T>(title: string, steps: readonly string[], work: (job: JobHandle) => Promise<T>): Promise<T> {
    const abort = new AbortController();
    const job = { title, steps, step: 0, done: null as number | null, cancel: () => abort.abort(), shown: false };
    this.list = [...this.list, job];
    const timer = setTimeout(() => {
      job.shown = true;
      this.emit("change", undefined);
    }, PATIENCE_MS);
    const changed = (): void => {
      if (job.shown) this.emit("change", undefined);
    };
    try {
      return await work({
        signal: abort.signal,
        step: (index) => {
          job.step = index;
          job.done = null;
          changed();
        },
        progress: (done) => {
          job.done = done;
          changed();
        },
      });
    } finally {
      clearTimeout(timer);
      this.list = this.list.filter((other) => other !== job);
      this.emit("change", undefined);
    }
  }
}
