import { expect, test } from "vitest";
import { Dragging } from "../../src/app/dragging";
import { Poses } from "../../src/app/poses";
import { setSettings } from "../../src/document/commands";
import { dancingContext, said } from "./app-support";

async function posing() {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => poses.take(dropped));
  const poses = new Poses(context, dragging);
  const free = Array.from({ length: 30 }, (_, f) => f).find((f) => poses.here.every(({ source }) => source.frame !== f)) ?? 0;
  return { context, dragging, poses, free };
}

test("what the hand drops is a pose of this frame, with the human's joints; again it changes", async () => {
  const { context, dragging, poses, free } = await posing();
  const frozen: unknown[] = [];
  context.signals.on("freeze", (freeze) => frozen.push(freeze));
  const count = poses.here.length;
  context.player.seek(free);
  dragging.nudge("top", "ArrowUp", false);
  const targets = dragging.active!.targets.slice();
  poses.add();
  expect(poses.here).toHaveLength(count + 1);
  const pose = poses.here.find(({ source }) => source.frame === free)!;
  expect(Object.keys(pose.joints)).toEqual(context.motion?.joints.map(({ name }) => name));
  expect([...poses.targetsOf(pose)!]).toEqual([...targets].map((value) => expect.closeTo(value, 4)));
  expect(frozen).toEqual([{ frame: free, playOn: false }]);
  expect(said(context)).toEqual(["You made a pose."]);

  dragging.nudge("top", "ArrowRight", false);
  dragging.drop();
  expect(poses.here).toHaveLength(count + 1);
  expect(context.notices.all[0].text).toContain(`It took the place of the one at frame ${free}.`);
});

test("the present shape is a pose without a hand; poses move and go", async () => {
  const { context, poses, free } = await posing();
  context.selection.beginIntro();
  context.player.seek(free);
  poses.add();
  expect(context.selection.intro).toBe(false);
  const { id } = poses.here.find(({ source }) => source.frame === free)!;
  context.player.seek(29);
  poses.update(id);
  expect(context.document.examples.find((pose) => pose.id === id)?.source).toEqual({ motion: "hop.bvh", frame: 29 });
  const before = context.document;
  poses.remove(id);
  expect(context.document.examples.map((pose) => pose.id)).not.toContain(id);
  context.notices.all[0].actions[0].run();
  expect(context.document).toBe(before);
});

test("from pose to pose around the ends, on this motion only", async () => {
  const { context, poses } = await posing();
  const frames = poses.here.map(({ source }) => source.frame).filter((frame) => frame < 30);
  expect(frames.length).toBeGreaterThan(1);
  context.player.seek(frames[0]);
  context.player.play();
  poses.step(1);
  expect([context.player.frame, context.player.playing]).toEqual([frames[1], false]);
  poses.step(-1);
  expect(context.player.frame).toBe(frames[0]);
  const elsewhere = { ...poses.here[0], id: "elsewhere", source: { motion: "walk.bvh", frame: 12 } };
  context.history.apply((document) => ({ ...document, examples: [...document.examples, elsewhere] }));
  expect(poses.isHere(elsewhere)).toBe(false);
  poses.goTo("elsewhere");
  expect(context.player.frame).toBe(frames[0]);
});

test("mirror images are shown where the clip has them, while poses teach both sides", async () => {
  const { context, poses, free } = await posing();
  context.player.seek(free);
  const mirrored = poses.mirrored;
  expect(poses.teachBothSides).toBe(true);
  const own = poses.here.map(({ source }) => source.frame);
  for (const { frame } of mirrored) expect(own.every((other) => Math.abs(other - frame) >= 4)).toBe(true);
  const [pose] = poses.here;
  context.history.apply((document) => ({ ...document, examples: [{ ...pose, source: { motion: "walk.bvh", frame: 0 } }] }));
  expect(poses.mirrored.map((image) => image.pose.id)).toEqual([pose.id]);
  context.history.apply(setSettings({ symmetry: false }));
  expect([poses.canMirror, poses.teachBothSides, poses.mirrored]).toEqual([true, false, []]);
});
