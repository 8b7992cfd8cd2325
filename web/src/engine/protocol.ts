// What crosses the port between the page and the engine's worker.

import type {
  ControlInput,
  EngineErrorCode,
  Frame,
  BoundMeshInput,
  MeshInput,
  MeshReport,
  Motion,
  MotionInput,
  Performance,
  RetargetInput,
  ShapeAnalysis,
} from "./types";

export interface DragInput {
  targets: Float32Array;
  volume: number;
  restart: boolean;
}

export interface ShapeAnalysisInput {
  mesh: MeshInput;
  /** The bytes of shape-analysis.wasm. */
  wasm: ArrayBuffer;
}

export interface Calls {
  setMesh: { input: BoundMeshInput; output: MeshReport };
  analyseShape: { input: ShapeAnalysisInput; output: ShapeAnalysis };
  setControls: { input: ControlInput[]; output: void };
  setMotion: { input: MotionInput; output: Motion };
  drag: { input: DragInput; output: Frame };
  retarget: { input: RetargetInput; output: Performance };
  frames: { input: Uint32Array; output: void };
}

export type CallName = keyof Calls;

export type CallRequest = { [K in CallName]: { type: K; id: number; input: Calls[K]["input"] } }[CallName];

export type Request =
  /** First of all: the bytes of rigless.wasm. */
  { type: "load"; bytes: ArrayBuffer } | CallRequest | { type: "cancel"; id: number };

export type Reply =
  | { type: "done"; id: number; value: unknown }
  | { type: "failed"; id: number; code: EngineErrorCode; message: string }
  | { type: "progress"; id: number; done: number }
  | { type: "frame"; id: number; frame: number; result: Frame }
  /** The last word of a worker: it cannot go on. */
  | { type: "lost"; message: string };
