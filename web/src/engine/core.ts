// The core as the server uses it. The only file that sees pointers: it makes a view, uses it and drops it,
// because a view dies when the heap grows.

import { engineError, motionNotes, outOfMemory } from "./messages";
import type { Subject } from "./messages";
import type { DragInput } from "./protocol";
import { EngineError } from "./types";
import type {
  ConstraintInput,
  ControlInput,
  Frame,
  Joint,
  MeshInput,
  MeshReport,
  Motion,
  MotionInput,
  Performance,
  RetargetInput,
} from "./types";
import type { Handle, PackedStatus, RiglessExports } from "./wasm";

type Lendable = Float32Array | Int32Array | Uint32Array | Uint8Array;

const OUT_DOUBLES = 16;

export class Core {
  #wasm: RiglessExports;
  /** Scratch for what the core answers in a handful of doubles. */
  #out: number;
  #body: Handle;
  #motion: Handle = 0;
  /** The last performance, ready to be deformed. */
  #bake: Handle = 0;
  /** How low and how tall the mesh is at rest. */
  #floor = 0;
  #height = 0;
  #vertices = 0;
  #controls = 0;

  constructor(wasm: RiglessExports) {
    this.#wasm = wasm;
    this.#out = wasm.alloc(8 * OUT_DOUBLES);
    this.#body = wasm.body_new();
  }

