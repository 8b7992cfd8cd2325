import { expect, test } from "vitest";
import { setSettings } from "../../src/document/commands";
import { toStage } from "../../src/document/stage-transform";
import { stageFor } from "../../src/sync/placement";
import { danced, dancingSession } from "./app-support";

test("a stage is shown everything: model, human, dots and the frame", async () => {
  const { session, stage } = await dancingSession();
  const { context, sources, player, document } = session;
  const { model } = sources.of(context.model!)!;
  expect(stage.model?.positions).toEqual(toStage(stageFor(model, document.mesh), model.drawn.positions));
  expect(stage.model?.index).toBe(model.drawn.index);
  expect(stage.model?.document).toBe(model.document);
  expect(stage.human?.joints).toHaveLength(context.motion?.joints.length ?? 0);
  expect(stage.human?.joints[0].label).toBe("Hips");
  expect([...stage.human!.parents]).toEqual(context.motion?.joints.map(({ parent }) => parent));
  expect(stage.points.map(({ id }) => id)).toEqual(document.points.map(({ id }) => id));
  expect(stage.points[2]).toMatchObject({ number: 3, name: "Left arm", twin: false });
  expect(context.motion?.joints[stage.points[2].joint].name).toBe("LeftHand");
  expect(stage.look).toMatchObject({ mode: "pose", layout: "side", pulse: "top", livePair: null, asking: false });
  player.seek(8);
  expect(stage.shape).toBe(context.workspace.cache.at(8)?.shape);
  const size = 3 * context.motion!.joints.length;
  expect(stage.humanPose).toEqual(context.motion!.positions.subarray(8 * size, 9 * size));
  context.history.apply(setSettings({ inPlace: true }));
  await danced(context);
  player.seek(9);
  expect([stage.humanPose![0], stage.humanPose![2]]).toEqual([0, 0]);
});

test("what is selected, asked for and looked at shows", async () => {
  const { session, stage } = await dancingSession();
  const { selection, pairing, coverage, presenter, player } = session;
  selection.select("left-arm");
  expect(stage.selected).toBe("left-arm");
  expect(stage.points.filter(({ twin }) => twin).map(({ id }) => id)).toEqual(["right-arm"]);
  selection.setPanel("points");
  selection.setLayout("overlay");
  pairing.waitFor("top");
  expect(stage.look).toMatchObject({ mode: "points", layout: "overlay", livePair: "top" });
  coverage.ask(3);
  expect(stage.look).toMatchObject({ asking: true, pulse: null });
  expect(player.frame).toBe(3);
  presenter.fit();
  presenter.setInsets({ left: 1, top: 2, right: 3, bottom: 4 });
  expect([stage.told.at(-1), stage.insets?.right]).toEqual(["fit", 3]);
  presenter.close();
  expect(stage.told.at(-1)).toBe("dispose");
});

test("suggested points are marks of their own while points are made", async () => {
  const { session, stage } = await dancingSession();
  session.history.apply((document) => ({ ...document, points: document.points.slice(3, 4), examples: [] }));
  await danced(session.context);
  session.selection.setPanel("points");
  await expect.poll(() => stage.points.filter(({ suggested }) => suggested).length).toBeGreaterThan(1);
  expect(stage.points.at(-1)?.id).toBe(session.guesses.markOf(session.guesses.suggested.at(-1)!));
  session.selection.setPanel(null);
  expect(stage.points).toHaveLength(1);
});

test("the hand's shape stays until the new dance has one", async () => {
  const { session, stage } = await dancingSession();
  const { dragging, context, player } = session;
  player.seek(6);
  dragging.grab("top");
  expect(stage.look.ghost).toBe(context.workspace.cache.at(6)?.shape);
  dragging.nudge("top", "ArrowUp", false);
  const drag = dragging.active!;
  await expect.poll(() => drag.shape).not.toBeNull();
  await expect.poll(() => stage.shape).toBe(drag.shape);
  expect(stage.look.note).toMatch(/^Volume \d+ %$/);
  dragging.drop();
  expect(stage.look).toMatchObject({ ghost: null, note: "" });
  const old = context.workspace.cache.at(6)?.shape;
  expect(stage.shape).toBe(drag.shape);
  await danced(context);
  expect(stage.shape).toBe(context.workspace.cache.at(6)?.shape);
  expect(stage.shape).not.toBe(old);
});
