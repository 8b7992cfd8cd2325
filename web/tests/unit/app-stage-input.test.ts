import { expect, test } from "vitest";
import { dancingSession, said } from "./app-support";

test("what the hand does on the stage reaches the part it is for", async () => {
  const { session, stage } = await dancingSession();
  const { dragging, player, selection, pairing, document } = session;
  stage.emit("point-reach", { near: true });
  expect(player.waiting).toBe(true);
  stage.emit("point-grab", { id: "top" });
  expect(dragging.active?.id).toBe("top");
  const { targets } = dragging.active!;
  stage.emit("point-move", { id: "top", position: [0.3, 1.5, 0.1] });
  expect(dragging.active!.targets).not.toEqual(targets);
  stage.emit("point-cancel", { id: "top" });
  expect(dragging.active).toBeNull();
  stage.emit("point-grab", { id: "top" });
  stage.emit("point-move", { id: "top", position: [0.3, 1.5, 0.1] });
  stage.emit("point-drop", { id: "top" });
  expect(said(session.context)).toEqual(["You made a pose."]);
  stage.emit("point-pick", { id: "left-arm", on: "model" });
  expect(selection.point).toBe("left-arm");
  stage.emit("empty-pick", {});
  expect(selection.point).toBeNull();
  pairing.start();
  stage.emit("surface-pick", { vertex: 100 });
  expect(session.document.points).toHaveLength(document.points.length + 1);
  stage.emit("joint-pick", { joint: 2 });
  expect(session.document.points.at(-1)?.joint).toBe(session.context.motion?.joints[2].name);
});

test("a picture that is lost is told, and put back", async () => {
  const { session, stage } = await dancingSession();
  stage.emit("context-lost", {});
  expect(said(session.context)).toEqual(["Graphics were reset by the browser."]);
  stage.told.length = 0;
  stage.emit("context-restored", {});
  expect(said(session.context)).toEqual([]);
  expect(stage.told).toContain("model");
  expect(stage.told).toContain("human");
});
