import { expect, test, vi } from "vitest";
import { gliding, movingGlb } from "../support/clips";
import { TETRAHEDRON } from "../support/files";
import { assets, danced, dancingSession, file, listen, said } from "./app-support";

const BOX = `v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 4 -1\nv 1 4 -1\nv 1 4 1\nv -1 4 1
f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n`;

test("it begins with the first character and the first dance, saved and with nothing to undo", async () => {
  const { session } = await dancingSession();
  expect(session.document.mesh.file).toBe("cactus.glb");
  expect(session.document.motion.files).toEqual([assets.motions[0].file]);
  expect([session.history.saved, session.history.canUndo]).toEqual([true, false]);
});

test("a model that is dropped dances at once; each step can be taken back", async () => {
  const { session, ports } = await dancingSession();
  const before = session.document;
  ports.chosen = [file("box.obj", BOX)];
  await session.opening.pick("model");
  expect(ports.asked).toEqual(["model"]);
  expect(session.document.mesh.file).toBe("box.obj");
  expect(session.document.name).toBe("box");
  expect(session.selection.intro).toBe(false);
  expect(said(session.context).at(-1)).toBe("box.obj is 4.00 m tall.");
  expect(said(session.context)[0]).toMatch(/^Guessed \d+ points|^We found no places/);
  while (session.history.canUndo) session.history.undo();
  expect(session.document).toBe(before);
});

test("bad files say what is wrong and leave the work as it is", async () => {
  const { session } = await dancingSession();
  const before = session.document;
  await session.opening.files([file("broken.bvh", "HIERARCHY\nROOT Hips\n{\n")]);
  expect(session.context.notices.all[0]).toMatchObject({ bad: true });
  expect(said(session.context)[0]).toContain("broken.bvh");
  expect(session.context.notices.all[0].text).toMatch(/Your cactus is untouched\.$/);
  await session.opening.files([file("letter.docx", "Dear all")]);
  expect(said(session.context)[0]).toContain("letter.docx");
  expect(session.document).toBe(before);
});

test("of several motions the first plays and the others are in the list", async () => {
  const { session } = await dancingSession();
  const text = new TextDecoder().decode(await assets.load("motions/walk.bvh"));
  await session.opening.files([file("one.bvh", text), file("two.bvh", text)]);
  expect(session.document.motion.files).toEqual(["one.bvh"]);
  expect(session.motions.list.map(({ name }) => name)).toEqual(expect.arrayContaining(["one", "two"]));
  expect(said(session.context)).toEqual(["2 motions came in.", "one.bvh plays now."]);
});

test("a file of several motions asks which come in; one is not asked about", async () => {
  const { session } = await dancingSession();
  const told = listen(session.context, "clips");
  const { bytes } = movingGlb({ Walk: gliding(1), Run: gliding(2), Idle: gliding(0) });
  const before = session.document;
  for (const names of [[], ["Run", "Idle"]]) {
    const opened = session.opening.files([file("person.glb", bytes)]);
    await vi.waitFor(() => expect(session.opening.clipFiles?.asked?.clips.map(({ name }) => name)).toEqual(["Walk", "Run", "Idle"]));
    expect(session.document).toBe(before);
    session.opening.clipFiles?.answer(session.opening.clipFiles.asked?.clips.filter(({ name }) => names.includes(name)) ?? []);
    await opened;
  }
  expect([session.opening.clipFiles?.asked, told.length]).toEqual([null, 4]);
  expect(session.document.motion.files).toEqual(["person Run.bvh"]);
  expect(session.motions.list.map(({ name }) => name)).toEqual(expect.arrayContaining(["person Run", "person Idle"]));
  await session.opening.files([file("one.glb", movingGlb({ Walk: gliding(1) }).bytes)]);
  expect(session.document.motion.files).toEqual(["one.bvh"]);
});

