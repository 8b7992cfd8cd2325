import { expect, test } from "vitest";
import { dancingSession, listen } from "./app-support";

test("the rest shape and every pose get a picture, once the first moments are over", async () => {
  const { session, stage } = await dancingSession();
  const { thumbnails, document, context } = session;
  const told = listen(context, "thumbnails");
  const pictures = () => [thumbnails.rest, ...document.examples.map((pose) => thumbnails.of(pose))];
  expect(pictures().every((picture) => picture === null)).toBe(true);
  await expect.poll(() => pictures().includes(null)).toBe(false);
  expect(told).toHaveLength(1 + document.examples.length);
  expect(pictures()[0]).toMatch(new RegExp(`^picture of ${context.workspace.report?.vertices} at 80, `));
  expect(new Set(pictures()).size).toBeGreaterThan(2);

  stage.emit("context-restored", {});
  await expect.poll(() => thumbnails.rest, { interval: 1 }).toBeNull();
  await expect.poll(() => pictures().includes(null)).toBe(false);
});
