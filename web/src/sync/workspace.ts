// One document and one engine, kept in step: a change re-runs the least that lies behind it, the newest change wins, and a
// lost engine is replaced and told everything again.

import { clipOf } from "../document/clips";
import type { ProjectDocument } from "../document/types";
import { EngineError } from "../engine/types";
import type { Engine, Frame, MeshReport, Motion, MotionInput, Performance, ShapeAnalysis } from "../engine/types";
import { Emitter } from "../util/emitter";
import { FrameCache } from "./frame-cache";
import { Library } from "./library";
import { controlInputs, meshInput, retargetInput } from "./prepare";
import type { SolverModel } from "./prepare";

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

/** What the engine holds, by identity of the document's parts. */
interface Bound {
  model: SolverModel | null;
  mesh: ProjectDocument["mesh"] | null;
  points: string | null;
  motion: MotionInput | null;
  solved: readonly unknown[] | null;
}

/** What the engine says of a document that it took. */
export interface Taken {
  report: MeshReport | null;
  motion: Motion | null;
}

const NOTHING: Bound = { model: null, mesh: null, points: null, motion: null, solved: null };

export class Workspace extends Emitter<WorkspaceEvents> {
  readonly library = new Library();
  readonly cache = new FrameCache();
  report: MeshReport | null = null;
  motion: Motion | null = null;
  performance: Performance | null = null;
  private engine: Engine;
  private bound: Bound = { ...NOTHING };
  private boundReport: MeshReport | null = null;
  private boundMotion: Motion | null = null;
  private announced: Bound = { ...NOTHING };
  private chain: Promise<void> = Promise.resolve();
  private queued = false;
  private abort = new AbortController();
  /** A solve and its first frame are let finish, or steady changes would starve them. */
  private interruptible = true;
  private held = false;
  private focusFrame = 0;
  private closed = false;

  /** `document` tells the present one; call `sync` after each change. */
  constructor(
    private readonly document: () => ProjectDocument,
    private readonly createEngine: () => Engine,
  ) {
    super();
    this.engine = createEngine();
  }

  /** The model that was told last. */
  get model(): SolverModel | null {
    return this.announced.model;
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
      await this.recovering(() => this.bind(candidate, signal, onProgress));
      return { report: this.boundReport, motion: this.boundMotion };
    });
    this.chain = result.then(
      () => undefined,
      () => void this.sync(),
    );
    return result;
  }

  /** What a model says of itself, in its file's axes and units. Rejects with EngineError: bad_mesh, engine_lost. */
  analyseShape({ positions, faces }: SolverModel): Promise<ShapeAnalysis> {
    return this.engine.analyseShape({ positions, faces });
  }

  /** Deforms body-locally towards C x 3 targets. Rejects with "superseded" when a newer drag overtakes it. */
  drag(targets: Float32Array, restart: boolean): Promise<Frame> {
    return this.engine.drag(targets, { volume: this.document().settings.volume, restart });
  }

  /** Where the playhead is: missing frames are made in the order in which it meets them. */
  focus(frame: number): void {
    const jumped = Math.abs(frame - this.focusFrame) > 4;
    this.focusFrame = frame;
    if (jumped && !this.held && this.cache.staleCount > 0 && !this.cache.isFresh(frame) && this.interruptible) void this.sync();
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
    this.engine.close();
  }

  private async run(): Promise<void> {
    if (this.closed) return;
    this.abort = new AbortController();
    this.emit("busy", true);
    try {
      await this.recovering(() => this.step(this.document(), this.abort.signal));
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (error.code !== "cancelled" && error.code !== "superseded" && !this.closed) this.emit("failed", error);
    } finally {
      this.interruptible = true;
      if (!this.queued) this.emit("busy", false);
    }
  }

  /** Does the work; if the engine dies under it, once more with a new one. */
  private async recovering(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      if (!(error instanceof EngineError) || error.code !== "engine_lost" || this.closed) throw error;
      this.engine.close();
      this.engine = this.createEngine();
      this.bound = { ...NOTHING };
      await work();
      this.emit("recovered", undefined);
    }
  }

  private async step(document: ProjectDocument, signal: AbortSignal): Promise<void> {
    await this.bind(document, signal);
    this.announce();
    await this.solve(document, signal);
    await this.bake(signal);
  }

  private async bind(document: ProjectDocument, signal?: AbortSignal, onProgress?: (done: number) => void): Promise<void> {
    const options = { ...(signal ? { signal } : {}), ...(onProgress ? { onProgress } : {}) };
    const { bound } = this;
    const model = this.library.model(document.mesh.file);
    if (!model) return;
    if (bound.model !== model || bound.mesh?.facing !== document.mesh.facing || bound.mesh?.up !== document.mesh.up) {
      const report = await this.engine.setMesh(meshInput(model, document.mesh), options);
      Object.assign(bound, { model, mesh: document.mesh, points: null, solved: null });
      this.boundReport = report;
    }
    const controls = controlInputs(model, document);
    const key = JSON.stringify(controls);
    if (bound.points !== key && controls.length > 0) {
      await this.engine.setControls(controls, options);
      Object.assign(bound, { points: key, solved: null });
    }
    const motion = this.library.motion(document.motion.files);
    if (motion && bound.motion !== motion) {
      this.boundMotion = await this.engine.setMotion(motion, options);
      Object.assign(bound, { motion, solved: null });
    }
  }

  /** Tells what has changed in the engine since the last time, once its document is the present one. */
  private announce(): void {
    const { bound, announced } = this;
    const turned = announced.mesh?.facing !== bound.mesh?.facing || announced.mesh?.up !== bound.mesh?.up;
    if (bound.model && this.boundReport && (announced.model !== bound.model || turned)) {
      this.report = this.boundReport;
      this.announced = { ...announced, model: bound.model, mesh: bound.mesh };
      this.cache.clear();
      this.performance = null;
      this.emit("mesh", this.report);
    }
    if (bound.motion && this.boundMotion && announced.motion !== bound.motion) {
      this.motion = this.boundMotion;
      this.emit("motion", this.motion);
    }
    this.announced = { ...bound };
  }

  private async solve(document: ProjectDocument, signal: AbortSignal): Promise<void> {
    const { bound, motion } = this;
    const model = this.library.model(document.mesh.file);
    if (!model || !motion || document.points.length === 0) {
      if (this.performance) {
        this.performance = null;
        this.cache.clear();
        this.emit("performance", null);
      }
      return;
    }
    const solved = [document.points, document.examples, document.settings, clipOf(document)] as const;
    if (this.performance && bound.solved?.every((part, k) => part === solved[k])) return;
    if (signal.aborted) throw new EngineError("cancelled", "Cancelled.");
    this.interruptible = false;
    const performance = await this.engine.retarget(retargetInput(model, document, motion));
    bound.solved = solved;
    this.performance = performance;
    this.cache.expire(performance.frames);
    this.emit("performance", performance);
  }

  private async bake(signal: AbortSignal): Promise<void> {
    if (this.held || this.cache.staleCount === 0) return;
    let first = true;
    const onFrame = (index: number, frame: Frame): void => {
      this.cache.put(index, frame);
      this.emit("frame", index);
      if (first && !this.interruptible) {
        first = false;
        this.interruptible = true;
        if (this.queued || this.held) this.abort.abort();
      }
    };
    await this.engine.frames(this.cache.todo(this.focusFrame), onFrame, { signal });
  }
}
