import { expect, test } from "vitest";
import type { Duet } from "../../src/app/duet";
import type { Session } from "../../src/app/session";
import { companionDocument } from "../../src/document/duet";
import { findFile } from "../../src/io/named-file";
import { openProject } from "../../src/io/project-file";
import { split } from "../../src/io/gltf/read";
import { TETRAHEDRON } from "../support/files";
import { dancingSession, file, said, TestShelf, testPorts } from "./app-support";

/** The lamp dances beside the cactus, and every frame of it is there. */
async function paired(ports = testPorts()) {
  const page = await dancingSession(ports);
  const { session } = page;
  const duet = await session.accompany();
  await duet.partners.usePerformer(performer(session, "Lamp"));
  await solved(duet);
  return { ...page, duet };
}

function performer({ cast }: Session, name: string) {
  const found = cast.list.find((one) => one.name === name);
  if (!found) throw new Error(`no ${name}`);
  return found;
}

async function solved({ workspace }: Duet): Promise<void> {
  do await workspace?.sync();
  while (workspace && workspace.cache.staleCount > 0);
}

test("somebody comes, dances beside at the same moments, and goes; all of it can be undone", async () => {
  const { session, stage, duet } = await paired();
  const { player, history } = session.context;
  expect(session.document.companion?.mesh.file).toBe("lamp.glb");
  expect(duet.name).toBe("Lamp");
  await expect.poll(() => stage.beside?.model).not.toBeNull();
  expect(stage.beside?.place).toEqual([1.6, -0.15]);
  player.seek(12);
  expect(stage.beside?.shape).toBe(duet.workspace?.cache.at(12)?.shape);
  expect(stage.shape).toBe(session.context.workspace.cache.at(12)?.shape);

  duet.move("seconds", () => ({ seconds: 0.2 }), true);
  duet.move("seconds", () => ({ seconds: 0.1 }), false);
  expect(stage.beside?.shape).toBe(duet.workspace?.cache.at(9)?.shape);
  player.seek(1);
  expect(stage.beside?.shape).toBe(duet.workspace?.cache.at(0)?.shape); // it waits for its turn
  const here = stage.beside?.standing;
  stage.beside?.emit("move", { x: 0.5, z: -1, held: true });
  stage.beside?.emit("move", { x: 0.5, z: -0.25, held: false });
  expect(session.document.companion?.offset).toEqual({ seconds: 0.1, place: [2.1, -0.4], yaw: 0 });
  expect(stage.beside?.standing?.x).toBeCloseTo((here?.x ?? 0) + 0.5);

  session.selection.setPanel("model");
  expect(stage.beside?.handle).toBe("Lamp: drag it over the floor, or use the arrow keys");
  session.selection.setPanel(null);
  expect(stage.beside?.handle).toBeNull();

  const last = stage.beside;
  duet.remove();
  expect([session.document.companion, last?.disposed, duet.workspace]).toEqual([undefined, true, null]);
  history.undo();
  await solved(duet);
  await expect.poll(() => stage.beside !== last && stage.beside?.model).toBeTruthy();
  for (const places of [1.6, 1.6]) {
    history.undo();
    expect(session.document.companion?.offset.place[0]).toBe(places);
  }
  history.undo();
  expect(session.document.companion).toBeUndefined();
  expect(history.canUndo).toBe(false);
});

test("who is taken in hand changes places with the other one", async () => {
  const { session, duet } = await paired();
  duet.swap();
  expect([session.document.mesh.file, duet.companion?.mesh.file]).toEqual(["lamp.glb", "cactus.glb"]);
  expect(session.document.companion?.offset.place).toEqual([-1.6, 0.15]);
  await expect.poll(() => session.context.workspace.model === session.context.model).toBe(true);
  await solved(duet);
  expect(duet.workspace?.performance?.frames).toBe(30);
  await session.opening.usePerformer(performer(session, "Egg"));
  expect([session.document.mesh.file, duet.companion?.mesh.file]).toEqual(["egg.glb", "cactus.glb"]);
  session.history.undo();
  session.history.undo();
  expect([session.document.mesh.file, duet.companion?.mesh.file]).toEqual(["cactus.glb", "lamp.glb"]);
});

