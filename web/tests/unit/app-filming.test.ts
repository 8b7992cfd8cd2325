import { expect, test } from "vitest";
import { FRAMES } from "../../src/app/filming";
import { dancingSession, said } from "./app-support";

async function filming() {
  const { session, stage, ports } = await dancingSession();
  await session.saving.openExport();
  const { exporting } = session.saving;
  exporting?.choose("film");
  const film = exporting?.film;
  if (!film) throw new Error("no film");
  await expect.poll(() => film.preview).not.toBeNull();
  return { session, stage, ports, film };
}

test("a film is the dance over and over, frame by frame, and the page plays on from where it was", async () => {
  const { session, stage, ports, film } = await filming();
  const { player, workspace } = session.context;
  expect(film.wish.seconds).toBe(2); // the dance lasts one
  expect(film.kinds).toEqual(["mp4", "webm"]);
  player.seek(12);
  player.play();
  await film.make();
  const [{ shot, moments }] = stage.films;
  expect(shot).toEqual({
    width: 1080,
    height: 1080,
    alone: false,
    clear: false,
    colour: null,
    kind: "mp4",
    frames: 60,
    fps: 30,
    turns: 0,
    song: null,
  });
  expect(moments.map(({ shape }) => shape)).toEqual(Array.from({ length: 60 }, (_, n) => workspace.cache.at(n % 30)?.shape));
  expect(moments.flatMap(({ again }, n) => (again ? [n] : []))).toEqual([30]);
  expect(moments[7].pose).toEqual(session.presenter.humanPose(7));
  expect([player.frame, player.playing]).toEqual([12, true]);
  expect(stage.shape).toBe(workspace.cache.at(12)?.shape);
  film.save();
  expect(ports.downloads.map(({ name, type }) => [name, type])).toEqual([["Cactus.mp4", "video/mp4"]]);
  expect(said(session.context)).toEqual([expect.stringMatching(/^Cactus\.mp4 is /)]);
});

test("a dance at half its speed is filmed at half its speed", async () => {
  const { session, stage, film } = await filming();
  session.context.player.pace = 0.5;
  expect(film.danceSeconds).toBe(2);
  await film.make();
  const { cache } = session.context.workspace;
  const shown = stage.films[0].moments.map(({ shape }) => shape);
  expect(shown).toEqual(Array.from({ length: 60 }, (_, n) => cache.at(Math.floor(n / 2))?.shape));
});

test("only a WebM is transparent; a turn of the camera takes some eight seconds", async () => {
  const { stage, film } = await filming();
  film.want({ clear: true, turntable: true, seconds: 17, frame: FRAMES[1], alone: true });
  expect(film.wish.kind).toBe("webm");
  await film.make();
  expect(stage.films[0].shot).toMatchObject({ width: 1080, height: 1920, kind: "webm", clear: true, alone: true, frames: 510, turns: 2 });
  film.want({ kind: "mp4" });
  expect(film.wish.clear).toBe(false);
  film.want({ clear: true });
  film.want({ colour: "#00b140" });
  expect(film.wish).toMatchObject({ clear: false, colour: "#00b140" });
  film.want({ clear: true });
  expect(film.wish.colour).toBeNull();
});

test("what is called off, changed or closed makes no film", async () => {
  const { session, stage, film } = await filming();
  const ends: (() => void)[] = [
    () => film.stop(),
    () => film.want({ seconds: 3 }),
    () => session.saving.exporting?.choose("model"),
    () => session.history.apply((document) => ({ ...document, name: "Spiky" })),
  ];
  for (const [n, end] of ends.entries()) {
    session.saving.exporting?.choose("film");
    film.want({ seconds: 30 });
    const making = film.make();
    while (!stage.films[n]?.moments.length) await new Promise((resolve) => setImmediate(resolve));
    end();
    await making;
    expect(film.state).toEqual({ kind: "wished" });
    expect(stage.films[n].moments.length).toBeLessThan(900);
  }
});
