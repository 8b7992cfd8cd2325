import { expect, test } from "vitest";
import { TETRAHEDRON } from "../support/files";
import { dancingSession, file, said, TestShelf, testPorts } from "./app-support";

/** A page in which the name was changed twice, and which is closed then. */
async function worked(shelf: TestShelf, memory?: ReturnType<typeof testPorts>["memory"]) {
  const ports = { ...testPorts(shelf), ...(memory && { memory }) };
  const { session } = await dancingSession(ports);
  session.settings.rename("First");
  session.settings.rename("Second");
  await expect.poll(() => [...shelf.kept.values()].map(({ name }) => name)).toEqual(["Second"]);
  return { session, ports };
}

test("nothing is kept of a page in which nothing was done", async () => {
  const shelf = new TestShelf();
  const { session } = await dancingSession(testPorts(shelf));
  expect(session.keeping).toBeNull();
  expect(session.selection.intro).toBe(true);
  expect(shelf.kept.size).toBe(0);
});

test("a page that is opened again goes on where it was, undo and redo too", async () => {
  const shelf = new TestShelf();
  const { session: before } = await worked(shelf);
  before.history.undo();
  before.history.undo();
  before.history.redo();
  await before.keeping?.flush();
  expect(before.history.unsaved).toBe(false);
  shelf.claims.clear(); // the page is gone

  const { session } = await dancingSession(testPorts(shelf));
  expect(session.document).toEqual(before.document);
  expect(session.selection.intro).toBe(false);
  expect(said(session.context)).toEqual(["First is as you left it."]);
  expect(session.performance?.frames).toBe(30);
  session.history.redo();
  expect(session.document.name).toBe("Second");
  session.history.undo();
  session.history.undo();
  expect(session.document.name).toBe("Cactus");
  expect(session.history.canUndo).toBe(false);
});

test("an own model and whoever left the stage come back with it", async () => {
  const shelf = new TestShelf();
  const { session: before } = await dancingSession(testPorts(shelf));
  before.settings.rename("Spiky");
  await before.opening.files([file("tetra.obj", TETRAHEDRON)]);
  await before.keeping?.flush();
  shelf.claims.clear();

  const { session } = await dancingSession(testPorts(shelf));
  expect(session.document.mesh.file).toBe("tetra.obj");
  expect(session.context.model).toBeDefined();
  const cactus = session.cast.list.find(({ character }) => character?.name === "Cactus");
  expect(session.cast.remembered(cactus?.file ?? "")?.name).toBe("Spiky");
  while (session.history.canUndo) session.history.undo();
  expect(session.document.name).toBe("Cactus");
  expect(session.context.model).toBeDefined();
});

test("a second tab works on a copy, and says so", async () => {
  const shelf = new TestShelf();
  await worked(shelf);
  const { session } = await dancingSession(testPorts(shelf));
  expect(session.document.name).toBe("Second");
  expect(said(session.context)).toEqual(["This is a copy of Second."]);
  session.settings.rename("Third");
  await session.keeping?.flush();
  expect([...shelf.kept.values()].map(({ name }) => name).sort()).toEqual(["Second", "Third"]);
});

test("a page that is loaded again has its own project, though another is newer", async () => {
  const shelf = new TestShelf();
  const { ports } = await worked(shelf);
  const { session: other } = await dancingSession(testPorts(shelf));
  other.settings.rename("Newer");
  await other.keeping?.flush();
  shelf.claims.clear();
  const { session } = await dancingSession({ ...testPorts(shelf), memory: ports.memory });
  expect(session.document.name).toBe("Second");
});

test("a fresh start keeps what was there, and one can go back", async () => {
  const shelf = new TestShelf();
  const { session } = await worked(shelf);
  await session.keeping?.startFresh();
  expect(session.document.name).toBe("Cactus");
  expect(session.history.canUndo).toBe(false);
  expect(said(session.context)).toContain("Second is kept.");
  session.settings.rename("Another");
  await session.keeping?.flush();
  expect(session.keeping?.list.map(({ name }) => name).sort()).toEqual(["Another", "Second"]);
  const { id } = session.keeping?.list.find(({ name }) => name === "Second") ?? { id: "" };
  expect(await session.keeping?.open(id)).toBe(true);
  expect(session.document.name).toBe("Second");
  session.history.undo();
  expect(session.document.name).toBe("First");
});

test("what is let go of can be kept again", async () => {
  const shelf = new TestShelf();
  const { session } = await worked(shelf);
  const [{ id }] = shelf.kept.values() as unknown as [{ id: string }];
  await session.keeping?.remove(id);
  expect(shelf.kept.size).toBe(0);
  session.context.notices.all.find(({ title }) => title === "Second is no longer kept.")?.actions[0]?.run();
  await expect.poll(() => shelf.kept.get(id)?.name).toBe("Second");
});

test("where nothing can be kept it is said once, with what to do", async () => {
  const shelf = new TestShelf();
  shelf.full = new DOMException("full", "QuotaExceededError");
  const { session, ports } = await dancingSession(testPorts(shelf));
  session.settings.rename("First");
  await expect.poll(() => said(session.context)).toContain("This browser cannot keep your work.");
  expect(session.history.unsaved).toBe(true);
  const [notice] = session.context.notices.all;
  notice?.actions[0]?.run();
  await expect.poll(() => ports.downloads.map(({ name }) => name)).toEqual(["First.rigless"]);
  session.context.notices.dismiss(notice?.id ?? 0);
  session.settings.rename("Second");
  await session.keeping?.flush();
  expect(said(session.context)).toEqual([]);
});

test("a project that took its page with it is not opened by itself again", async () => {
  const shelf = new TestShelf();
  await worked(shelf);
  shelf.claims.clear();
  const [id] = shelf.kept.keys();
  const ports = testPorts(shelf);
  ports.memory.opening = id ?? null;
  const { session } = await dancingSession(ports);
  expect(session.document.name).toBe("Cactus");
  expect(said(session.context)).toEqual(["Second did not open last time."]);
  session.context.notices.all[0]?.actions[0]?.run();
  await expect.poll(() => session.document.name).toBe("Second");
});
