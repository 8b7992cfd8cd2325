import { expect, test } from "vitest";

import { editingOf, MotionEditing } from "../../src/app/motion-editing";
import { saidOf } from "../../src/document/clips";
import { roleOf } from "../../src/skeleton/pair-joints";
import { danced, dancingSession } from "./app-support";

/** The page's own session with its motion looked at. */
async function looking() {
  const { session, stage } = await dancingSession();
  session.selection.setPanel("motion");
  const editing = editingOf(session);
  await expect.poll(() => editing.take, { timeout: 20_000 }).not.toBeNull();
  return { session, stage, editing };
}

test("a motion is cut, sped up, mirrored and looped, each in one step that undo takes back", async () => {
  const { session, editing } = await looking();
  const whole = session.document;
  expect(editing.cut).toEqual([0, 29]);
  editing.setCut([5, 24]);
  await danced(session.context);
  expect([session.player.frames, session.context.motion?.takeFrames]).toEqual([20, 30]);
  editing.setSpeed(2);
  expect(session.player.pace).toBe(2);
  editing.setMirror(true);
  await danced(session.context);
  expect(saidOf(session.document)).toEqual({ cut: [5, 24], speed: 2, mirror: true });
  for (let step = 0; step < 3; step++) session.history.undo();
  expect(session.document).toEqual(whole);
  expect(session.player.pace).toBe(1);
  editing.setCut([0, 29]);
  editing.setSpeed(1);
  editing.setMirror(false);
  expect(session.history.canUndo).toBe(false); // nothing was said
});

test("a loop is suggested, taken with its cut, and let go without it", async () => {
  const { session, editing } = await looking();
  await expect.poll(() => editing.loop).not.toBeNull();
  const cut = editing.loop?.cut;
  editing.setLoop(true);
  expect(saidOf(session.document)).toEqual({ cut, loop: true });
  await danced(session.context);
  const { motion } = session.context;
  const size = 3 * (motion?.joints.length ?? 0);
  const last = (motion?.frames ?? 0) - 1;
  motion?.local.subarray(0, size).forEach((value, i) => expect(motion.local[last * size + i]).toBeCloseTo(value, 5));
  editing.setLoop(false);
  expect(saidOf(session.document)).toEqual({ cut });
});

test("the ends of a cut snap to steps and to the best loop, and never pass each other", async () => {
  const { editing } = await looking();
  const mark = editing.marks.find((frame) => frame > 2 && frame < 27) ?? NaN;
  expect(mark).toBeGreaterThan(2);
  expect(editing.movedEnd(0, mark - 2, 3)).toEqual([mark, 29]);
  expect(editing.movedEnd(0, mark - 2, 0)).toEqual([mark - 2, 29]);
  expect(editing.movedEnd(0, 400, 0)).toEqual([27, 29]);
  expect(editing.movedEnd(1, -400, 0)).toEqual([0, 2]);
  editing.setLoop(true);
  editing.setCut([0, 20]);
  expect(editing.movedEnd(1, 1, 0)).toEqual([0, 7]); // of fewer frames nothing closes
});

test("a wrong guess is corrected in one step: heading, rate, and which joint is which", async () => {
  const { session, editing } = await looking();
  for (const turn of [90, 180, 270, undefined]) {
    editing.turn();
    expect(saidOf(session.document).file?.turn).toBe(turn);
  }
  expect(saidOf(session.document)).toEqual({});
  const own = session.context.motion?.source.fps ?? 0;
  editing.setCut([10, 20]);
  editing.setRate(2 * own, own);
  expect(saidOf(session.document)).toEqual({ cut: [5, 10], file: { fps: 2 * own } });
  editing.setRate(null, own);
  expect(saidOf(session.document)).toEqual({ cut: [10, 20] });
  const [left, right] = [editing.jointOf("left foot"), editing.jointOf("right foot")];
  editing.setJoint("left foot", right);
  expect(saidOf(session.document).file?.joints).toEqual({ "left foot": right, "right foot": left });
  await danced(session.context);
  expect(session.context.motion?.joints.find(({ name }) => name === right)).toMatchObject({ side: "left", part: "foot" });
  expect(session.context.motion?.joints.filter((joint) => roleOf(joint) === "right foot").map(({ name }) => name)).toEqual([left]);
  session.history.undo();
  expect(saidOf(session.document)).toEqual({ cut: [10, 20] });
});

test("a joint is clicked on the human, itself or the dot of a point; without a question the click pairs as ever", async () => {
  const { session, stage, editing } = await looking();
  const { joints = [] } = session.context.motion ?? {};
  const index = (role: string): number => joints.findIndex((joint) => roleOf(joint) === role);
  editing.waitFor("left hand");
  expect(stage.look.mode).toBe("points");
  stage.emit("joint-pick", { joint: index("left lower arm") });
  expect(saidOf(session.document).file?.joints).toEqual({ "left hand": joints[index("left lower arm")].name });
  expect([editing.waiting, stage.look.mode]).toEqual([null, "pose"]);
  const before = session.document;
  const dot = before.points.find(({ joint }) => joint === joints[index("head")].name);
  editing.waitFor("right hand");
  stage.emit("point-pick", { id: dot?.id ?? "", on: "human" });
  expect(saidOf(session.document).file?.joints?.["right hand"]).toBe(dot?.joint);
  const paired = session.document;
  stage.emit("point-pick", { id: dot?.id ?? "", on: "human" });
  expect([session.document, session.selection.point]).toEqual([paired, dot?.id]);
  editing.waitFor("head");
  session.selection.setPanel("model");
  expect(editing.waiting).toBeNull();
});

test("nothing is read while nobody looks", async () => {
  const { session } = await dancingSession();
  const editing = new MotionEditing(session.context);
  await danced(session.context);
  expect(editing.take).toBeNull();
});
