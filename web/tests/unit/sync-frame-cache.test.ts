import { expect, test } from "vitest";
import type { ShapedFrame } from "../../src/engine/types";
import { FrameCache } from "../../src/sync/frame-cache";

const frame = (value: number): ShapedFrame => ({
  shape: Float32Array.of(value, value, value),
  volumeRatio: 1,
  root: [0, 0, 0, 0],
  milliseconds: 1,
});

test("frames still to be made come in the order in which the playhead meets them", () => {
  const cache = new FrameCache();
  cache.expire(5);
  cache.put(4, frame(4));
  expect(cache.todo(3)).toEqual([3, 0, 1, 2]);
  expect(cache.staleCount).toBe(4);
});

test("after a new solve of the same length the old frames stay to be shown", () => {
  const cache = new FrameCache();
  cache.expire(3);
  for (let k = 0; k < 3; k++) cache.put(k, frame(k));
  expect(cache.staleCount).toBe(0);
  cache.expire(3);
  expect(cache.staleCount).toBe(3);
  expect(cache.at(1)?.shape[0]).toBe(1);
  expect(cache.isFresh(1)).toBe(false);
  cache.put(1, frame(10));
  expect(cache.at(1)?.shape[0]).toBe(10);
  expect(cache.isFresh(1)).toBe(true);
});

test("a dance of another length, or another mesh, leaves no old frame", () => {
  const cache = new FrameCache();
  cache.expire(3);
  cache.put(0, frame(0));
  cache.expire(4);
  expect(cache.at(0)).toBeUndefined();
  cache.put(9, frame(9));
  expect(cache.staleCount).toBe(4);
  cache.clear();
  expect(cache.length).toBe(0);
  expect(cache.todo(0)).toEqual([]);
});

test("while a frame is missing the nearest one stands in, the earlier first", () => {
  const cache = new FrameCache();
  cache.expire(6);
  expect(cache.nearest(2)).toBeUndefined();
  cache.put(1, frame(1));
  cache.put(5, frame(5));
  expect(cache.nearest(2)?.shape[0]).toBe(1);
  expect(cache.nearest(3)?.shape[0]).toBe(1);
  expect(cache.nearest(4)?.shape[0]).toBe(5);
});

test("of a long dance those frames are kept that lie around the playhead, as many as there is room for", () => {
  const cache = new FrameCache(40 * 12);
  cache.expire(100);
  cache.put(0, frame(0));
  expect(cache.staleCount).toBe(39);
  expect(cache.todo(0)).toEqual([...Array(29).keys()].map((k) => k + 1).concat([90, 91, 92, 93, 94, 95, 96, 97, 98, 99]));
  for (const k of cache.todo(0)) cache.put(k, frame(k));
  cache.put(50, frame(50));
  expect(cache.at(50)).toBeUndefined();
  expect(cache.staleCount).toBe(0);
  expect(cache.follow(2)).toBe(false);
  expect(cache.at(91)).toBeUndefined();
  expect(cache.at(92)).toBeDefined();
  expect(cache.follow(20)).toBe(true);
  expect(cache.follow(60)).toBe(true);
  expect(cache.at(1)).toBeUndefined();
  expect(cache.todo(60)).toEqual([...Array(30).keys()].map((k) => k + 60).concat([...Array(10).keys()].map((k) => k + 50)));
});

test("a dance for which there is room is kept whole, wherever the playhead is", () => {
  const cache = new FrameCache(40 * 12);
  cache.expire(40);
  for (let k = 0; k < 40; k++) cache.put(k, frame(k));
  expect(cache.follow(39)).toBe(false);
  expect(cache.at(0)).toBeDefined();
});
