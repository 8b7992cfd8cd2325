import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Jobs } from "../../src/app/jobs";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test("a job is shown once it has lasted a while, with its step and its measure, and goes when it ends", async () => {
  const jobs = new Jobs();
  let changes = 0;
  jobs.on("change", () => changes++);
  let end = (): void => {};
  const running = jobs.run("Opening", ["Read", "Bind"], async (job) => {
    job.step(1);
    await new Promise<void>((resolve) => (end = resolve));
    job.progress(0.5);
    return "opened";
  });
  expect(jobs.shown).toEqual([]);
  vi.advanceTimersByTime(1000);
  expect(jobs.shown).toMatchObject([{ title: "Opening", step: 1, done: null }]);
  end();
  expect(await running).toBe("opened");
  expect(jobs.shown).toEqual([]);
  expect(changes).toBe(3);
});

test("its card cancels it, and it fails as its work does", async () => {
  const jobs = new Jobs();
  const running = jobs.run("Opening", [], ({ signal }) => {
    return new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason)));
  });
  vi.advanceTimersByTime(1000);
  jobs.shown[0].cancel();
  await expect(running).rejects.toMatchObject({ name: "AbortError" });
  expect(jobs.shown).toEqual([]);
});