test("one may dance with oneself", async () => {
  const { session, stage, duet } = await paired();
  await duet.partners.usePerformer(performer(session, "Cactus"));
  await solved(duet);
  expect(duet.companion?.mesh.file).toBe(session.document.mesh.file);
  expect(duet.workspace?.performance?.controls).toEqual(session.performance?.controls);
  await expect.poll(() => stage.beside?.model?.document).toBe(stage.model?.document);
  duet.swap();
  expect(session.document.companion?.points).toEqual(session.document.points);
});

test("a move that was taken back stays so when the hand lets go", async () => {
  const { session, stage } = await paired();
  await expect.poll(() => stage.beside).not.toBeNull();
  stage.beside?.emit("move", { x: 1, z: 0, held: true });
  session.history.undo();
  stage.beside?.emit("move", { x: 1, z: 0, held: false });
  expect(session.document.companion?.offset.place).toEqual([1.6, -0.15]);
});

test("who cannot come changes nothing, and that is said", async () => {
  const { session, duet, ports } = await paired();
  const before = session.document;
  ports.chosen = [file("broken.glb", "glTF that was cut short")];
  await duet.partners.pick();
  expect(session.document).toBe(before);
  expect(said(session.context)[0]).toBe("broken.glb cannot dance beside.");
  expect(duet.partners.coming).toBeNull();
  await solved(duet);
  expect(duet.at(0.2, 0)?.shape).toBeDefined();
});

test("who is being tried on comes, whatever is done meanwhile", async () => {
  const { session, stage } = await dancingSession();
  const duet = await session.accompany();
  const { partners } = duet;
  const first = partners.usePerformer(performer(session, "Lamp"));
  await expect.poll(() => duet.workspace, { interval: 1 }).not.toBeNull();
  session.settings.rename("Meanwhile");
  await first;
  expect(session.document, said(session.context).join()).toMatchObject({ name: "Meanwhile", companion: { mesh: { file: "lamp.glb" } } });
  const second = partners.usePerformer(performer(session, "Egg"));
  await expect.poll(() => partners.coming).not.toBeNull();
  session.history.undo();
  await second;
  await solved(duet);
  expect(duet.name, said(session.context).join()).toBe("Egg");
  await expect.poll(() => stage.beside?.model).toBeTruthy();
  expect(stage.beside?.disposed).toBe(false);
});

test("a saved project has both, with whatever they dance to", async () => {
  const { session, duet, ports } = await paired();
  ports.chosen = [file("cactus.glb", TETRAHEDRON)];
  const wave = session.motions.list.find(({ name }) => name !== session.motions.list[0]?.name) ?? null;
  await duet.partners.useMotion(wave);
  await solved(duet);
  await session.saving.save();
  const [{ name, bytes }] = ports.downloads;
  const opened = await openProject([{ name, bytes }]);
  expect(opened.document.companion).toEqual(session.document.companion);
  expect(opened.beside?.modelFiles[0].name).toBe("lamp.glb");
  expect(opened.beside?.motion?.name).toBe(wave?.files.at(-1));
  const other = await dancingSession();
  await other.session.opening.files([file(name, bytes)]);
  expect(other.session.document).toEqual(session.document);
  const again = await other.session.accompany();
  await solved(again);
  expect(again.workspace?.performance?.controls).toEqual(duet.workspace?.performance?.controls);
});

