// The core as the server uses it: one mesh with its controls, one motion, the last performance.

import { bakeRootRow, bodyReportRow, performanceInfoRow, writeControlInput } from "./abi";
import type { BodyReport, Handle, PackedStatus, RiglessExports } from "./abi";
import { type BuiltSolid, buildSolid } from "./build-solid";
import { Heap } from "./heap";
import type { Subject } from "./messages";
import { readMotion } from "./motion";
import type { DragInput, FramesInput, SetMeshInput } from "./protocol";
import { Refusal } from "./refusal";
import { beginRetarget, describePerformance } from "./retarget";
import { EngineError } from "./types";
import type {
  BoundMeshInput,
  ControlInput,
  Frame,
  MeshReport,
  Motion,
  MotionInput,
  Performance,
  RetargetInput,
  ShapedFrame,
  SolidCells,
} from "./types";

export class Core {
  #wasm: RiglessExports;
  #heap: Heap;
  #body: Handle;
  /** Of the mesh; null before there is one. */
  #report: BodyReport | null = null;
  #vertices = 0;
  /** Of the solid that carries it; 0 where its surface is solved. */
  #nodes = 0;
  #controls = 0;
  #motion: Handle = 0;
  #motionFrames = 0;
  /** The last performance, ready to be deformed. */
  #bake: Handle = 0;

  constructor(wasm: RiglessExports) {
    this.#wasm = wasm;
    this.#heap = new Heap(wasm);
    this.#body = wasm.body_new();
  }

