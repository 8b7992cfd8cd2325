import { expect, test } from "vitest";
import { openProject } from "../../src/io/project-file";
import type { MadeFile } from "../../src/app/exporting";
import type { Session } from "../../src/app/session";
import { dancingSession, file, said } from "./app-support";
import { nod } from "./engine-support";

test("a project is downloaded with everything it names, and is saved then", async () => {
  const { session, ports } = await dancingSession();
  session.settings.rename("Disco / 2");
  expect(session.history.saved).toBe(false);
  await session.saving.save();
  expect(session.history.saved).toBe(true);
  const [{ name, bytes, type }] = ports.downloads;
  expect([name, type]).toEqual(["Disco 2.rigless", "application/zip"]);
  const opened = await openProject([{ name, bytes }]);
  expect(opened.document).toEqual(session.document);
  expect(opened.motion.text).toContain("Frames: 30");
});

test("a project is saved with every motion that was brought in, and they are there again when it is opened", async () => {
  const { session, ports } = await dancingSession();
  const { text } = nod();
  await session.opening.files([file("one.bvh", text), file("two.bvh", text)]);
  await session.saving.save();
  const [{ name, bytes }] = ports.downloads;
  const { session: later } = await dancingSession();
  await later.opening.files([file(name, bytes)]);
  expect(later.motions.list.filter(({ builtin }) => !builtin).map((entry) => entry.files)).toEqual([["one.bvh"], ["two.bvh"]]);
  expect(later.context.motionName).toBe("one.bvh");
});

test("what was said of a motion goes along where its name is taken by another", async () => {
  const { session, ports } = await dancingSession();
  const { text } = nod();
  await session.opening.files([file("one.bvh", text)]);
  session.history.apply((document) => ({ ...document, clips: { "one.bvh": { cut: [3, 12] } } }));
  await session.saving.save();
  const [{ name, bytes }] = ports.downloads;
  const { session: later } = await dancingSession();
  await later.opening.files([file("one.bvh", `${text}\n\n`)]);
  await later.opening.files([file(name, bytes)]);
  expect(later.context.motionName).toBe("one 2.bvh");
  expect(later.document.clips).toEqual({ "one 2.bvh": { cut: [3, 12] } });
});

/** Until the file is there. */
async function made({ saving }: Session): Promise<MadeFile> {
  await expect.poll(() => saving.exporting?.state.kind, { timeout: 60_000 }).toBe("made");
  const state = saving.exporting?.state;
  if (state?.kind !== "made") throw new Error("nothing was made");
  return state.file;
}

test("the dance is exported as a GLB, of which size and likeness are told before it is saved", async () => {
  const { session, ports } = await dancingSession();
  await session.saving.openExport();
  const file = await made(session);
  expect(file).toMatchObject({ name: "Cactus.glb", clips: 1, frames: 30, notes: [] });
  expect(file.likeness?.worst).toBeLessThan(0.02);
  expect(ports.downloads).toEqual([]);
  session.saving.exporting?.save();
  expect(session.saving.exporting?.state.kind).toBe("closed");
  const [{ name, bytes, type }] = ports.downloads;
  expect([name, type]).toEqual(["Cactus.glb", "model/gltf-binary"]);
  expect(new TextDecoder().decode(bytes.subarray(0, 4))).toBe("glTF");
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + new DataView(bytes.buffer).getUint32(12, true))));
  expect(json.skins).toHaveLength(1);
  expect(json.accessors[json.animations[0].samplers[0].input].count).toBe(30);
  expect(said(session.context)).toEqual([expect.stringMatching(/^Cactus\.glb is [\d.]+ kB\.$/)]);
});

test("all motions leave in one file, and the one that plays goes on", async () => {
  const { session } = await dancingSession();
  await session.saving.openExport();
  session.saving.exporting?.want({ all: true, inPlace: true });
  const file = await made(session);
  expect(file.clips).toBe(session.motions.list.length);
  expect(file.frames).toBe(30 * file.clips);
  const json = JSON.parse(new TextDecoder().decode(file.bytes.subarray(20, 20 + new DataView(file.bytes.buffer).getUint32(12, true))));
  expect(json.skins).toHaveLength(1);
  expect(json.animations.map(({ name }: { name: string }) => name)).toContain("Folk_dance");
  expect(session.context.motionName).toBe("hop.bvh");
  session.saving.exporting?.want({ fps: 60 });
  session.saving.exporting?.stop();
  expect(session.saving.exporting?.state.kind).toBe("stopped");
}, 120_000);

test("what cannot be saved says why", async () => {
  const { session } = await dancingSession();
  session.history.apply((document) => ({ ...document, motion: { files: ["gone.bvh"] } }));
  await session.saving.save();
  expect(said(session.context)).toContain("The project could not be saved.");
  expect(session.history.saved).toBe(false);
});
