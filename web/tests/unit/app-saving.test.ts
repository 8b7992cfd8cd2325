import { expect, test } from "vitest";
import { openProject } from "../../src/io/project-file";
import { dancingSession, said } from "./app-support";

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

test("the dance is exported as a GLB, of which the size is told", async () => {
  const { session, ports } = await dancingSession();
  await session.saving.exportModel();
  const [{ name, bytes, type }] = ports.downloads;
  expect([name, type]).toEqual(["Cactus.glb", "model/gltf-binary"]);
  expect(new TextDecoder().decode(bytes.subarray(0, 4))).toBe("glTF");
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + new DataView(bytes.buffer).getUint32(12, true))));
  expect(json.skins).toHaveLength(1);
  expect(json.accessors[json.animations[0].samplers[0].input].count).toBe(30);
  expect(said(session.context)).toEqual([expect.stringMatching(/^Cactus\.glb is [\d.]+ kB\.$/)]);
});

test("what cannot be saved says why", async () => {
  const { session } = await dancingSession();
  session.history.apply((document) => ({ ...document, motion: { files: ["gone.bvh"] } }));
  await session.saving.save();
  expect(said(session.context)).toContain("The project could not be saved.");
  expect(session.history.saved).toBe(false);
});
