import { expect, test } from "vitest";
import { Session } from "../../src/app/session";
import { danced, dancingSession, said, testPorts } from "./app-support";

test("a session begins with the intro, builds the stage once, and closes it", async () => {
  const { session, stage } = await dancingSession();
  expect(session.selection.intro).toBe(true);
  expect(stage.told.filter((what) => what === "model")).toHaveLength(1);
  session.settings.set("volume", 2, false);
  await danced(session.context);
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(stage.told.filter((what) => what === "model")).toHaveLength(1);
  session.close();
  expect(stage.told.at(-1)).toBe("dispose");
});

test("the parts hold together: a drag while pins are armed is a pin, else a pose", async () => {
  const { session } = await dancingSession();
  const { dragging, pins, document } = session;
  dragging.nudge("top", "ArrowUp", false);
  dragging.drop();
  expect(session.document.examples).not.toEqual(document.examples);
  expect(pins.here).toHaveLength(0);
  const { examples } = session.document;
  await danced(session.context);
  pins.arm(true);
  dragging.nudge("top", "ArrowUp", false);
  dragging.drop();
  expect(pins.here).toHaveLength(1);
  expect(session.document.examples).toBe(examples);
});

test("without 3D graphics it says so, and why", async () => {
  const session = new Session(testPorts());
  await session.start(() => {
    throw new Error("no WebGL");
  });
  await expect.poll(() => said(session.context)).toEqual(["This browser shows no 3D graphics."]);
  expect(session.context.notices.all[0].text).toContain("(no WebGL)");
  session.close();
});

test("jobs tell their topic, and what the engine refuses is said", async () => {
  const { session } = await dancingSession();
  let jobs = 0;
  session.signals.on("jobs", () => jobs++);
  await session.jobs.run("Nothing", [], async () => {});
  expect(jobs).toBe(1);
  const { workspace } = session.context;
  const flat = workspace.library.addModel("flat.obj", { positions: new Float32Array(9), faces: Uint32Array.of(0, 1, 7) });
  session.history.apply((document) => ({ ...document, mesh: { ...document.mesh, file: flat } }));
  await workspace.sync();
  expect(session.context.notices.all[0]).toMatchObject({ bad: true, text: "The dance is as it was before." });
});

test("the session asks while a pin is to be made or spoken of", async () => {
  const { session } = await dancingSession();
  expect(session.asks).toBe(false);
  session.pins.arm(true);
  expect(session.asks).toBe(true);
  session.pins.arm(false);
  session.pins.choose("n1");
  expect(session.asks).toBe(true);
  session.pins.choose(null);
  expect(session.asks).toBe(false);
});
