// The worker's side: hears requests, runs them in slices, answers. Between two slices it listens, so a cancel or
// a newer drag never waits longer than a slice.

import { Core } from "./core";
import type { CallRequest, Reply, Request } from "./protocol";
import { Refusal } from "./refusal";
import { EngineError, type Frame, type ShapedFrame } from "./types";
import { analyseShape } from "./analyse-shape";
import { instantiate } from "./wasm";

/** A DedicatedWorkerGlobalScope or a MessagePort. */
export interface ServerPort {
  postMessage(message: Reply, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<Request>) => void) | null;
}

type DragRequest = Extract<CallRequest, { type: "drag" }>;
type JobRequest = Exclude<CallRequest, DragRequest>;
type Steps = Generator<number, unknown, void>;

const SLICE_MILLISECONDS = 8;

/**
 * Serves a port until the returned function is called or the core is lost. `turn` resolves when the messages that have
 * arrived were heard.
 */
export function serve(port: ServerPort, turn: () => Promise<void>): () => void {
  const server = new Server(port, turn);
  port.onmessage = (event) => server.hear(event.data);
  return () => server.stop();
}

class Server {
  #core: Core | null = null;
  #queue: JobRequest[] = [];
  #active: { request: JobRequest; steps: Steps } | null = null;
  /** One slot: the newest drag that has not begun. */
  #drag: DragRequest | null = null;
  #running = false;
  #stopped = false;

  constructor(
    readonly port: ServerPort,
    readonly turn: () => Promise<void>,
  ) {}

  hear(request: Request): void {
    if (this.#stopped) return;
    switch (request.type) {
      case "load":
        void this.#load(request.bytes);
        return;
      case "cancel":
        this.#cancel(request.id);
        return;
      case "drag":
        if (this.#drag) this.#fail(this.#drag.id, new EngineError("superseded", "A newer drag took its place."));
        this.#drag = request;
        break;
      default:
        this.#queue.push(request);
    }
    void this.#run();
  }

  stop(): void {
    this.#stopped = true;
    this.port.onmessage = null;
  }

  async #load(bytes: ArrayBuffer): Promise<void> {
    try {
      this.#core = new Core(await instantiate(bytes));
    } catch (error) {
      this.#lose(error);
      return;
    }
    void this.#run();
  }

  async #run(): Promise<void> {
    if (this.#running || !this.#core) return;
    this.#running = true;
    try {
      while (!this.#stopped && this.#step(this.#core)) await this.turn();
    } catch (error) {
      this.#lose(error);
    }
    this.#running = false;
  }

  /** One slice of the most urgent work; false when there is none. */
  #step(core: Core): boolean {
    const drag = this.#drag;
    if (drag && !this.#waitsForJob(drag)) {
      this.#drag = null;
      this.#attempt(drag.id, () => this.#done(drag.id, core.drag(drag.input)));
      return true;
    }
    if (!this.#active) {
      const request = this.#queue.shift();
      if (!request) return false;
      this.#active = { request, steps: this.#begin(core, request) };
    }
    this.#advance(this.#active);
    return true;
  }

  /** A drag overtakes retargeting and frames, but never the mesh and the controls it was made for. */
  #waitsForJob(drag: DragRequest): boolean {
    const jobs = this.#active ? [this.#active.request, ...this.#queue] : this.#queue;
    return jobs.some((job) => job.id < drag.id && (job.type === "setMesh" || job.type === "setControls"));
  }

  #advance(active: { request: JobRequest; steps: Steps }): void {
    const { id } = active.request;
    const end = performance.now() + SLICE_MILLISECONDS;
    const survived = this.#attempt(id, () => {
      let step = active.steps.next();
      while (!step.done && performance.now() < end) step = active.steps.next();
      if (step.done) {
        this.#active = null;
        this.#done(id, step.value);
      } else {
        this.#post({ type: "progress", id, done: step.value });
      }
    });
    if (!survived) this.#active = null;
  }

  *#begin(core: Core, request: JobRequest): Steps {
    const emit = (frame: number, result: Frame | ShapedFrame): void =>
      this.#post({ type: "frame", id: request.id, frame, result }, buffersOf(result));
    switch (request.type) {
      case "setMesh":
        return core.setMesh(request.input);
      case "analyseShape":
        return analyseShape(request.input);
      case "setControls":
        return core.setControls(request.input);
      case "setMotion":
        return core.setMotion(request.input);
      case "retarget":
        return yield* core.retarget(request.input, emit);
      case "frames":
        return yield* core.frames(request.input, emit);
    }
  }

  #cancel(id: number): void {
    const waiting = this.#queue.findIndex((request) => request.id === id);
    if (waiting >= 0) this.#queue.splice(waiting, 1);
    else if (this.#active?.request.id === id) this.#abandon(this.#active.steps);
    else return;
    this.#fail(id, new EngineError("cancelled", "Cancelled."));
  }

  /** Lets the call free what it has begun. */
  #abandon(steps: Steps): void {
    this.#active = null;
    steps.return(undefined);
  }

  /** A Refusal or an EngineError answers the call; anything else (a trap, a bug) ends the worker. */
  #attempt(id: number, work: () => void): boolean {
    try {
      work();
      return true;
    } catch (error) {
      if (error instanceof Refusal) this.#post({ type: "refused", id, packed: error.packed, subject: error.subject });
      else if (error instanceof EngineError) this.#fail(id, error);
      else throw error;
      return false;
    }
  }

  #done(id: number, value: unknown): void {
    this.#post({ type: "done", id, value }, buffersOf(value));
  }

  #fail(id: number, error: EngineError): void {
    this.#post({ type: "failed", id, code: error.code, message: error.message });
  }

  #lose(error: unknown): void {
    this.#post({ type: "lost", message: error instanceof Error ? error.message : String(error) });
    this.stop();
  }

  #post(reply: Reply, transfer: Transferable[] = []): void {
    this.port.postMessage(reply, transfer);
  }
}

/** The arrays of an answer are the core's copies and go to the receiver. */
function buffersOf(value: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(buffersOf) : [];
}
