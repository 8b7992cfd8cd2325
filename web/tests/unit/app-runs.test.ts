import { expect, test } from "vitest";
import { movedRun, runsOf } from "../../src/app/runs";
import { dancingContext } from "./app-support";

test("the runs are where a control stands, and nowhere else", async () => {
  const { context } = await dancingContext();
  const { contacts, frames } = context.performance!;
  const points = context.document.points.length;
  const runs = runsOf(context.performance!, 4, points);
  expect(runs.length).toBeGreaterThan(0);
  const stands = Array.from({ length: frames }, (_, f) => contacts[f * points + 4] === 1);
  expect(stands).toEqual(Array.from({ length: frames }, (_, f) => runs.some(([a, b]) => a <= f && f < b)));
  expect(runsOf(context.performance!, 4, points + 1)).toEqual([]);
});

test("a run moves by its beginning, its end or as a whole, and stays in the clip", () => {
  const runs = [
    [2, 5],
    [10, 20],
  ] as const;
  expect(movedRun(runs, 0, "begin", 1, 30)).toEqual([[3, 5], runs[1]]);
  expect(movedRun(runs, 0, "begin", 9, 30)).toEqual([[4, 5], runs[1]]);
  expect(movedRun(runs, 1, "end", 99, 30)).toEqual([runs[0], [10, 30]]);
  expect(movedRun(runs, 1, "all", 99, 30)).toEqual([runs[0], [20, 30]]);
  expect(movedRun(runs, 0, "all", -9, 30)).toEqual([[0, 3], runs[1]]);
  expect(movedRun(runs, 7, "all", 1, 30)).toEqual(runs);
});
