import { expect, test } from "@playwright/test";
import { BOX_OBJ, documentOf, drop, open, settled, vertices, watchErrors } from "./page";

test("whoever takes over keeps the dance, and what they knew when they left", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  const cactus = await documentOf(page);
  await drop(page, [{ name: "box.obj", bytes: Buffer.from(BOX_OBJ) }]);
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe("box.obj");
  await page.getByRole("button", { name: "Motion", exact: true }).click();
  const motions = page.getByRole("region", { name: "Motion" });
  await motions.getByRole("button", { name: "Walk" }).click();
  await expect.poll(async () => (await documentOf(page)).motion.files).toEqual(["walk.bvh"]);

  await page.getByRole("button", { name: "Model", exact: true }).click();
  const models = page.getByRole("region", { name: "Model" });
  const box = await documentOf(page);
  await models.getByRole("button", { name: "Cactus" }).click();
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe(cactus.mesh.file);
  await expect(models.getByRole("button", { name: "Cactus" })).toHaveAttribute("aria-pressed", "true");
  expect(await documentOf(page)).toEqual({ ...cactus, motion: { files: ["walk.bvh"] } });
  await settled(page);
  expect(await vertices(page, 0)).not.toEqual(await vertices(page, 30));

  await page.keyboard.press("Control+z");
  expect(await documentOf(page)).toEqual(box);
  await models.getByRole("button", { name: "Cactus" }).click();
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe(cactus.mesh.file);
  await models.getByRole("button", { name: "box" }).click();
  await expect.poll(() => documentOf(page)).toEqual(box);
  expect(errors).toEqual([]);
});

test("of several choices the newest wins", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Motion", exact: true }).click();
  const motions = page.getByRole("region", { name: "Motion" });
  await page.route("**/walk*.bvh", async (route) => {
    await page.waitForTimeout(1500);
    await route.continue();
  });
  await motions.getByRole("button", { name: "Walk" }).click();
  await expect(motions.getByRole("button", { name: "Walk" })).toHaveAttribute("aria-busy", "true");
  await motions.getByRole("button", { name: "Hop" }).click();
  await expect(motions.getByRole("button", { name: "Walk" })).toHaveAttribute("aria-busy", "false");
  await page.waitForTimeout(2500);
  expect((await documentOf(page)).motion.files).toEqual(["hop.bvh"]);
});

test("each picture in the lists is there, and light", async ({ page }) => {
  await open(page);
  for (const panel of ["Model", "Motion"]) {
    await page.getByRole("button", { name: panel, exact: true }).click();
    const pictures = page.getByRole("region", { name: panel }).locator("img");
    await expect(pictures.first()).toBeVisible();
    for (const url of await pictures.evaluateAll((images) => images.map((image) => (image as HTMLImageElement).src))) {
      const response = await page.request.get(url);
      expect(response.ok(), url).toBe(true);
      expect((await response.body()).length, url).toBeLessThanOrEqual(8000);
    }
  }
});
