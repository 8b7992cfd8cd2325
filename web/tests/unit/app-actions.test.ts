import { expect, test } from "vitest";
import { capsOf, helpRows, labelOf, shortcutsOf, titleOf } from "../../src/app/actions";
import type { ActionId } from "../../src/app/actions";
import { handleKey } from "../../src/app/keys";
import { danced, dancingSession, file } from "./app-support";

test("every action has words, no two share a key, and help shows every one that has keys", async () => {
  const { session } = await dancingSession();
  const actions = Object.values(session.actions);
  expect(actions.length).toBeGreaterThan(20);
  for (const action of actions) {
    expect(labelOf(action)).toMatch(/^[A-Z][a-z ]+$/);
    expect(titleOf(action)).toMatch(/^[A-Z]/);
    expect(session.actions[action.id]).toBe(action);
  }
  const keys = actions.flatMap((action) => action.keys);
  expect(new Set(keys).size).toBe(keys.length);
  const rows = helpRows(session.actions);
  const shown = rows.flatMap(({ caps }) => caps);
  for (const action of actions.filter(({ keys }) => keys.length > 0)) {
    const row = rows.find(({ words }) => words === (action.help ?? labelOf(action)));
    expect(row?.caps).toEqual(expect.arrayContaining([...capsOf(action)]));
  }
  expect(shown).toEqual(actions.filter(({ keys }) => keys.length > 0).flatMap((action) => capsOf(action)));
});

test("words of keys as keyboards, tooltips and assistive technology want them", async () => {
  const { session } = await dancingSession();
  const { redo, escape, addPose, armPin, play, help } = session.actions;
  expect([titleOf(redo), shortcutsOf(redo), capsOf(redo)]).toEqual([
    "Redo (Ctrl+Shift+Z)",
    "Control+Shift+Z Control+Y",
    ["Ctrl", "Shift", "Z"],
  ]);
  expect(capsOf(escape)).toEqual(["Esc"]);
  expect(titleOf(addPose)).toBe("Add a pose at this frame (K)");
  expect([titleOf(armPin), shortcutsOf(armPin)]).toEqual(["The next drag pins a point at this frame and makes no pose", null]);
  expect(titleOf(help)).toBe("Help and keys (?)");
  expect(titleOf(play)).toBe("Play (Space)");
  session.player.play();
  expect(titleOf(play)).toBe("Pause (Space)");
});

/** What each key brings about, and what must be so before. In this order. */
test("each key of the table does what it says", async () => {
  const { session, stage, ports } = await dancingSession();
  const { actions, context, coverage, dragging, history, pins, player, poses, selection } = session;
  const done = new Set<ActionId>();
  const press = (id: ActionId): void => {
    const action = actions[id];
    expect(action.enabled(), id).toBe(true);
    const key = action.keys[0] ?? "";
    const last = key === "Space" ? " " : (key.split("+").at(-1) ?? "");
    const where = { alt: false, typing: false, onButton: false };
    const pressed = { key: last.length === 1 ? last.toLowerCase() : last, ctrl: key.includes("Ctrl"), shift: key.includes("Shift") };
    if (key === "") action.run();
    else expect(handleKey(actions, { ...pressed, ...where }), id).toBe(true);
    done.add(id);
  };
  const count = () => session.document.examples.length;

  expect(actions.undo.enabled()).toBe(false);
  press("play");
  expect(player.playing).toBe(true);
  press("frameOn");
  press("frameOn");
  expect([player.frame, player.playing]).toEqual([2, false]);
  press("frameBack");
  expect(player.frame).toBe(1);
  press("poseAfter");
  const pose = player.frame;
  expect(poses.here.map(({ source }) => source.frame)).toContain(pose);
  press("poseBefore");
  expect(player.frame).toBeLessThan(pose);

  player.seek(pose + 1);
  const before = count();
  press("addPose");
  expect(count()).toBe(before + 1);
  press("undo");
  expect(count()).toBe(before);
  press("redo");
  expect(count()).toBe(before + 1);
  await danced(context);

  coverage.ask(pose + 2);
  expect(actions.answer.enabled()).toBe(true);
  press("answer");
  expect([coverage.asking, count()]).toEqual([null, before + 2]);
  await danced(context);

  selection.select(null);
  press("armPin");
  expect(pins.armed).toBe(true);
  press("escape");
  expect(pins.armed).toBe(false);
  selection.select("top");
  press("pin");
  expect(pins.here).toHaveLength(1);
  press("delete");
  expect(pins.here).toHaveLength(0);
  await danced(context);

  dragging.grab("left-arm");
  press("mirror");
  expect(dragging.active?.mirrored).toBe(true);
  press("escape");
  expect(dragging.active).toBeNull();
  expect(actions.mirror.enabled()).toBe(false);

  for (const panel of ["model", "motion", "points", "poses"] as const) {
    press(panel);
    expect(selection.panel).toBe(panel);
  }
  press("fit");
  expect(stage.told).toContain("fit");
  for (const view of ["threeQuarter", "side", "top"] as const) press(view);
  expect(stage.told.slice(-3)).toEqual(["fit three-quarter", "fit side", "fit top"]);
  press("turn");
  expect(stage.look.turning).toBe(true);
  press("help");
  expect(selection.help).toBe(true);
  press("escape");
  expect(selection.help).toBe(false);
  press("escape");
  expect(selection.panel).toBeNull();
  press("escape");
  expect(selection.point).toBeNull();
  expect(actions.escape.enabled()).toBe(false);
  expect(actions.delete.enabled()).toBe(false);

  press("loop");
  expect(player.loop).toBe(false);
  press("speed");
  expect(player.speed).toBe(2);
  press("save");
  await expect.poll(() => history.saved).toBe(true);
  press("export");
  await expect.poll(() => session.saving.exporting?.state.kind, { timeout: 60_000 }).toBe("made");
  session.saving.exporting?.save();
  expect(ports.downloads.map(({ name }) => name)).toEqual(["Cactus.rigless", "Cactus.glb"]);
  ports.chosen = [file("letter.docx", "Dear all")];
  press("open");
  await expect.poll(() => context.notices.all[0]?.title).toContain("letter.docx");
  expect(Object.keys(actions).filter((id) => !done.has(id as ActionId))).toEqual([]);
});