test("two models whose files have one name lie apart in the saved project", async () => {
  const { session, ports } = await dancingSession();
  const duet = await session.accompany();
  const texture = (text: string) => file("t.mtl", `newmtl ${text}\nKd 1 0 0\n`);
  await session.opening.files([file("one.obj", `mtllib t.mtl\n${TETRAHEDRON}`), texture("red")]);
  ports.chosen = [file("two.obj", `mtllib t.mtl\n# another\n${TETRAHEDRON}`), texture("blue")];
  await duet.partners.pick();
  expect(duet.companion?.mesh.file, said(session.context).join()).toBe("two.obj");
  await session.saving.save();
  const opened = await openProject(ports.downloads.slice(-1));
  expect(opened.document.companion?.mesh.file).toBe("companion/two.obj");
  expect(opened.beside?.modelFiles[0].name).toBe("companion/two.obj");
  expect(opened.modelFiles.map((one) => one.name)).toContain("t.mtl");

  await session.opening.files(ports.downloads.slice(-1).map(({ name, bytes }) => file(name, bytes)));
  duet.swap();
  ports.chosen = [file("three.obj", `mtllib t.mtl\n# a third\n${TETRAHEDRON}`), texture("green")];
  await duet.partners.pick();
  await session.saving.save();
  const { beside } = await openProject(ports.downloads.slice(-1));
  const material = findFile(beside?.modelFiles ?? [], "t.mtl", beside?.modelFiles[0].name);
  expect(new TextDecoder().decode(material?.bytes)).toContain("green");
});

test("a page that is opened again has both, and a kept project may come to dance beside", async () => {
  const shelf = new TestShelf();
  const { session: before } = await paired(testPorts(shelf));
  await before.keeping?.flush();
  shelf.claims.clear();
  const { session } = await dancingSession(testPorts(shelf));
  expect(session.document).toEqual(before.document);
  const duet = await session.accompany();
  await solved(duet);
  expect(duet.workspace?.performance?.frames).toBe(30);
  session.history.undo();
  expect(session.document.companion).toBeUndefined();

  shelf.claims.clear();
  const ports = testPorts(shelf);
  ports.memory.kept = false; // a first visit but for the shelf
  const { session: third } = await dancingSession(ports);
  third.settings.rename("Third");
  await expect.poll(() => third.keeping).not.toBeNull();
  const [kept] = shelf.kept.keys();
  const other = await third.accompany();
  await other.partners.useKept(kept, "Cactus");
  expect(third.document.companion).toMatchObject({ mesh: { file: "cactus.glb" }, motion: { files: [expect.any(String)] } });
});

test("films and files hold both", async () => {
  const { session, stage, duet, ports } = await paired();
  duet.move("seconds", () => ({ seconds: 0.5 }), false);
  await session.saving.openExport();
  const { exporting } = session.saving;
  await expect.poll(() => exporting?.state.kind, { timeout: 60_000 }).not.toBe("making");
  expect(exporting?.state).toMatchObject({ kind: "made" });
  exporting?.save();
  const { json } = split("made", ports.downloads[0].bytes);
  expect(json.meshes?.map(({ name }) => name)).toEqual(["Cactus", "Lamp"]);
  expect(json.animations).toHaveLength(1);
  expect(json.scenes?.[0]?.nodes?.map((node) => json.nodes?.[node]?.name)).toEqual(["Cactus", "root", "Lamp_place", "Lamp"]);

  await session.saving.openExport();
  exporting?.choose("film");
  await exporting?.film.make();
  const cache = duet.workspace?.cache;
  const seen = stage.films[0].moments.map(({ companion }) => companion?.shape);
  expect(seen.slice(0, 31)).toEqual(Array.from({ length: 31 }, (_, n) => cache?.at(Math.max(0, n - 15))?.shape));
  expect(seen[45]).toBe(cache?.at(0)?.shape);
});

test("a link holds one dancer, and says so", async () => {
  const { session } = await paired();
  await session.saving.openExport();
  const link = session.saving.exporting?.link;
  await link?.make("https://example.org/");
  expect(link?.state).toEqual({ kind: "none", why: "A link holds one dancer, and here are two." });
  expect(companionDocument(session.document)?.points.length).toBeGreaterThan(0);
});
