import { afterEach, expect, test, vi } from "vitest";
import { Dragging } from "../../src/app/dragging";
import type { Dropped } from "../../src/app/dragging";
import { pointPartners, restControls } from "../../src/sync/point-controls";
import { toWorld } from "../../src/sync/placement";
import { dancingContext, listen } from "./app-support";

afterEach(() => vi.useRealTimers());

async function dragging() {
  const { context } = await dancingContext();
  const dropped: Dropped[] = [];
  return { context, dropped, hand: new Dragging(context, (drop) => dropped.push(drop)) };
}

test("a grab stops the dance and says where; a drop hands over what the hand asked for", async () => {
  const { context, dropped, hand } = await dragging();
  const told = listen(context, "drag", "selection");
  context.player.seek(5);
  context.player.play();
  hand.grab("left-arm");
  expect(context.player.playing).toBe(false);
  expect(context.selection.point).toBe("left-arm");
  expect(told).toEqual(["selection", "drag"]);
  const drag = hand.active!;
  expect(drag).toMatchObject({ id: "left-arm", index: 2, frame: 5, wasPlaying: true });
  expect(drag.before).toBe(context.workspace.cache.at(5)?.shape);
  const [x, y, z] = toWorld(drag.base.subarray(6, 9), drag.root);
  hand.move([x + 0.1, y + 0.2, z]);
  await expect.poll(() => drag.shape).not.toBeNull();
  expect(drag.shape).toHaveLength(drag.before.length);
  expect(drag.shape).not.toEqual(drag.before);
  expect(drag.volume).toBeGreaterThan(0.5);
  hand.drop();
  expect(hand.active).toBeNull();
  expect(dropped).toHaveLength(1);
  const there = toWorld(dropped[0].targets.subarray(6, 9), drag.root);
  expect([...there]).toEqual([x + 0.1, y + 0.2, z].map((value) => expect.closeTo(value, 5)));
  expect(dropped[0].targets.subarray(0, 6)).toEqual(drag.base.subarray(0, 6));
});

test("under a hand that rests the shape becomes what the dance would show", async () => {
  const { context, hand } = await dragging();
  context.player.seek(5);
  hand.grab("left-arm");
  const drag = hand.active!;
  const [x, y, z] = toWorld(drag.base.subarray(6, 9), drag.root);
  for (const by of [0.05, 0.2, 0.45]) {
    const before = drag.shape;
    hand.move([x + by, y + by, z]);
    await expect.poll(() => drag.shape).not.toBe(before);
  }
  const dragged = drag.shape!;
  const danced = toWorld((await context.workspace.drag(drag.targets, true)).shape, drag.root);
  expect(danced).not.toEqual(dragged);
  await expect.poll(() => drag.shape).toEqual(danced);
  hand.cancel();
});

test("let go where it was taken, or cancelled, or undone: nothing is handed over and the dance goes on", async () => {
  const { context, dropped, hand } = await dragging();
  const told = listen(context, "frame");
  for (const end of [() => hand.drop(), () => hand.cancel(), () => context.history.undo()]) {
    context.player.play();
    hand.grab("top");
    end();
    expect(hand.active).toBeNull();
    expect(context.player.playing).toBe(true);
  }
  expect(told).toHaveLength(3);
  expect(dropped).toEqual([]);
});

test("the partner mirrors the hand while it is asked to", async () => {
  const { context, dropped, hand } = await dragging();
  const rest = restControls(context.model!, context.document);
  const twin = pointPartners(context.document.points)![2];
  hand.grab("left-arm");
  hand.move(
    toWorld(
      rest.subarray(6, 9).map((value) => value + 0.1),
      hand.active!.root,
    ) as unknown as [number, number, number],
  );
  const alone = hand.active!.targets.slice(3 * twin, 3 * twin + 3);
  hand.mirror();
  const went = hand.active!.targets.subarray(3 * twin, 3 * twin + 3).map((value, k) => value - rest[3 * twin + k]);
  expect([...went]).toEqual([-0.1, 0.1, 0.1].map((value) => expect.closeTo(value, 5)));
  hand.mirror();
  expect(hand.active!.targets.slice(3 * twin, 3 * twin + 3)).toEqual(alone);
  hand.drop();
  expect(dropped).toHaveLength(1);
});

test("arrow keys take a point and move it; it drops by itself when they rest", async () => {
  const { dropped, hand } = await dragging();
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  expect(hand.nudge("top", "a", false)).toBe(false);
  expect(hand.active).toBeNull();
  expect(hand.nudge("top", "ArrowUp", false)).toBe(true);
  expect(hand.nudge("top", "ArrowUp", true)).toBe(true);
  const { base, targets } = hand.active!;
  expect(targets[1] - base[1]).toBeCloseTo(0.012, 5);
  vi.advanceTimersByTime(1000);
  expect(hand.active).toBeNull();
  expect(dropped).toHaveLength(1);
});
