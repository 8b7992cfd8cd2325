import { expect, test } from "vitest";
import { mirroredFrame } from "../../src/app/mirrored";
import type { Example, ProjectDocument } from "../../src/document/types";
import type { Motion } from "../../src/engine/types";
import { sayPose } from "../../src/sync/pairing";
import { dancingContext } from "./app-support";

/** A frame of a motion as the example of a human, seen in a mirror. */
function mirrorOf(document: ProjectDocument, motion: Motion, frame: number): Example {
  const size = 3 * motion.joints.length;
  const { joints } = sayPose(document, motion, motion.local.subarray(frame * size, (frame + 1) * size));
  const swapped = Object.entries(joints).map(([name, [x, y, z]]) => {
    const other = name.replace(/Left|Right/, (side) => (side === "Left" ? "Right" : "Left"));
    return [other, [-x, y, z] as const] as const;
  });
  return { id: "e", source: { motion: "hop.bvh", frame: 0 }, joints: Object.fromEntries(swapped), points: {} };
}

test("the frame whose mirror image a pose is, is found again", async () => {
  const { context } = await dancingContext();
  const { document, motion } = context;
  expect(mirroredFrame(mirrorOf(document, motion!, 9), document, motion!)).toBe(9);
  expect(mirroredFrame(mirrorOf(document, motion!, 17), document, motion!)).toBe(17);
});

test("nothing is found where it never comes near, or no joint has a partner", async () => {
  const { context } = await dancingContext();
  const { document, motion } = context;
  const far = mirrorOf(document, motion!, 9);
  const joints = Object.fromEntries(Object.entries(far.joints).map(([name, [x, y, z]]) => [name, [x + 1, y, z] as const]));
  expect(mirroredFrame({ ...far, joints }, document, motion!)).toBeNull();
  const { Hips, Spine } = far.joints;
  expect(mirroredFrame({ ...far, joints: { Hips, Spine } }, document, motion!)).toBeNull();
});
