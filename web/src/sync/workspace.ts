// One document and one engine, kept in step: a change re-runs the least that lies behind it, the newest change wins, and a
// lost engine is replaced and told everything again.

import type { ProjectDocument } from "../document/types";
import { EngineError } from "../engine/types";
import type { CallOptions, Engine, Frame, MeshReport, Motion, Performance, ShapeAnalysis, ShapedFrame } from "../engine/types";
import { Emitter } from "../util/emitter";
import { Binding, sameMesh, type Parts, type TakenMesh, type TakenMotion } from "./binding";
import { FrameCache } from "./frame-cache";
import { Library } from "./library";
import type { SolverModel } from "./placement";

/** Frames that are asked for at once: where the playhead is counts for the next. */
const PORTION = 60;

export interface WorkspaceEvents {
  /** The engine holds the document's mesh now. */
  mesh: MeshReport;
  motion: Motion;
  /** The dance was solved; its frames follow. Null: there is nothing to solve. */
  performance: Performance | null;
  /** A frame of the present dance is there. */
  frame: number;
  /** Solving or baking began or ended. */
  busy: boolean;
  /** The document asks for something that the engine cannot do. */
  failed: EngineError;
  /** The engine was lost and is back with everything it knew. */
  recovered: void;
}

/** What the engine says of a document that it took. */
export interface Taken {
  report: MeshReport | null;
  motion: Motion | null;
}

export class Workspace extends Emitter<WorkspaceEvents> {
  report: MeshReport | null = null;
  motion: Motion | null = null;
  performance: Performance | null = null;
  private binding: Binding;
  /** What of the binding the listeners were told. */
  private told: { mesh: TakenMesh | null; motion: TakenMotion | null } = { mesh: null, motion: null };
  private chain: Promise<void> = Promise.resolve();
  private queued = false;
  private abort = new AbortController();
  /** A solve and its first frame are let finish, or steady changes would starve them. */
  private interruptible = true;
  private running = false;
  private baking = false;
  private held = false;
  private focusFrame = 0;
  private closed = false;

  /** `document` tells the present one; call `sync` after each change. */
  constructor(
    private readonly document: () => ProjectDocument,
    readonly createEngine: () => Engine,
    readonly library = new Library(),
    readonly cache = new FrameCache(),
  ) {
    super();
    this.binding = new Binding(createEngine());
  }

  /** The model that was told last. */
  get model(): SolverModel | null {
    return this.told.mesh?.model ?? null;
  }

  /** Brings the engine to the present document. Resolves when that or a newer document has been solved and baked. */
  sync(): Promise<void> {
    if (this.interruptible) this.abort.abort();
    if (!this.queued) {
      this.queued = true;
      this.chain = this.chain.then(() => {
        this.queued = false;
        return this.run();
      });
    }
    return this.chain;
  }

  /**
   * Lets the engine take a document's mesh, points and motion, before it becomes the present one. On failure everything stays.
   * Answers what the engine says of them. Rejects with EngineError: bad_mesh, bad_controls, bad_motion, cancelled.
   */
  tryOn(candidate: ProjectDocument, signal?: AbortSignal, onProgress?: (done: number) => void): Promise<Taken> {
    this.abort.abort();
    const result = this.chain.then(async () => {
      const call = (): CallOptions => ({ ...(signal && { signal }), ...(onProgress && { onProgress }) });
      await this.recovering(() => this.binding.take(candidate, this.partsOf(candidate), call));
      const { mesh, motion } = this.binding;
      return { report: mesh?.report ?? null, motion: motion?.motion ?? null };
    });
    this.chain = result.then(
      () => undefined,
      () => void this.sync(),
    );
    return result;
  }

  /** What a model says of itself, in its file's axes and units. Rejects with EngineError: bad_mesh, engine_lost. */
  async analyseShape(model: SolverModel): Promise<ShapeAnalysis> {
    const { shapeInput } = await import("./shape-input");
    return this.binding.engine.analyseShape(shapeInput(model));
  }

  /** C x 3: how the dance turns the points at a frame; null: not at all. */
  turnsAt(frame: number): Float32Array | null {
    const size = 3 * this.document().points.length;
    return this.performance?.turns?.slice(frame * size, (frame + 1) * size) ?? null;
  }

  /** Deforms body-locally towards C x 3 targets, with such turns. Rejects with "superseded" when a newer drag overtakes it. */
  drag(targets: Float32Array, restart: boolean, turns: Float32Array | null = null): Promise<ShapedFrame> {
    return this.binding.engine.drag(targets, { volume: this.document().settings.volume, restart, turns });
  }

  /** Where the playhead is: missing frames are made in the order in which it meets them. */
  focus(frame: number): void {
    const jumped = Math.abs(frame - this.focusFrame) > 4;
    this.focusFrame = frame;
    if (!this.cache.follow(frame) || this.held || !this.interruptible) return;
    if (this.running ? this.baking && jumped && !this.cache.isFresh(frame) : this.performance !== null) void this.sync();
  }

  /**
   * Every frame of the present dance by its vertices, as files hold them; what plays waits for it. Rejects with EngineError:
   * cancelled, or what the document asks for cannot be done.
   */
  vertexFrames(call: CallOptions): Promise<Frame[]> {
    return this.alone(async () => {
      let frames: Frame[] = [];
      await this.recovering(async () => {
        const document = this.document();
        const signal = call.signal ?? new AbortController().signal;
        await this.binding.take(document, this.partsOf(document), () => ({ signal }));
        this.announce();
        await this.solve(document, signal);
        frames = await this.allFrames(this.performance?.frames ?? 0, call);
      });
      return frames;
    });
  }

