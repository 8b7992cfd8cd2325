import { afterEach, expect, test, vi } from "vitest";
import { Meter } from "../../src/app/meter";

afterEach(() => void vi.useRealTimers());

test("the median of the last second, told at most twice a second", () => {
  vi.useFakeTimers({ toFake: ["performance"] });
  let told = 0;
  const meter = new Meter(() => told++);
  expect(meter.median).toBeNull();
  meter.add(8);
  expect([meter.median, told]).toEqual([8, 1]);
  meter.add(100);
  meter.add(9);
  expect(told).toBe(1);
  vi.advanceTimersByTime(600);
  meter.add(10);
  expect([meter.median, told]).toEqual([10, 2]);
  vi.advanceTimersByTime(1100);
  meter.add(2);
  expect([meter.median, told]).toEqual([2, 3]);
});
