import { expect, test } from "@playwright/test";
import { dance, open, settled, watchErrors } from "./page";

test("a worker that is gone without a word is replaced, and the dance is as it was", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  const before = await dance(page);
  const [engine] = page.workers().filter((worker) => /worker/.test(worker.url()));
  await engine.evaluate(() => self.close());
  await page.getByRole("button", { name: "Motion" }).click();
  await page.getByRole("button", { name: /Disco/ }).click();
  await expect.poll(() => page.evaluate(() => rigless?.document.motion.files.at(-1))).toMatch(/disco/i);
  await settled(page);
  expect(await dance(page)).not.toBe(before);
  await page.keyboard.press("Control+z");
  await settled(page);
  expect(await dance(page)).toBe(before);
  expect(errors).toEqual([]);
});
