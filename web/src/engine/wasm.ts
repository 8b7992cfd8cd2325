// Loads the bare rigless.wasm. It needs no script of its own: two imports, one initialiser.

type Pointer = number;
/** 0: ok; otherwise error * 2^32 + where (math/status.h). */
export type PackedStatus = number;
/** Index and generation; 0 is none. */
export type Handle = number;

/** wasm/surface.cpp, motion.cpp and performance.cpp say what each one does. */
export interface RiglessExports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  alloc(bytes: number): Pointer;
  release(at: Pointer): void;

  body_new(): Handle;
  body_delete(body: Handle): void;
  body_set_mesh(body: Handle, positions: Pointer, vertices: number, faces: Pointer, faceCount: number): PackedStatus;
  body_report(body: Handle, out: Pointer): void;
  body_set_controls(body: Handle, vertices: Pointer, radii: Pointer, count: number): PackedStatus;
  body_drag(body: Handle, targets: Pointer, count: number, volume: number, restart: number): PackedStatus;
  body_positions(body: Handle): Pointer;
  body_volume_ratio(body: Handle): number;
  body_rest_controls(body: Handle): Pointer;

  bake_new(): Handle;
  bake_delete(bake: Handle): void;
  bake_begin(
    bake: Handle,
    body: Handle,
    frames: number,
    controls: Pointer,
    yaw: Pointer,
    travel: Pointer,
    flights: Pointer,
    flightCount: number,
    volume: number,
  ): void;
  bake_frame(bake: Handle, frame: number): PackedStatus;
  bake_positions(bake: Handle): Pointer;
  bake_root(bake: Handle, out: Pointer): void;

  motion_new(): Handle;
  motion_delete(motion: Handle): void;
  motion_read_bvh(motion: Handle, text: Pointer, bytes: number): PackedStatus;
  motion_read_asf(motion: Handle, text: Pointer, bytes: number): PackedStatus;
  motion_read_amc(motion: Handle, text: Pointer, bytes: number): PackedStatus;
  motion_info(motion: Handle, out: Pointer): void;
  motion_notes(motion: Handle, out: Pointer): void;
  motion_name(motion: Handle, joint: number): Pointer;
  motion_name_bytes(motion: Handle, joint: number): number;
  motion_parents(motion: Handle): Pointer;
  motion_positions(motion: Handle): Pointer;
  motion_local(motion: Handle): Pointer;
  motion_yaw(motion: Handle): Pointer;

  performance_new(): Handle;
  performance_delete(performance: Handle): void;
  performance_place(performance: Handle, control: number, frame: number, axes: number, x: number, y: number, z: number): void;
  performance_still(performance: Handle, control: number, frame: number): void;
  performance_stand(performance: Handle, control: number, begin: number, end: number): void;
  performance_fly(performance: Handle, flights: Pointer, count: number): void;
  performance_mirror(performance: Handle, partners: Pointer, controls: number, x: number, y: number, z: number): void;
  performance_begin(
    performance: Handle,
    motion: Handle,
    pairs: Pointer,
    rest: Pointer,
    controls: number,
    floor: number,
    height: number,
    exampleJoints: Pointer,
    exampleControls: Pointer,
    examples: number,
    smoothness: number,
    groundContact: number,
    inPlace: number,
  ): PackedStatus;
  performance_advance(performance: Handle): PackedStatus;
  performance_progress(performance: Handle): number;
  performance_info(performance: Handle, out: Pointer): void;
  performance_controls(performance: Handle): Pointer;
  performance_contacts(performance: Handle): Pointer;
  performance_flights(performance: Handle): Pointer;
  performance_yaw(performance: Handle): Pointer;
  performance_travel(performance: Handle): Pointer;
  performance_source_contacts(performance: Handle): Pointer;
  performance_missed(performance: Handle): Pointer;
  performance_opponents(performance: Handle): Pointer;
  performance_coverage(performance: Handle): Pointer;
  performance_asks(performance: Handle, out: Pointer): void;
}

/** wasm/understanding.cpp */
export interface ShapeAnalysisExports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  alloc(bytes: number): Pointer;
  analyse_shape(positions: Pointer, vertices: number, faces: Pointer, faceCount: number, out: Pointer): PackedStatus;
}

const IMPORTS = {
  env: { emscripten_notify_memory_growth: () => {} },
  wasi_snapshot_preview1: {
    proc_exit: (code: number) => {
      throw new WebAssembly.RuntimeError(`the core stopped with code ${code}`);
    },
  },
};

/** At once, as only a worker may; for a small module that is used and dropped. */
export function instantiateShapeAnalysis(bytes: ArrayBuffer): ShapeAnalysisExports {
  const module = new WebAssembly.Instance(new WebAssembly.Module(bytes), IMPORTS).exports as unknown as ShapeAnalysisExports;
  module._initialize();
  return module;
}

export async function instantiate(bytes: ArrayBuffer): Promise<RiglessExports> {
  const { instance } = await WebAssembly.instantiate(bytes, IMPORTS);
  const core = instance.exports as unknown as RiglessExports;
  core._initialize();
  return core;
}
