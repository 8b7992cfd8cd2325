import { expect, it } from "vitest";
import { beatAt, standingOf } from "../../src/sync/beside";

it("a dance that is no loop waits, dances, and begins anew", () => {
  expect([-7, 0, 9, 10, 25].map((at) => beatAt(at, 10, false))).toEqual([
    { frame: 0, round: 0 },
    { frame: 0, round: 0 },
    { frame: 9, round: 0 },
    { frame: 0, round: 1 },
    { frame: 5, round: 2 },
  ]);
});

it("a loop, whose last frame is its first, is a circle", () => {
  expect([-1, 0, 8, 9].map((at) => beatAt(at, 10, true))).toEqual([
    { frame: 8, round: -1 },
    { frame: 0, round: 0 },
    { frame: 8, round: 0 },
    { frame: 0, round: 1 },
  ]);
  expect(beatAt(2.9999999, 10, true).frame).toBe(3);
  expect(beatAt(5, 0, true)).toEqual({ frame: 0, round: 5 });
});

it("a companion begins at its place, turned, and goes on from where it came to", () => {
  const hand = { travel: Float32Array.of(0.5, 0, 1, 9, 0, 9) };
  const own = { travel: Float32Array.of(1, 0, 0, 1, 0, 4) };
  const at = (x: number, z: number, rounds: number, yaw: number): [number, number] => {
    const to = standingOf({ seconds: 0, place: [2, 0], yaw }, hand, own, rounds);
    return [Math.cos(to.yaw) * x + Math.sin(to.yaw) * z + to.x, -Math.sin(to.yaw) * x + Math.cos(to.yaw) * z + to.z].map(
      (value) => Math.round(1e6 * value) / 1e6 || 0,
    ) as [number, number];
  };
  expect(at(1, 0, 0, 0)).toEqual([2.5, 1]);
  expect(at(1, 0, 0, Math.PI / 2)).toEqual([2.5, 1]);
  expect(at(1, 4, 0, 0)).toEqual(at(1, 0, 1, 0));
  expect(at(1, 4, 0, Math.PI / 2)).toEqual([6.5, 1]);
  expect(at(1, 4, 0, Math.PI / 2)).toEqual(at(1, 0, 1, Math.PI / 2));
});