test("a model that moves dances as before, and its motions are offered", async () => {
  const { session, ports } = await dancingSession();
  const { motion } = session.document;
  const { bytes } = movingGlb({ Walk: gliding(1) }, { mesh: true });
  for (const _ of ["opened", "and opened again"]) await session.opening.files([file("person.glb", bytes)]);
  expect(session.document).toMatchObject({ mesh: { file: "person.glb" }, motion });
  const { notices } = session.context;
  const offer = notices.all.find(({ title }) => title === "person.glb brings motions of its own.");
  offer?.actions[0].run();
  await vi.waitFor(() => expect(session.document.motion.files).toEqual(["person.bvh"]));
  // Asked for as a motion it leaves the model alone.
  ports.chosen = [file("other.glb", bytes)];
  await session.opening.pick("motion");
  expect(session.document).toMatchObject({ mesh: { file: "person.glb" }, motion: { files: ["other.bvh"] } });
});

test("a second AMC finds the skeleton that came before", async () => {
  const { session } = await dancingSession();
  const ASF = `:version 1.10\n:root\norder TX TY TZ RX RY RZ\n:bonedata\nbegin\nname leg\ndirection 0 -1 0\nlength 9\naxis 0 0 0 XYZ\nend
:hierarchy\nbegin\nroot leg\nend\n`;
  const amc = (z: number): string => `:FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\n2\nroot 0 0 ${z} 0 0 0\n`;
  await session.opening.files([file("a.asf", ASF), file("a_1.amc", amc(1))]);
  await session.opening.files([file("a_2.amc", amc(2))]);
  expect(session.document.motion.files).toEqual(["a.asf", "a_2.amc"]);
});

test("a project that was saved comes back as it was", async () => {
  const { session, ports } = await dancingSession();
  session.settings.rename("Mine");
  await session.saving.save();
  const mine = session.document;
  session.history.undo();
  session.selection.setPanel("poses");
  await session.opening.files([file("Mine.rigless", ports.downloads[0].bytes)]);
  expect(session.document).toEqual(mine);
  expect([session.history.saved, session.selection.panel]).toEqual([true, null]);
  expect(said(session.context)).toEqual(["Mine is open."]);
});

test("someone else takes over the dance, and comes back as they left; of several choices the newest wins", async () => {
  const { session } = await dancingSession();
  const told = listen(session.context, "coming");
  session.settings.rename("Kept");
  const kept = session.document;
  const [cactus, gnome] = session.cast.list;
  const first = session.opening.usePerformer(gnome);
  expect(session.opening.coming).toBe(gnome.file);
  const second = session.opening.useMotion(session.motions.list[1]);
  await Promise.all([first, second]);
  expect(session.document.mesh.file).toBe("cactus.glb");
  expect(session.document.motion.files).toEqual([assets.motions[1].file]);
  expect(session.opening.coming).toBeNull();
  expect(told.length).toBeGreaterThan(2);

  await session.opening.usePerformer(gnome);
  expect(session.document.mesh.file).toBe(gnome.file);
  expect(session.document.motion.files).toEqual([assets.motions[1].file]);
  await danced(session.context);
  await session.opening.usePerformer(cactus);
  expect(session.document).toEqual({ ...kept, motion: { files: [assets.motions[1].file] } });
});

test("a model without a solid body still opens, and the person makes the points", async () => {
  const { session } = await dancingSession();
  await session.opening.files([file("tetra.obj", TETRAHEDRON)]);
  expect(session.document.mesh.file).toBe("tetra.obj");
});

test("the places of a model that was taken back while it was understood are not another's", async () => {
  const { session } = await dancingSession();
  const { points } = session.document;
  const { history, context } = session;
  const stop = context.signals.on("document", () => {
    if (session.document.mesh.file !== "tetra.obj") return;
    stop();
    queueMicrotask(() => history.undo());
  });
  await session.opening.files([file("tetra.obj", TETRAHEDRON)]);
  expect(session.document).toMatchObject({ mesh: { file: "cactus.glb" }, points });
});

test("what is done while a model is still being understood stays done", async () => {
  const { session } = await dancingSession();
  const opened = session.opening.files([file("tetra.obj", TETRAHEDRON)]);
  await vi.waitFor(() => expect(session.document.mesh.file).toBe("tetra.obj"), { interval: 1, timeout: 20_000 });
  session.settings.rename("Crate");
  await opened;
  expect(session.document).toMatchObject({ name: "Crate", mesh: { file: "tetra.obj" } });
  expect(session.document.points.length).toBeGreaterThan(0);
});
