// The page's side of the port: every call a promise, every failure an EngineError.

import type { CallName, Calls, Reply, Request } from "./protocol";
import { EngineError } from "./types";
import type {
  CallOptions,
  ControlInput,
  DragOptions,
  Engine,
  Frame,
  BoundMeshInput,
  MeshReport,
  Motion,
  MotionInput,
  Performance,
  RetargetInput,
  ShapeAnalysis,
  ShapedFrame,
  ShapeInput,
} from "./types";

/** A Worker, or what stands for one in Node. */
export interface WorkerPort {
  postMessage(message: Request, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

interface Pending {
  resolve(value: unknown): void;
  reject(error: EngineError): void;
  onProgress?: ((done: number) => void) | undefined;
  onFrame?: ((frame: number, result: Frame | ShapedFrame) => void) | undefined;
}

export class EngineClient implements Engine {
  #port: WorkerPort;
  #pending = new Map<number, Pending>();
  #lastId = 0;
  #lost: EngineError | null = null;

  /** `wasm`: the bytes of rigless.wasm; taken over. `shapeAnalysisWasm` gets those of shape-analysis.wasm when they are needed. */
  constructor(
    port: WorkerPort,
    wasm: ArrayBuffer | Promise<ArrayBuffer>,
    readonly shapeAnalysisWasm: () => Promise<ArrayBuffer>,
  ) {
    this.#port = port;
    port.onmessage = (event) => this.#hear(event.data);
    port.onerror = (event) => this.lose(`The engine stopped: ${event.message || "its worker could not run"}.`);
    port.onmessageerror = () => this.lose("The engine stopped: its answer could not be read.");
    Promise.resolve(wasm).then(
      (bytes) => this.#post({ type: "load", bytes }, [bytes]),
      (error: unknown) => this.lose(`The engine could not be loaded: ${String(error)}.`),
    );
  }

  async setMesh(mesh: BoundMeshInput, options?: CallOptions): Promise<MeshReport> {
    const wasm = mesh.solve === "solid" ? await this.#shapeAnalysis() : null;
    return this.#call("setMesh", { mesh, wasm }, options);
  }

  async analyseShape(mesh: ShapeInput, options?: CallOptions): Promise<ShapeAnalysis> {
    return this.#call("analyseShape", { mesh, wasm: await this.#shapeAnalysis() }, options);
  }

  setControls(controls: ControlInput[], options?: CallOptions): Promise<void> {
    return this.#call("setControls", controls, options);
  }

  setMotion(motion: MotionInput, options?: CallOptions): Promise<Motion> {
    return this.#call("setMotion", motion, options);
  }

  drag(targets: Float32Array, { volume, restart = false, turns = null }: DragOptions): Promise<ShapedFrame> {
    return this.#call("drag", { targets, turns, volume, restart });
  }

  retarget(input: RetargetInput, options?: CallOptions, onLook?: (frame: ShapedFrame) => void): Promise<Performance> {
    return this.#call("retarget", { ...input, look: !!onLook }, options, (_, frame) => onLook?.(frame as ShapedFrame));
  }

  frames(order: ArrayLike<number>, onFrame: (frame: number, result: Frame) => void, options?: CallOptions): Promise<void> {
    return this.#frames(order, false, (frame, result) => onFrame(frame, result as Frame), options);
  }

  shapes(order: ArrayLike<number>, onShape: (frame: number, result: ShapedFrame) => void, options?: CallOptions): Promise<void> {
    return this.#frames(order, true, (frame, result) => onShape(frame, result as ShapedFrame), options);
  }

  close(): void {
    this.lose("The engine was closed.");
  }

  #frames(order: ArrayLike<number>, shaped: boolean, onFrame: NonNullable<Pending["onFrame"]>, options?: CallOptions): Promise<void> {
    return this.#call("frames", { order: Uint32Array.from(order), shaped }, options, (frame, result) => {
      if (!options?.signal?.aborted) onFrame(frame, result);
    });
  }

  #shapeAnalysis(): Promise<ArrayBuffer> {
    return this.shapeAnalysisWasm().catch((error: unknown) => {
      throw new EngineError("bad_mesh", `What looks at models could not be loaded: ${String(error)}.`);
    });
  }

  #call<K extends CallName>(
    type: K,
    input: Calls[K]["input"],
    options?: CallOptions,
    onFrame?: Pending["onFrame"],
  ): Promise<Calls[K]["output"]> {
    const signal = options?.signal;
    if (this.#lost) return Promise.reject(this.#lost);
    if (signal?.aborted) return Promise.reject(new EngineError("cancelled", "Cancelled."));
    const id = ++this.#lastId;
    const cancel = () => this.#post({ type: "cancel", id });
    return new Promise<Calls[K]["output"]>((resolve, reject) => {
      this.#pending.set(id, { resolve: (value) => resolve(value as Calls[K]["output"]), reject, onProgress: options?.onProgress, onFrame });
      signal?.addEventListener("abort", cancel, { once: true });
      this.#post({ type, id, input } as Request);
    }).finally(() => signal?.removeEventListener("abort", cancel));
  }

  #hear(reply: Reply): void {
    if (reply.type === "lost") {
      this.lose(`The engine stopped: ${reply.message}.`);
      return;
    }
    const call = this.#pending.get(reply.id);
    if (!call) return;
    switch (reply.type) {
      case "progress":
        call.onProgress?.(reply.done);
        return;
      case "frame":
        call.onFrame?.(reply.frame, reply.result);
        return;
      case "done":
        this.#pending.delete(reply.id);
        call.resolve(reply.value);
        return;
      case "refused": {
        const { id, packed, subject } = reply;
        this.#pending.delete(id);
        import("./messages").then(
          ({ engineError }) => call.reject(engineError(packed, subject)),
          () => call.reject(new EngineError("engine_lost", "The page is not whole: reload it.")),
        );
        return;
      }
      case "failed":
        this.#pending.delete(reply.id);
        call.reject(new EngineError(reply.code, reply.message));
    }
  }

  /** Nothing more will come: every pending call, and every later one, rejects with engine_lost. */
  lose(message: string): void {
    if (this.#lost) return;
    this.#lost = new EngineError("engine_lost", message);
    this.#port.terminate();
    for (const call of this.#pending.values()) call.reject(this.#lost);
    this.#pending.clear();
  }

  #post(message: Request, transfer: Transferable[] = []): void {
    if (!this.#lost) this.#port.postMessage(message, transfer);
  }
}
