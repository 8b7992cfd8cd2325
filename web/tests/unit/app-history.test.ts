import { expect, test } from "vitest";
import { renameProject } from "../../src/document/commands";
import { emptyContext, listen, said } from "./app-support";

test("steps go back and on; who holds something is told before", () => {
  const { context } = emptyContext();
  const { history } = context;
  const told = listen(context, "travel", "document");
  history.apply(renameProject("A"));
  expect([history.canUndo, history.canRedo, history.document.name]).toEqual([true, false, "A"]);
  history.undo();
  expect([history.canUndo, history.canRedo, history.document.name]).toEqual([false, true, "Untitled"]);
  history.redo();
  expect(history.document.name).toBe("A");
  expect(told).toEqual(["document", "travel", "document", "travel", "document"]);
});

test("saved until it changes, and unsaved only if the person changed it", () => {
  const { context } = emptyContext();
  const { history } = context;
  history.replace({ ...history.document, name: "Opened" });
  expect(history.canUndo).toBe(false);
  history.markSaved();
  expect([history.saved, history.unsaved]).toEqual([true, false]);
  history.apply(renameProject("B"));
  expect([history.saved, history.unsaved]).toEqual([false, true]);
  history.undo();
  expect([history.saved, history.unsaved]).toEqual([true, false]);
});

test("a notice offers to undo what it speaks of, as long as nothing else was done", () => {
  const { context } = emptyContext();
  const { history, notices } = context;
  history.apply(renameProject("A"));
  notices.say({ title: "Renamed.", actions: [history.undoAction()] });
  history.apply(renameProject("B"));
  expect(notices.all[0].actions).toEqual([]);
  notices.say({ title: "Renamed again.", actions: [history.undoAction()] });
  notices.all[0].actions[0].run();
  expect(history.document.name).toBe("A");
  expect(said(context)).toEqual(["Renamed."]);
});
