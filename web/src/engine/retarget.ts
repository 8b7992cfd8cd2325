// What the core is asked before it retargets, and what it answers.

import { FOLLOW_THROUGH_NAMES } from "../util/constants";
import { askRow, missRow, motionInfoRow, performanceInfoRow, writeConstraintInput } from "./abi";
import type { BodyReport, Handle, RiglessExports } from "./abi";
import type { Heap } from "./heap";
import { Refusal } from "./refusal";
import { EngineError } from "./types";
import type { Performance, RetargetInput } from "./types";

/** Who dances, and to what. */
export interface Scene {
  body: Handle;
  report: BodyReport;
  controls: number;
  motion: Handle;
}

export function beginRetarget(wasm: RiglessExports, heap: Heap, handle: Handle, scene: Scene, input: RetargetInput): void {
  const { joints } = heap.read(motionInfoRow, wasm.motion_info(scene.motion));
  const { examples, pairs } = input;
  if (pairs.length !== scene.controls) {
    throw new EngineError("bad_controls", "Every control of the model needs one entry in the pairs.");
  }
  if (examples.some((e) => e.joints.length !== 3 * joints || e.controls.length !== 3 * scene.controls)) {
    throw new EngineError("bad_examples", "A pose does not have as many joints or controls as the motion and the model.");
  }
  const constraints = input.constraints ?? [];
  heap.lendAll(writeConstraintInput, constraints, (at) => wasm.performance_constrain(handle, at, constraints.length));
  edit(wasm, heap, handle, scene.controls, input);
  const exampleJoints = joined(examples.map((example) => example.joints));
  const exampleControls = joined(examples.map((example) => example.controls));
  const status = heap.lend([pairs, exampleJoints, exampleControls], ([pairsAt, jointsAt, controlsAt]) =>
    wasm.performance_begin(
      handle,
      scene.motion,
      pairsAt,
      wasm.body_rest_controls(scene.body),
      wasm.body_limbs(scene.body),
      scene.controls,
      scene.report.floor,
      scene.report.height,
      jointsAt,
      controlsAt,
      examples.length,
      input.smoothness,
      Number(input.groundContact),
      Number(input.inPlace),
      input.energy ?? 0,
      Number(input.paper ?? 0),
      Number(Boolean(input.turns?.length)),
    ),
  );
  if (status !== 0) throw new Refusal(status, { kind: "retarget" });
}

export function describePerformance(wasm: RiglessExports, heap: Heap, handle: Handle, milliseconds: number): Performance {
  const info = heap.read(performanceInfoRow, wasm.performance_info(handle));
  const { frames, controls } = info;
  const turns = wasm.performance_turns(handle);
  const ends = heap.integers(wasm.performance_flights(handle), 2 * info.flights);
  return {
    frames,
    controls: heap.floats(wasm.performance_controls(handle), 3 * frames * controls),
    turns: turns ? heap.floats(turns, 3 * frames * controls) : null,
    contacts: heap.bytes(wasm.performance_contacts(handle), frames * controls),
    flights: Array.from({ length: info.flights }, (_, i): [number, number] => [ends[2 * i], ends[2 * i + 1]]),
    yaw: heap.floats(wasm.performance_yaw(handle), frames),
    travel: heap.floats(wasm.performance_travel(handle), 3 * frames),
    slip: { before: info.slipBefore, after: info.slipAfter },
    missed: missed(wasm, heap, handle, info.constraints),
    coverage: heap.floats(wasm.performance_coverage(handle), frames),
    ask: Array.from({ length: info.asks }, (_, n) => heap.read(askRow, wasm.performance_ask(handle, n))),
    enough: { have: info.have, want: info.want },
    starters: info.starters,
    sourceContacts: heap.bytes(wasm.performance_source_contacts(handle), frames * controls),
    milliseconds,
  };
}

/** Parts that follow; contacts, flights and mirror images instead of those of the motion and the model. */
function edit(wasm: RiglessExports, heap: Heap, handle: Handle, controls: number, input: RetargetInput): void {
  const { contacts = [], flights = null, follow = [], poseWeights = null, mirror = null, mirrorPlane = null } = input;
  if ([follow, poseWeights ?? []].some(({ length }) => length > 0 && length !== controls)) {
    throw new EngineError("bad_controls", "Every control of the model needs one entry in what follows.");
  }
  const kinds = follow.length > 0 ? Int32Array.from(follow, (one) => FOLLOW_THROUGH_NAMES.indexOf(one)) : null;
  heap.lend([kinds, poseWeights], ([at, weightsAt]) => wasm.performance_follow(handle, at, weightsAt, controls));
  for (const { control, runs } of contacts) {
    if (!Number.isInteger(control) || control < 0 || control >= controls) {
      throw new EngineError("bad_controls", "A contact is said of a point that the model does not have.");
    }
    wasm.performance_stand(handle, control, 0, 0);
    for (const [begin, end] of runs) wasm.performance_stand(handle, control, begin, end);
  }
  if (flights) heap.lend([Int32Array.from(flights.flat())], ([at]) => wasm.performance_fly(handle, at, flights.length));
  if (mirror) {
    if (mirror.length !== controls) throw new EngineError("bad_controls", "Every control of the model needs one partner in the mirror.");
    heap.lend([mirror], ([at]) => wasm.performance_mirror(handle, at, mirror.length, ...(mirrorPlane?.normal ?? [1, 0, 0])));
  }
}

function missed(wasm: RiglessExports, heap: Heap, handle: Handle, count: number): Performance["missed"] {
  const all = { worst: new Float32Array(count), against: new Int32Array(count) };
  for (let n = 0; n < count; n++) {
    const { metres, opponent } = heap.read(missRow, wasm.performance_miss(handle, n));
    all.worst[n] = metres;
    all.against[n] = opponent;
  }
  return all;
}

function joined(arrays: Float32Array[]): Float32Array {
  const all = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}
