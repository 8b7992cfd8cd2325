// From the text of a motion file to a motion that the core holds, and what the page is told of it.

import { jointPlaceRow, motionInfoRow, motionNotesRow, writeMotionEdits } from "./abi";
import type { Handle, RiglessExports } from "./abi";
import type { Heap } from "./heap";
import { motionNotes } from "./messages";
import { Refusal } from "./refusal";
import type { Motion, MotionEdits, MotionInput } from "./types";

const AS_IT_CAME: MotionEdits = { metresPerUnit: 0, fps: 0, up: -1, turns: 0, mirror: false, first: 0, last: 1e9, loop: false, joints: [] };

/** The motion's handle is the caller's to delete. */
export function readMotion(wasm: RiglessExports, heap: Heap, input: MotionInput): { handle: Handle; motion: Motion } {
  const handle = wasm.motion_new();
  const encode = (text: string) => new TextEncoder().encode(text);
  const text = encode(input.text);
  const skeleton = encode(input.skeleton?.text ?? "");
  const { edits = AS_IT_CAME } = input;
  const joints = encode(edits.joints.join("\n"));
  try {
    const status = heap.lend([text, skeleton, joints], ([at, skeletonAt, jointsAt]) =>
      heap.lendAll(writeMotionEdits, [edits], (editsAt) =>
        wasm.motion_read(handle, at, text.length, skeletonAt, skeleton.length, editsAt, jointsAt, joints.length),
      ),
    );
    if (status !== 0) {
      const refused = wasm.motion_refused_skeleton(handle) && input.skeleton;
      throw new Refusal(status, refused ? { kind: "skeleton", ...refused } : { kind: "motion", ...input });
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
      const name = heap.text(wasm.motion_name(handle, joint), wasm.motion_name_bytes(handle, joint));
      const { side, part } = heap.read(jointPlaceRow, wasm.motion_place(handle, joint));
      return { name, parent, side: side === "none" ? null : side, part: part === "none" ? null : part };
    }),
    takeFrames: info.takeFrames,
    told: info.told,
    positions: heap.narrowed(wasm.motion_positions(handle), 3 * frames * joints),
    local: heap.narrowed(wasm.motion_local(handle), 3 * frames * joints),
    yaw: heap.narrowed(wasm.motion_yaw(handle), frames),
    stands: { left: heap.bytes(wasm.motion_left(handle), frames), right: heap.bytes(wasm.motion_right(handle), frames) },
    source: { frames: info.sourceFrames, fps: info.sourceFps, metresPerUnit: info.metresPerUnit },
    notes: motionNotes(name, heap.read(motionNotesRow, wasm.motion_notes(handle)), info.sourceFps),
  };
}
