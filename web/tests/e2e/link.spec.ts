import { readFileSync } from "node:fs";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { BOX_OBJ, dance, documentOf, drop, open, pause, pauseBetweenPoses, settled, watchErrors } from "./page";

async function linking(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Export" }).click();
  const panel = page.getByRole("dialog", { name: /^Take .* with you$/ });
  await panel.getByRole("button", { name: "Link", exact: true }).click();
  return panel;
}

test("a link opens to the same dance, and is one's own with the first change", async ({ page, browser, baseURL }) => {
  await open(page);
  await pauseBetweenPoses(page);
  await page.keyboard.press("k");
  await page.getByLabel("Name of the project").fill("Spiky");
  await page.getByLabel("Name of the project").press("Enter");
  await settled(page);
  const panel = await linking(page);
  const field = panel.getByLabel("The link");
  await expect(field).toHaveValue(/#dance=/);
  const link = await field.inputValue();
  expect(link.startsWith(`${baseURL}/#dance=`)).toBe(true);
  expect(link.length).toBeLessThan(1000);

  const theirs = await (await browser.newContext()).newPage();
  const errors = watchErrors(theirs);
  await theirs.goto(link);
  await settled(theirs);
  await expect(theirs.getByRole("heading", { name: "Spiky came with a link." })).toBeVisible();
  await expect(theirs.getByText(/^Make it yours/)).toBeVisible();
  expect(await documentOf(theirs)).toEqual(await documentOf(page));
  expect(await dance(theirs)).toBe(await dance(page));
  expect(new URL(theirs.url()).hash).not.toBe("");
  await pause(theirs);
  await theirs.getByRole("slider", { name: "Frame" }).fill("5");
  await theirs.keyboard.press("k");
  await expect.poll(() => new URL(theirs.url()).hash).toBe("");
  await expect(theirs.getByText("Kept in this browser")).toBeVisible();

  // A link that is pasted where Rigless is open already.
  await theirs.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await expect(theirs.getByRole("heading", { name: "Spiky came with a link." })).toBeVisible();
  await settled(theirs);
  expect(await documentOf(theirs)).toEqual(await documentOf(page));
  expect(errors).toEqual([]);
});

test("for an own model there is no link, and the word why", async ({ page }) => {
  await open(page);
  await pause(page);
  await drop(page, [{ name: "box.obj", bytes: Buffer.from(BOX_OBJ) }]);
  await expect.poll(async () => (await documentOf(page)).mesh.file, { timeout: 60_000 }).toBe("box.obj");
  await settled(page);
  const panel = await linking(page);
  await expect(panel).toContainText("this model is your own");
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    panel.getByRole("button", { name: "Save the project file" }).click(),
  ]);
  expect(download.suggestedFilename()).toBe("box.rigless");
  expect(
    readFileSync(await download.path())
      .subarray(0, 2)
      .toString(),
  ).toBe("PK");
});

test("a broken link says so, and the cactus dances", async ({ page }) => {
  await page.goto("/#dance=q64FAA");
  await settled(page);
  await expect(page.getByRole("heading", { name: "This link cannot be opened." })).toBeVisible();
  expect((await documentOf(page)).name).toBe("Cactus");
});
