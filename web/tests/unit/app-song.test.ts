import { expect, test } from "vitest";
import { dancingSession, file, said, TestShelf, testPorts } from "./app-support";

const song = (name: string, seconds: number) => file(name, new Uint8Array([seconds, 1, 2]));

async function singing(ports = testPorts()) {
  const { session, stage } = await dancingSession(ports);
  session.player.seek(0);
  await session.opening.files([song("tune.mp3", 20)]);
  const { sounds } = ports;
  return { session, stage, ports, sound: sounds[0]!, music: session.song! };
}

test("a song begins with the dance, goes on while that goes round, and follows the playhead, speed and waiting", async () => {
  const { session, ports, sound, music } = await singing();
  const { player } = session;
  const { clock } = ports;
  expect(said(session.context)).toEqual(["tune.mp3 plays with the dance."]);
  expect(sound.playing).toBe(false);
  player.seek(15);
  player.play();
  expect([sound.playing, sound.at]).toEqual([true, 0.5]);
  clock.now = performance.now();
  for (let k = 0; k < 8; k++) clock.tick(100); // the dance lasts a second
  expect(music.at).toBeGreaterThan(1);
  expect(music.at).toBeLessThan(1.4);
  player.nextSpeed();
  expect([sound.speed, sound.at]).toEqual([2, music.at]);
  player.wait(true);
  expect(sound.playing).toBe(false);
  player.wait(false);
  expect(sound.playing).toBe(true);
  player.seek(3);
  expect(sound.at).toBeCloseTo(0.1);
  player.pace = 0.5;
  player.seek(9);
  expect(sound.at).toBeCloseTo(0.6);
  player.pause();
  expect(sound.playing).toBe(false);
});

test("it can be muted and removed, and comes back; another takes its place; what cannot be played changes nothing", async () => {
  const { session, ports, sound, music } = await singing();
  session.player.play();
  music.mute(true);
  expect(sound.playing).toBe(false);
  music.mute(false);
  expect(sound.playing).toBe(true);
  music.remove();
  await expect.poll(() => music.kept).toBeNull();
  expect(sound.closed).toBe(true);
  session.context.notices.all[0]!.actions[0]!.run();
  await expect.poll(() => music.kept?.name).toBe("tune.mp3");
  await session.opening.files([song("other.ogg", 5)]);
  expect([music.kept?.name, ports.sounds.filter(({ closed }) => !closed).length]).toEqual(["other.ogg", 1]);
  await session.opening.files([song("broken.wav", 0)]);
  expect(said(session.context)[0]).toBe("broken.wav cannot be played by this browser.");
  expect(music.kept?.name).toBe("other.ogg");
});

test("it stays on this machine: kept with the project and in no project file, and it goes into films", async () => {
  const shelf = new TestShelf();
  const { session, ports, stage, music } = await singing(testPorts(shelf));
  await expect.poll(() => [...shelf.kept.values()].map((work) => work.song?.name)).toEqual(["tune.mp3"]);
  music.mute(true);
  await session.saving.openExport();
  const { exporting } = session.saving;
  exporting?.choose("film");
  const film = exporting!.film;
  expect(film.wish.silent).toBe(true);
  await film.make();
  film.want({ silent: false });
  await film.make();
  expect(stage.films.map(({ shot }) => shot.song?.[0] ?? null)).toEqual([null, 20]);
  await session.saving.save();
  expect(new TextDecoder("latin1").decode(ports.downloads.at(-1)!.bytes)).not.toContain("tune");
  await expect.poll(() => [...shelf.kept.values()].map((work) => work.song?.muted)).toEqual([true]);

  shelf.claims.clear(); // the page is gone
  const again = await dancingSession(testPorts(shelf));
  expect(again.session.song?.kept).toMatchObject({ name: "tune.mp3", muted: true });
  await again.session.keeping?.startFresh();
  expect(again.session.song?.kept).toBeNull();
});
