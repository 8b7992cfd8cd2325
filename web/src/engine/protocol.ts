// What crosses the port between the page and the engine's worker.

import type { PackedStatus } from "./abi";
import type { Subject } from "./messages";
import type {
  BoundMeshInput,
  ControlInput,
  EngineErrorCode,
  Frame,
  MeshReport,
  Motion,
  MotionInput,
  Performance,
  RetargetInput,
  ShapeAnalysis,
  ShapedFrame,
  ShapeInput,
} from "./types";

export interface DragInput {
  targets: Float32Array;
  turns: Float32Array | null;
  volume: number;
  restart: boolean;
}

export interface SetMeshInput {
  mesh: BoundMeshInput;
  /** The bytes of shape-analysis.wasm, if a solid is to be built. */
  wasm: ArrayBuffer | null;
}

export interface FramesInput {
  order: Uint32Array;
  /** As they are drawn, instead of all vertices. */
  shaped: boolean;
}

export interface ShapeAnalysisInput {
  mesh: ShapeInput;
  /** The bytes of shape-analysis.wasm. */
  wasm: ArrayBuffer;
}

export interface Calls {
  setMesh: { input: SetMeshInput; output: MeshReport };
  analyseShape: { input: ShapeAnalysisInput; output: ShapeAnalysis };
  setControls: { input: ControlInput[]; output: void };
  setMotion: { input: MotionInput; output: Motion };
  drag: { input: DragInput; output: ShapedFrame };
  retarget: { input: RetargetInput & { look: boolean }; output: Performance };
  frames: { input: FramesInput; output: void };
}

export type CallName = keyof Calls;

export type CallRequest = { [K in CallName]: { type: K; id: number; input: Calls[K]["input"] } }[CallName];

export type Request =
  /** First of all: the bytes of rigless.wasm. */
  { type: "load"; bytes: ArrayBuffer } | CallRequest | { type: "cancel"; id: number };

export type Reply =
  | { type: "done"; id: number; value: unknown }
  | { type: "failed"; id: number; code: EngineErrorCode; message: string }
  /** By the core. */
  | { type: "refused"; id: number; packed: PackedStatus; subject: Subject }
  | { type: "progress"; id: number; done: number }
  | { type: "frame"; id: number; frame: number; result: Frame | ShapedFrame }
  /** The last word of a worker: it cannot go on. */
  | { type: "lost"; message: string };
