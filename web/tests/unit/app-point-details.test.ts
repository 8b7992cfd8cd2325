import { expect, test } from "vitest";
import { Dragging } from "../../src/app/dragging";
import { Guesses } from "../../src/app/guesses";
import { Pairing } from "../../src/app/pairing";
import { PointDetails } from "../../src/app/point-details";
import { Points } from "../../src/app/points";
import { Poses } from "../../src/app/poses";
import { danced, dancingContext } from "./app-support";

async function detailing() {
  const { context } = await dancingContext();
  const dragging: Dragging = new Dragging(context, (dropped) => poses.take(dropped));
  const poses = new Poses(context, dragging);
  const pairing = new Pairing(context, new Points(context), new Guesses(context));
  const of = (id: string) => context.document.points.find((point) => point.id === id)!;
  return { context, dragging, poses, pairing, details: new PointDetails({ context, poses, pairing }), of };
}

test("a slider that is held is one step, of a weight and of a reach", async () => {
  const { context, details, of } = await detailing();
  const before = context.document;
  for (const weight of [0.6, 0.9, 1.2]) details.setWhole(of("top"), weight, true);
  details.setWhole(of("top"), 1.5, false);
  expect(of("top").wholePose).toBe(1.5);
  context.history.undo();
  expect(context.document).toBe(before);
  details.keepStiff(of("top").position);
  const [part] = details.stiff;
  expect(details.around(of("top"))).toBe(part);
  details.setReach(part, 0.3, true);
  details.setReach(part, null, false);
  expect(details.stiff).toEqual([{ id: part.id, position: of("top").position }]);
  context.history.undo();
  expect(details.stiff).toEqual([part]);
  details.soften(part);
  expect(context.document.stiff).toBeUndefined();
  context.notices.all[0].actions[0].run();
  expect(details.stiff).toEqual([part]);
  await danced(context);
});

test("a turn is a pose at its frame; the dance turns, and a drag there keeps it", async () => {
  const { context, dragging, poses, details, of } = await detailing();
  const count = context.document.examples.length;
  context.player.seek(17);
  details.setTurn(of("top"), 0, 20, true);
  details.setTurn(of("top"), 0, 40, false);
  expect(context.document.examples).toHaveLength(count + 1);
  const pose = context.document.examples.at(-1)!;
  expect(poses.frameOf(pose)).toBe(17);
  expect(details.turnOf(of("top"))).toEqual([40, 0, 0].map((degrees) => expect.closeTo(degrees, 3)));
  await danced(context);
  context.player.seek(18);
  const turn = details.turnOf(of("top"));
  expect(turn?.[0]).toBeGreaterThan(5);
  dragging.grab("left-arm");
  dragging.nudge("left-arm", "ArrowUp", false);
  dragging.drop();
  expect(poses.frameOf(context.document.examples.at(-1)!)).toBe(18);
  expect(details.turnOf(of("top"))).toEqual(turn?.map((degrees) => expect.closeTo(degrees, 3)));
  context.history.undo();
  context.history.undo();
  expect(context.document.examples).toHaveLength(count);
});

test("the next click on the model says what stays stiff, and makes no point", async () => {
  const { context, pairing, details } = await detailing();
  const { points } = context.document;
  details.askForStiff();
  expect([pairing.asks, pairing.asksPlace]).toEqual([true, true]);
  pairing.surface(100);
  expect(context.document.points).toBe(points);
  expect(details.stiff.map(({ position }) => position)).toEqual([[...context.model!.positions.subarray(300, 303)]]);
  expect(pairing.asks).toBe(false);
  pairing.surface(200);
  expect(details.stiff).toHaveLength(1);
});

test("partners are each other's, and leave those that they had", async () => {
  const { details, of } = await detailing();
  details.pairMirror(of("left-arm"), "left-edge");
  expect([of("left-arm").mirror, of("left-edge").mirror, of("right-arm").mirror]).toEqual(["left-edge", "left-arm", undefined]);
});