  setMesh(mesh: MeshInput): MeshReport {
    const { positions, faces } = mesh;
    if (positions.length % 3 !== 0 || faces.length % 3 !== 0) {
      throw new EngineError("bad_mesh", "The model's points and triangles do not come in threes.");
    }
    this.#lend([positions, faces], ([at = 0, facesAt = 0]) => {
      this.#check(this.#wasm.body_set_mesh(this.#body, at, positions.length / 3, facesAt, faces.length / 3), { kind: "mesh" });
    });
    this.#forgetBake();
    this.#controls = 0;
    this.#vertices = positions.length / 3;
    this.#wasm.body_report(this.#body, this.#out);
    const [
      volume = NaN,
      boundaryEdges = 0,
      nonManifoldEdges = 0,
      shells = 0,
      isolatedVertices = 0,
      degenerateFaces = 0,
      floor = 0,
      height = 0,
    ] = this.#doubles(8);
    this.#floor = floor;
    this.#height = height;
    return {
      vertices: this.#vertices,
      faces: faces.length / 3,
      volume: Number.isNaN(volume) ? null : volume,
      boundaryEdges,
      nonManifoldEdges,
      shells,
      isolatedVertices,
      degenerateFaces,
    };
  }

  setControls(controls: ControlInput[]): void {
    if (this.#vertices === 0) throw new EngineError("bad_controls", "There is no model to place controls on yet.");
    const vertices = Int32Array.from(controls, (control) => control.vertex);
    const radii = Float32Array.from(controls, (control) => control.radius);
    this.#lend([vertices, radii], ([at = 0, radiiAt = 0]) => {
      this.#check(this.#wasm.body_set_controls(this.#body, at, radiiAt, controls.length), { kind: "controls" });
    });
    this.#forgetBake();
    this.#controls = controls.length;
  }

  setMotion(input: MotionInput): Motion {
    const motion = this.#wasm.motion_new();
    try {
      if (input.format === "bvh") {
        this.#read("bvh", motion, input.name, input.text);
      } else {
        this.#read("asf", motion, input.skeletonName, input.skeleton);
        this.#read("amc", motion, input.name, input.text);
      }
    } catch (error) {
      this.#wasm.motion_delete(motion);
      throw error;
    }
    if (this.#motion) this.#wasm.motion_delete(this.#motion);
    this.#motion = motion;
    return this.#describeMotion(motion, input.name);
  }

  drag({ targets, volume, restart }: DragInput): Frame {
    const begin = now();
    this.#needControls();
    this.#lend([targets], ([at = 0]) => {
      this.#check(this.#wasm.body_drag(this.#body, at, targets.length / 3, volume, Number(restart)), { kind: "controls" });
    });
    return {
      positions: this.#floats(this.#wasm.body_positions(this.#body), 3 * this.#vertices),
      volumeRatio: ratio(this.#wasm.body_volume_ratio(this.#body)),
      root: [0, 0, 0, 0],
      milliseconds: now() - begin,
    };
  }

  *retarget(input: RetargetInput): Generator<number, Performance> {
    let begin = now();
    let milliseconds = 0;
    const performance = this.#wasm.performance_new();
    try {
      this.#beginRetarget(performance, input);
      for (let done = 0; done < 1; done = this.#wasm.performance_progress(performance)) {
        milliseconds += now() - begin;
        yield done;
        begin = now();
        this.#check(this.#wasm.performance_advance(performance), { kind: "retarget" });
      }
      this.#beginBake(performance, input.volume);
      return this.#describePerformance(performance, input.constraints ?? [], milliseconds + now() - begin);
    } finally {
      this.#wasm.performance_delete(performance);
    }
  }

  *frames(order: Uint32Array, emit: (frame: number, result: Frame) => void): Generator<number, void> {
    let made = 0;
    for (const frame of order) {
      const bake = this.#bake;
      if (!bake) throw new EngineError("bad_examples", "There is no retargeted motion for these controls yet.");
      const begin = now();
      this.#check(this.#wasm.bake_frame(bake, frame), { kind: "frames" });
      this.#wasm.bake_root(bake, this.#out);
      const [x = 0, y = 0, z = 0, yaw = 0, volume = NaN] = this.#doubles(5);
      const positions = this.#floats(this.#wasm.bake_positions(bake), 3 * this.#vertices);
      emit(frame, { positions, volumeRatio: ratio(volume), root: [x, y, z, yaw], milliseconds: now() - begin });
      yield ++made / order.length;
    }
  }

  #read(kind: "bvh" | "asf" | "amc", motion: Handle, name: string, text: string): void {
    const read = { bvh: this.#wasm.motion_read_bvh, asf: this.#wasm.motion_read_asf, amc: this.#wasm.motion_read_amc };
    const bytes = new TextEncoder().encode(text);
    this.#lend([bytes], ([at = 0]) => this.#check(read[kind](motion, at, bytes.length), { kind, name }));
  }

  #beginRetarget(performance: Handle, input: RetargetInput): void {
    this.#needControls();
    if (!this.#motion) throw new EngineError("bad_motion", "There is no motion yet. Choose one.");
    this.#wasm.motion_info(this.#motion, this.#out);
    const [, joints = 0] = this.#doubles(2);
    const { examples, pairs } = input;
    if (pairs.length !== this.#controls) {
      throw new EngineError("bad_controls", "Every control of the model needs one entry in the pairs.");
    }
    if (examples.some((e) => e.joints.length !== 3 * joints || e.controls.length !== 3 * this.#controls)) {
      throw new EngineError("bad_examples", "A pose does not have as many joints or controls as the motion and the model.");
    }
    this.#ask(performance, input);
    const exampleJoints = joined(examples.map((example) => example.joints));
    const exampleControls = joined(examples.map((example) => example.controls));
    this.#lend([pairs, exampleJoints, exampleControls], ([pairsAt = 0, jointsAt = 0, controlsAt = 0]) => {
      this.#check(
        this.#wasm.performance_begin(
          performance,
          this.#motion,
          pairsAt,
          this.#wasm.body_rest_controls(this.#body),
          this.#controls,
          this.#floor,
          this.#height,
          jointsAt,
          controlsAt,
          examples.length,
          input.smoothness,
          Number(input.groundContact),
          Number(input.inPlace),
        ),
        { kind: "retarget" },
      );
    });
  }

  /** Tells what the user asks of a performance beside its examples. */
  #ask(performance: Handle, input: RetargetInput): void {
    const wasm = this.#wasm;
    wasm.motion_info(this.#motion, this.#out);
    const [frames = 0] = this.#doubles(1);
    const { constraints = [], contacts = [], flights = null, mirror = null, mirrorPlane = null } = input;
    const isControl = (control: number) => Number.isInteger(control) && control >= 0 && control < this.#controls;
    constraints.forEach((constraint, n) => {
      const { kind, control, frame } = constraint;
      const numbers = kind === "position" ? constraint.value : [];
      if (!isControl(control) || frame < (kind === "still" ? 1 : 0) || frame >= frames || !numbers.every(Number.isFinite)) {
        throw new EngineError("bad_examples", `Constraint ${n + 1} is for a point, a frame or a place that does not exist. Remove it.`);
      }
      if (kind === "still") wasm.performance_still(performance, control, frame);
      else {
        const axes = (constraint.axes ?? [true, true, true]).reduce((bits, on, axis) => bits | (Number(on) << axis), 0);
        wasm.performance_place(performance, control, frame, axes, ...constraint.value);
      }
    });
    for (const { control, runs } of contacts) {
      if (!isControl(control)) throw new EngineError("bad_controls", "A contact is said of a point that the model does not have.");
      wasm.performance_stand(performance, control, 0, 0);
      for (const [begin, end] of runs) wasm.performance_stand(performance, control, begin, end);
    }
    if (flights) {
      this.#lend([Int32Array.from(flights.flat())], ([at = 0]) => wasm.performance_fly(performance, at, flights.length));
    }
    if (mirror) {
      if (mirror.length !== this.#controls)
        throw new EngineError("bad_controls", "Every control of the model needs one partner in the mirror.");
      this.#lend([mirror], ([at = 0]) => wasm.performance_mirror(performance, at, mirror.length, ...(mirrorPlane?.normal ?? [1, 0, 0])));
    }
  }

  #beginBake(performance: Handle, volume: number): void {
    const wasm = this.#wasm;
    wasm.performance_info(performance, this.#out);
    const [frames = 0, , flights = 0] = this.#doubles(3);
    this.#forgetBake();
    this.#bake = wasm.bake_new();
    wasm.bake_begin(
      this.#bake,
      this.#body,
      frames,
      wasm.performance_controls(performance),
      wasm.performance_yaw(performance),
      wasm.performance_travel(performance),
      wasm.performance_flights(performance),
      flights,
      volume,
    );
  }

  #describeMotion(motion: Handle, name: string): Motion {
    const wasm = this.#wasm;
    wasm.motion_notes(motion, this.#out);
    const notes = motionNotes(name, this.#doubles(10));
    wasm.motion_info(motion, this.#out);
    const [frames = 0, count = 0, sourceFrames = 0, fps = 0, metresPerUnit = 0] = this.#doubles(5);
    const parents = new Int32Array(wasm.memory.buffer, wasm.motion_parents(motion), count).slice();
    const joints = Array.from(parents, (parent, joint): Joint => {
      const at = wasm.motion_name(motion, joint);
      const bytes = new Uint8Array(wasm.memory.buffer, at, wasm.motion_name_bytes(motion, joint));
      return { name: new TextDecoder().decode(bytes), parent };
    });
    return {
      frames,
      joints,
      positions: this.#floats(wasm.motion_positions(motion), 3 * frames * count),
      local: this.#floats(wasm.motion_local(motion), 3 * frames * count),
      yaw: this.#floats(wasm.motion_yaw(motion), frames),
      source: { frames: sourceFrames, fps, metresPerUnit },
      notes,
    };
  }

  #describePerformance(performance: Handle, constraints: ConstraintInput[], milliseconds: number): Performance {
    const wasm = this.#wasm;
    wasm.performance_info(performance, this.#out);
    const [
      frames = 0,
      controls = 0,
      flightCount = 0,
      before = 0,
      after = 0,
      constraintCount = 0,
      asks = 0,
      have = 0,
      want = 0,
      starters = 0,
    ] = this.#doubles(10);
    const flightsAt = wasm.performance_flights(performance);
    const ends = new Int32Array(wasm.memory.buffer, flightsAt, 2 * flightCount).slice();
    const flights = Array.from({ length: flightCount }, (_, i): [number, number] => [ends[2 * i] ?? 0, ends[2 * i + 1] ?? 0]);
    wasm.performance_asks(performance, this.#out);
    const asked = this.#doubles(2 * asks);
    return {
      frames,
      controls: this.#floats(wasm.performance_controls(performance), 3 * frames * controls),
      contacts: new Uint8Array(wasm.memory.buffer, wasm.performance_contacts(performance), frames * controls).slice(),
      flights,
      yaw: this.#floats(wasm.performance_yaw(performance), frames),
      travel: this.#floats(wasm.performance_travel(performance), 2 * frames),
      slip: { before, after },
      missed: this.#missed(performance, constraintCount, constraints),
      coverage: this.#floats(wasm.performance_coverage(performance), frames),
      ask: Array.from({ length: asks }, (_, i) => ({ frame: asked[2 * i] ?? 0, gain: asked[2 * i + 1] ?? 0 })),
      enough: { have, want },
      starters,
      sourceContacts: new Uint8Array(wasm.memory.buffer, wasm.performance_source_contacts(performance), frames * controls).slice(),
      milliseconds,
    };
  }

  /** The core counts places first, then those that are still. */
  #missed(performance: Handle, count: number, constraints: ConstraintInput[]): Performance["missed"] {
    const worst = this.#floats(this.#wasm.performance_missed(performance), count);
    const against = new Int32Array(this.#wasm.memory.buffer, this.#wasm.performance_opponents(performance), count);
    const order = (["position", "still"] as const).flatMap((kind) =>
      constraints.flatMap((constraint, n) => (constraint.kind === kind ? [n] : [])),
    );
    const missed = { worst: new Float32Array(count), against: new Int32Array(count) };
    order.forEach((n, k) => {
      missed.worst[n] = worst[k] ?? 0;
      missed.against[n] = order[against[k] ?? -1] ?? -1;
    });
    return missed;
  }

  #needControls(): void {
    if (this.#vertices === 0) throw new EngineError("bad_mesh", "There is no model yet. Choose one.");
    if (this.#controls === 0) throw new EngineError("bad_controls", "The model has no controls yet. Place at least one.");
  }

  #forgetBake(): void {
    if (this.#bake) this.#wasm.bake_delete(this.#bake);
    this.#bake = 0;
  }

  #check(packed: PackedStatus, subject: Subject): void {
    if (packed !== 0) throw engineError(packed, subject);
  }

  /** Copies arrays into the heap for the time of one call. */
  #lend<T>(arrays: Lendable[], use: (pointers: number[]) => T): T {
    const pointers: number[] = [];
    try {
      for (const array of arrays) {
        const at = this.#wasm.alloc(Math.max(array.byteLength, 1));
        if (at === 0) throw outOfMemory();
        pointers.push(at);
        const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
        new Uint8Array(this.#wasm.memory.buffer, at, array.byteLength).set(bytes);
      }
      return use(pointers);
    } finally {
      for (const at of pointers) this.#wasm.release(at);
    }
  }

  #floats(at: number, length: number): Float32Array {
    return new Float32Array(this.#wasm.memory.buffer, at, length).slice();
  }

  #doubles(length: number): number[] {
    return Array.from(new Float64Array(this.#wasm.memory.buffer, this.#out, length));
  }
}

const now = () => performance.now();

const ratio = (value: number) => (Number.isNaN(value) ? null : value);

function joined(arrays: Float32Array[]): Float32Array {
  const all = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}
