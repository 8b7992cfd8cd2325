import { expect, test } from "vitest";
import { Player } from "../../src/app/player";
import { Clock } from "./app-support";

function playing(frames = 30) {
  const clock = new Clock();
  clock.now = performance.now();
  const player = new Player(clock);
  const seen: number[] = [];
  const told: string[] = [];
  player.setFrames(frames);
  player.on("frame", (frame) => seen.push(frame));
  player.on("again", () => told.push("again"));
  player.on("state", () => told.push("state"));
  return { clock, player, seen, told };
}

/** Plays for so many frames' time. */
function play(clock: Clock, frames: number): void {
  for (let k = 0; k < frames; k++) clock.tick(1000 / 30);
}

test("time goes on with the clock, at its speed, around the end", () => {
  const { clock, player, seen, told } = playing();
  player.play();
  clock.tick(1);
  play(clock, 10);
  expect(player.frame).toBeGreaterThanOrEqual(9);
  expect(seen.slice(0, 5)).toEqual([1, 2, 3, 4, 5]);
  const before = player.frame;
  player.nextSpeed();
  expect(player.speed).toBe(2);
  play(clock, 5);
  expect(player.frame - before).toBeGreaterThanOrEqual(9);
  play(clock, 10);
  expect(told).toContain("again");
  expect(player.playing).toBe(true);
  player.waiting = true;
  const still = player.frame;
  play(clock, 5);
  expect(player.frame).toBe(still);
  player.pause();
  expect(clock.waiting).toBe(0);
});

test("without a loop it stops at the end, and begins again from there", () => {
  const { clock, player } = playing(5);
  player.setLoop(false);
  player.play();
  play(clock, 10);
  expect([player.frame, player.playing]).toEqual([4, false]);
  player.toggle();
  expect([player.frame, player.playing]).toEqual([0, true]);
});

test("a tab that slept does not jump", () => {
  const { clock, player } = playing(300);
  player.play();
  clock.tick(60_000);
  expect(player.frame).toBeLessThanOrEqual(3);
});

test("it seeks within the clip, and steps around its ends", () => {
  const { player } = playing();
  player.seek(99);
  expect(player.frame).toBe(29);
  player.step(1);
  expect(player.frame).toBe(0);
  player.step(-1);
  expect(player.frame).toBe(29);
  player.setLoop(false);
  player.step(1);
  expect(player.frame).toBe(29);
  expect(player.clockWords).toBe("1.0 s");
  player.setFrames(10);
  expect(player.frame).toBe(0);
});
