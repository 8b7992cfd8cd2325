import { expect, test } from "@playwright/test";
import { dance, documentOf, pointAt, dragBy, open, pause, pauseBetweenPoses, settled, vertices, watchErrors } from "./page";

test("a cold page dances with nothing clicked and nothing wrong", async ({ page }) => {
  const errors = watchErrors(page);
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.goto("/");
  await page.waitForFunction(() => rigless?.playing && rigless.frame > 0);
  const seconds = await page.evaluate(() => performance.now() / 1000);
  test.info().annotations.push({ type: "first motion", description: `${seconds.toFixed(2)} s` });
  const seen = new Set<number>();
  await expect.poll(async () => seen.add(await page.evaluate(() => rigless?.frame ?? 0)).size).toBeGreaterThan(9);
  await settled(page);
  const [a, b] = [await vertices(page, 0), await vertices(page, 30)];
  expect(a).not.toBeNull();
  expect(a).not.toEqual(b);
  await expect(page.getByText("This cactus has no bones.")).toBeVisible();
  expect(errors).toEqual([]);
});

test("dragging a dot makes a pose, the whole dance follows, and one undo brings it back bit by bit", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pauseBetweenPoses(page);
  const before = { document: await documentOf(page), dance: await dance(page) };
  const at = await pointAt(page, "Top");
  await dragBy(page, at, 70, -40);
  await expect(page.getByText(/^Top: \d+ cm/)).toBeVisible();
  await expect(page.getByText("held")).toBeVisible();
  const dot = await pointAt(page, "Top");
  expect(Math.hypot(dot.x - (at.x + 70), dot.y - (at.y - 40))).toBeLessThan(2); // under the pointer, from the first drag on
  await page.mouse.up();
  await expect(page.getByRole("heading", { name: "You made a pose." })).toBeVisible();
  await settled(page);
  const after = await documentOf(page);
  expect(after.examples.length).toBe(before.document.examples.length + 1);
  expect(await dance(page)).not.toBe(before.dance);
  await expect(page.getByText("This cactus has no bones.")).toHaveCount(0);

  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await documentOf(page)).examples.length).toBe(before.document.examples.length);
  await settled(page);
  expect(await documentOf(page)).toEqual(before.document);
  expect(await dance(page)).toBe(before.dance);

  await page.keyboard.press("Control+Shift+z");
  await settled(page);
  expect(await documentOf(page)).toEqual(after);
  expect(errors).toEqual([]);
});

test("Esc lets go of a dot and nothing has happened", async ({ page }) => {
  await open(page);
  await pause(page);
  const before = { document: await documentOf(page), dance: await dance(page) };
  const at = await pointAt(page, "Top");
  await dragBy(page, at, 60, 30);
  await expect(page.getByText("held")).toBeVisible();
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect(page.getByText("held")).toHaveCount(0);
  await settled(page);
  expect(await documentOf(page)).toEqual(before.document);
  expect(await dance(page)).toBe(before.dance);
});

test("dragging again at the same frame changes that pose, with the points open too; Space plays after a click", async ({ page }) => {
  await open(page);
  await pauseBetweenPoses(page);
  await page.getByRole("button", { name: "Points", exact: true }).click();
  const count = (await documentOf(page)).examples.length;
  for (const name of ["Top", "Left arm"]) {
    await dragBy(page, await pointAt(page, name), 30, -20);
    await page.mouse.up();
    await settled(page);
    expect((await documentOf(page)).examples.length).toBe(count + 1);
  }
  for (const clicked of ["Overlay", "Loop"]) {
    await page.getByRole("button", { name: clicked, exact: true }).click();
    const pressed = await page.getByRole("button", { name: clicked, exact: true }).getAttribute("aria-pressed");
    const playing = await page.evaluate(() => rigless!.playing);
    await page.keyboard.press("Space");
    expect(await page.evaluate(() => rigless!.playing)).toBe(!playing);
    await expect(page.getByRole("button", { name: clicked, exact: true })).toHaveAttribute("aria-pressed", pressed ?? "");
  }
  await page.getByRole("button", { name: "Loop", exact: true }).focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Shift+Tab");
  const loops = await page.getByRole("button", { name: "Loop", exact: true }).getAttribute("aria-pressed");
  await page.keyboard.press("Space");
  await expect(page.getByRole("button", { name: "Loop", exact: true })).not.toHaveAttribute("aria-pressed", loops ?? "");
});

test("the playhead scrubs, steps and goes from pose to pose", async ({ page }) => {
  await open(page);
  await pause(page);
  const ruler = page.getByRole("slider", { name: "Frame" });
  await ruler.fill("50");
  expect(await page.evaluate(() => rigless?.frame)).toBe(50);
  await page.keyboard.press(".");
  expect(await page.evaluate(() => rigless?.frame)).toBe(51);
  await page.keyboard.press(",");
  await page.keyboard.press(",");
  expect(await page.evaluate(() => rigless?.frame)).toBe(49);
  const { examples, motion } = await documentOf(page);
  const frames = examples.filter((pose) => pose.source.motion === motion.files.at(-1)).map((pose) => pose.source.frame);
  await page.keyboard.press("]");
  expect(frames).toContain(await page.evaluate(() => rigless?.frame));
  await page.keyboard.press("Space");
  await expect.poll(() => page.evaluate(() => rigless?.playing)).toBe(true);
});

test("a slider's travel is one step", async ({ page }) => {
  await open(page);
  const before = await documentOf(page);
  const slider = page.getByRole("slider", { name: "Volume" });
  const box = await slider.boundingBox();
  if (!box) throw new Error("no slider");
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 3, y);
  await page.mouse.down();
  for (let k = 0; k <= 6; k++) await page.mouse.move(box.x + box.width * (0.4 + 0.08 * k), y);
  await page.mouse.up();
  expect((await documentOf(page)).settings.volume).toBeGreaterThan(2);
  await settled(page);
  await page.keyboard.press("Control+z");
  expect(await documentOf(page)).toEqual(before);
});

test("another dance is one click and one undo away", async ({ page }) => {
  await open(page);
  const before = await documentOf(page);
  await page.getByRole("button", { name: "Try another dance" }).click();
  await expect.poll(async () => (await documentOf(page)).motion.files).toEqual(["disco.bvh"]);
  await settled(page);
  const start = await vertices(page, 0);
  expect(await vertices(page, 20)).not.toEqual(start);
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  expect(await documentOf(page)).toEqual(before);
  await settled(page);
});