  /**
   * The same of other documents, one after the other, each told with its motion; null where `fits` says that it is none for it.
   * Rejects likewise.
   */
  eachDance(
    documents: readonly ProjectDocument[],
    fits: (document: ProjectDocument, motion: Motion) => boolean,
    take: (n: number, frames: Frame[] | null) => void,
    callFor: (n: number) => CallOptions,
  ): Promise<void> {
    return this.alone(async () => {
      for (const [n, document] of documents.entries()) {
        const { signal, ...call } = callFor(n);
        const quiet = (): CallOptions => (signal ? { signal } : {});
        let frames: Frame[] | null = null;
        await this.recovering(async () => {
          const parts = this.partsOf(document);
          if (!parts.motion) throw new EngineError("bad_motion", `${document.motion.files.at(-1)} is not there.`);
          const motion = await this.binding.takeMotion(document, parts.motion, quiet);
          if (!fits(document, motion)) return;
          await this.binding.take(document, parts, quiet);
          const { frames: count } = await this.binding.solve(document, quiet);
          frames = await this.allFrames(count, { ...call, ...quiet() });
        });
        take(n, frames);
      }
    });
  }

  private async allFrames(count: number, call: CallOptions): Promise<Frame[]> {
    const frames: Frame[] = [];
    const order = Array.from({ length: count }, (_, f) => f);
    await this.binding.frames(
      order,
      (index, frame) => (frames[index] = frame),
      () => call,
    );
    return frames;
  }

  /** Work for which baking stops. */
  private alone<T>(work: () => Promise<T>): Promise<T> {
    this.abort.abort();
    const result = this.chain.then(work);
    const goOn = (): void => {
      this.interruptible = true;
      void this.sync();
    };
    this.chain = result.then(goOn, goOn);
    return result;
  }

  /** Stops baking while the hand needs the engine. */
  hold(): void {
    this.held = true;
    if (this.interruptible) this.abort.abort();
  }

  release(): void {
    this.held = false;
    void this.sync();
  }

  close(): void {
    this.closed = true;
    this.abort.abort();
    this.binding.engine.close();
  }

  private async run(): Promise<void> {
    if (this.closed) return;
    this.abort = new AbortController();
    this.running = true;
    this.emit("busy", true);
    try {
      await this.recovering(() => this.step(this.document(), this.abort.signal));
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (error.code !== "cancelled" && error.code !== "superseded" && !this.closed) this.emit("failed", error);
    } finally {
      this.interruptible = true;
      this.running = false;
      if (!this.queued) this.emit("busy", false);
    }
  }

  /** Does the work; if the engine dies under it, once more with a new one. */
  private async recovering(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      if (!(error instanceof EngineError) || error.code !== "engine_lost" || this.closed) throw error;
      this.binding.engine.close();
      this.binding = new Binding(this.createEngine());
      await work();
      this.emit("recovered", undefined);
    }
  }

  private async step(document: ProjectDocument, signal: AbortSignal): Promise<void> {
    await this.binding.take(document, this.partsOf(document), () => ({ signal }));
    this.announce();
    await this.solve(document, signal);
    await this.bake(signal);
  }

  private partsOf({ mesh, motion }: ProjectDocument): Parts {
    return { model: this.library.model(mesh.file), motion: this.library.motion(motion.files) };
  }

  /** Tells what has changed in the engine since the last time, once its document is the present one. */
  private announce(): void {
    const { told } = this;
    const { mesh, motion } = this.binding;
    this.told = { mesh, motion };
    if (mesh && (told.mesh?.model !== mesh.model || !sameMesh(told.mesh.mesh, mesh.mesh))) {
      this.report = mesh.report;
      this.cache.clear();
      this.performance = null;
      this.emit("mesh", this.report);
    }
    if (motion && told.motion !== motion) {
      this.motion = motion.motion;
      this.emit("motion", this.motion);
    }
  }

  private async solve(document: ProjectDocument, signal: AbortSignal): Promise<void> {
    const { model } = this.partsOf(document);
    if (!model || !this.motion || document.points.length === 0) {
      if (this.performance) {
        this.performance = null;
        this.cache.clear();
        this.emit("performance", null);
      }
      return;
    }
    if (this.performance && this.binding.isSolved(document)) return;
    if (signal.aborted) throw new EngineError("cancelled", "Cancelled.");
    this.interruptible = false;
    const { frames } = this.motion;
    const onLook = (frame: ShapedFrame): void => {
      this.cache.expire(frames);
      this.cache.put(0, frame);
      this.emit("frame", this.focusFrame);
    };
    this.performance = await this.binding.solve(document, undefined, this.performance?.frames === frames ? undefined : onLook);
    this.cache.expire(this.performance.frames);
    this.emit("performance", this.performance);
  }

  private async bake(signal: AbortSignal): Promise<void> {
    let first = true;
    const onFrame = (index: number, frame: ShapedFrame): void => {
      this.cache.put(index, frame);
      this.emit("frame", index);
      if (first && !this.interruptible) {
        first = false;
        this.interruptible = true;
        if (this.queued || this.held) this.abort.abort();
      }
    };
    this.baking = true;
    try {
      while (!this.held && this.cache.staleCount > 0) {
        const next = this.cache.todo(this.focusFrame).slice(0, PORTION);
        await this.binding.shapes(next, onFrame, () => ({ signal }));
      }
    } finally {
      this.baking = false;
    }
  }
}
