import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import { documentOf, drop, open, pause, settled, watchErrors } from "./page";

/** What is to be seen around the companion's feet and above them. */
async function pictureOf(page: Page): Promise<Buffer> {
  const box = await page.getByRole("button", { name: /^Lamp: drag it/ }).boundingBox();
  if (!box) throw new Error("The companion is not there.");
  return page.screenshot({ clip: { x: box.x - 20, y: box.y - 120, width: box.width + 40, height: box.height + 120 } });
}

test("somebody comes to dance beside by keys alone, is moved and undone, saved, and there again", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pause(page);
  await page.keyboard.press("1");
  const card = page.locator("rigless-duet");
  await card.getByRole("button", { name: "Add" }).press("Enter");
  await card.getByRole("button", { name: "Lamp" }).press("Enter");
  await expect(card.getByText("Lamp dances beside")).toBeVisible();
  await expect(page.locator("rigless-app p[role=status]")).toHaveText("lamp dances beside");

  const handle = page.getByRole("button", { name: /^Lamp: drag it/ });
  const place = async () => (await documentOf(page)).companion?.offset.place;
  await expect(handle).toBeVisible();
  await handle.press("ArrowRight");
  await expect.poll(place).toEqual([1.7, -0.15]);
  await handle.blur();
  await page.keyboard.press("Control+z");
  expect(await place()).toEqual([1.6, -0.15]);

  const first = await pictureOf(page);
  for (let k = 0; k < 12; k++) await page.keyboard.press(".");
  await expect.poll(async () => first.equals(await pictureOf(page))).toBe(false);

  const saved = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  const path = await (await saved).path();
  const before = await documentOf(page);
  await card.getByRole("button", { name: "Remove Lamp" }).press("Enter");
  await expect(handle).toBeHidden();
  await drop(page, [{ name: "duet.rigless", bytes: readFileSync(path) }]);
  await expect.poll(() => documentOf(page)).toEqual(before);
  await settled(page);
  await page.keyboard.press("1");
  await expect(handle).toBeVisible();

  await page.reload();
  await settled(page);
  expect(await documentOf(page)).toEqual(before);
  expect(errors).toEqual([]);
});
