// From the text of a motion file to a motion that the core holds, and what the page is told of it.

import { jointPlaceRow, motionInfoRow, motionNotesRow } from "./abi";
import type { Handle, RiglessExports } from "./abi";
import type { Heap } from "./heap";
import { engineError, motionNotes } from "./messages";
import type { Motion, MotionInput } from "./types";

/** The motion's handle is the caller's to delete. */
export function readMotion(wasm: RiglessExports, heap: Heap, input: MotionInput): { handle: Handle; motion: Motion } {
  const handle = wasm.motion_new();
  const read = (kind: "bvh" | "asf" | "amc", name: string, text: string) => {
    const reader = { bvh: wasm.motion_read_bvh, asf: wasm.motion_read_asf, amc: wasm.motion_read_amc }[kind];
    const bytes = new TextEncoder().encode(text);
    const status = heap.lend([bytes], ([at]) => reader(handle, at, bytes.length));
    if (status !== 0) throw engineError(status, { kind, name });
  };
  try {
    if (input.format === "bvh") {
      read("bvh", input.name, input.text);
    } else {
      read("asf", input.skeletonName, input.skeleton);
      read("amc", input.name, input.text);
    }
    return { handle, motion: describe(wasm, heap, handle, input.name) };
  } catch (error) {
    wasm.motion_delete(handle);
    throw error;
  }
}

function describe(wasm: RiglessExports, heap: Heap, handle: Handle, name: string): Motion {
  const info = heap.read(motionInfoRow, wasm.motion_info(handle));
  const { frames, joints } = info;
  const parents = heap.integers(wasm.motion_parents(handle), joints);
  return {
    frames,
    joints: Array.from(parents, (parent, joint) => {
      const { side, part } = heap.read(jointPlaceRow, wasm.motion_place(handle, joint));
      return {
        name: heap.text(wasm.motion_name(handle, joint), wasm.motion_name_bytes(handle, joint)),
        parent,
        side: side === "none" ? null : side,
        part: part === "none" ? null : part,
      };
    }),
    told: info.told,
    positions: heap.floats(wasm.motion_positions(handle), 3 * frames * joints),
    local: heap.floats(wasm.motion_local(handle), 3 * frames * joints),
    yaw: heap.floats(wasm.motion_yaw(handle), frames),
    source: { frames: info.sourceFrames, fps: info.sourceFps, metresPerUnit: info.metresPerUnit },
    notes: motionNotes(name, heap.read(motionNotesRow, wasm.motion_notes(handle))),
  };
}