  setMesh({ mesh, wasm }: SetMeshInput): MeshReport {
    const { positions, faces, rigidity = null, paper } = mesh;
    if (positions.length % 3 !== 0 || faces.length % 3 !== 0) {
      throw new EngineError("bad_mesh", "The model's points and triangles do not come in threes.");
    }
    let solid: SolidCells | null = null;
    if (wasm) {
      const { first, neighbors, weights, partOf, ...cells } = buildSolid(mesh, wasm);
      this.#setSolidMesh(mesh, { ...cells, first, neighbors, weights, partOf });
      solid = cells;
    } else
      this.#heap.lend([positions, faces, rigidity], ([at, facesAt, rigidityAt]) => {
        const counts = [at, positions.length / 3, facesAt, faces.length / 3] as const;
        this.#check(this.#wasm.body_set_mesh(this.#body, ...counts, rigidityAt, Number(paper ?? 0)), { kind: "mesh" });
      });
    this.#forgetBake();
    this.#controls = 0;
    this.#vertices = positions.length / 3;
    this.#nodes = solid ? solid.nodes.length / 3 : 0;
    this.#report = this.#heap.read(bodyReportRow, this.#wasm.body_report(this.#body));
    const { floor: _, height: __, volume, ...report } = this.#report;
    return { vertices: this.#vertices, faces: faces.length / 3, volume: known(volume), ...report, solid };
  }

  #setSolidMesh({ positions, faces, paper }: BoundMeshInput, solid: BuiltSolid): void {
    const { cell, nodes, elements, elementOf, first, neighbors, weights, partOf } = solid;
    this.#heap.lend([positions, faces, nodes, elements, elementOf, first, neighbors, weights, partOf], ([at, facesAt, ...parts]) => {
      const [nodesAt, elementsAt, elementOfAt, firstAt, neighborsAt, weightsAt, partOfAt] = parts;
      const mesh = [at, positions.length / 3, facesAt, faces.length / 3] as const;
      const cells = [cell, nodesAt, nodes.length / 3, elementsAt, elements.length / 8, elementOfAt] as const;
      const edges = [firstAt, neighborsAt, weightsAt, partOfAt] as const;
      const status = this.#wasm.body_set_solid_mesh(this.#body, ...mesh, ...cells, ...edges, Number(paper ?? 0));
      this.#check(status, { kind: "mesh" });
    });
  }

  setControls(controls: ControlInput[]): void {
    if (!this.#report) throw new EngineError("bad_controls", "There is no model to place controls on yet.");
    this.#heap.lendAll(
      writeControlInput,
      controls.map((control) => ({ slab: false, onLimb: false, base: NOWHERE, bend: NOWHERE, ...control })),
      (at) => {
        this.#check(this.#wasm.body_set_controls(this.#body, at, controls.length), { kind: "controls" });
      },
    );
    this.#forgetBake();
    this.#controls = controls.length;
  }

  setMotion(input: MotionInput): Motion {
    const { handle, motion } = readMotion(this.#wasm, this.#heap, input);
    if (this.#motion) this.#wasm.motion_delete(this.#motion);
    this.#motion = handle;
    this.#motionFrames = motion.frames;
    return motion;
  }

  drag({ targets, turns, volume, restart }: DragInput): ShapedFrame {
    const begin = performance.now();
    this.#needControls();
    this.#heap.lend([targets, turns], ([at, turnsAt]) => {
      this.#check(this.#wasm.body_drag(this.#body, at, turnsAt, targets.length / 3, volume, Number(restart)), { kind: "controls" });
    });
    return {
      shape: this.#nodes
        ? this.#heap.floats(this.#wasm.body_maps(this.#body), 12 * this.#nodes)
        : this.#heap.floats(this.#wasm.body_positions(this.#body), 3 * this.#vertices),
      volumeRatio: known(this.#wasm.body_volume_ratio(this.#body)),
      root: [0, 0, 0, 0],
      milliseconds: performance.now() - begin,
    };
  }

  *retarget(input: RetargetInput & { look: boolean }, emit: Emit): Generator<number, Performance> {
    if (input.look && this.#motionFrames > LONG) {
      const beginning = this.#wasm.motion_beginning(this.#motion, BEGINNING);
      const constraints = input.constraints?.filter(({ frame }) => frame < BEGINNING);
      try {
        yield* this.#solve({ ...input, ...(constraints && { constraints }) }, beginning, () => emit(0, this.#frame(0, true)));
      } finally {
        this.#wasm.motion_delete(beginning);
      }
    }
    return yield* this.#solve(input, this.#motion, (handle, milliseconds) =>
      describePerformance(this.#wasm, this.#heap, handle, milliseconds),
    );
  }

  /** `use`: what is made of the performance while it is there; the bake stays. */
  *#solve<T>(input: RetargetInput, motion: Handle, use: (handle: Handle, milliseconds: number) => T): Generator<number, T> {
    let begin = performance.now();
    let milliseconds = 0;
    const report = this.#needControls();
    if (!motion) throw new EngineError("bad_motion", "There is no motion yet. Choose one.");
    const handle = this.#wasm.performance_new();
    try {
      beginRetarget(this.#wasm, this.#heap, handle, { body: this.#body, report, controls: this.#controls, motion }, input);
      for (let done = 0; done < 1; done = this.#wasm.performance_progress(handle)) {
        milliseconds += performance.now() - begin;
        yield done;
        begin = performance.now();
        this.#check(this.#wasm.performance_advance(handle), { kind: "retarget" });
      }
      for (const { control, ways } of input.turns ?? [])
        this.#heap.lend([ways], ([at]) => this.#wasm.performance_turn(handle, control, at, ways.length / 3));
      this.#beginBake(handle, input.volume);
      return use(handle, milliseconds + performance.now() - begin);
    } finally {
      this.#wasm.performance_delete(handle);
    }
  }

  *frames({ order, shaped }: FramesInput, emit: Emit): Generator<number, void> {
    let made = 0;
    for (const frame of order) {
      emit(frame, this.#frame(frame, shaped));
      yield ++made / order.length;
    }
  }

  #frame(frame: number, shaped: true): ShapedFrame;
  #frame(frame: number, shaped: boolean): Frame | ShapedFrame;
  #frame(frame: number, shaped: boolean): Frame | ShapedFrame {
    const bake = this.#bake;
    if (!bake) throw new EngineError("bad_examples", "There is no retargeted motion for these controls yet.");
    const begin = performance.now();
    this.#check(this.#wasm.bake_frame(bake, frame), { kind: "frames" });
    const { position, yaw, volumeRatio } = this.#heap.read(bakeRootRow, this.#wasm.bake_root(bake));
    const array =
      shaped && this.#nodes
        ? this.#heap.floats(this.#wasm.bake_maps(bake), 12 * this.#nodes)
        : this.#heap.floats(this.#wasm.bake_positions(bake), 3 * this.#vertices);
    const rest = { volumeRatio: known(volumeRatio), root: [...position, yaw] as Frame["root"], milliseconds: performance.now() - begin };
    return shaped ? { shape: array, ...rest } : { positions: array, ...rest };
  }

  #beginBake(handle: Handle, volume: number): void {
    const wasm = this.#wasm;
    const { frames, flights } = this.#heap.read(performanceInfoRow, wasm.performance_info(handle));
    this.#forgetBake();
    this.#bake = wasm.bake_new();
    wasm.bake_begin(
      this.#bake,
      this.#body,
      frames,
      wasm.performance_controls(handle),
      wasm.performance_turns(handle),
      wasm.performance_yaw(handle),
      wasm.performance_travel(handle),
      wasm.performance_flights(handle),
      flights,
      volume,
    );
  }

  #needControls(): BodyReport {
    if (!this.#report) throw new EngineError("bad_mesh", "There is no model yet. Choose one.");
    if (this.#controls === 0) throw new EngineError("bad_controls", "The model has no controls yet. Place at least one.");
    return this.#report;
  }

  #forgetBake(): void {
    if (this.#bake) this.#wasm.bake_delete(this.#bake);
    this.#bake = 0;
  }

  #check(packed: PackedStatus, subject: Subject): void {
    if (packed !== 0) throw new Refusal(packed, subject);
  }
}

/** Frames of a motion that is worth a first look, and how many of them that looks at. */
const LONG = 1800;
const BEGINNING = 150;

type Emit = (frame: number, result: Frame | ShapedFrame) => void;

const NOWHERE: [number, number, number] = [0, 0, 0];

/** NaN is how the core says that there is none. */
const known = (value: number) => (Number.isNaN(value) ? null : value);
