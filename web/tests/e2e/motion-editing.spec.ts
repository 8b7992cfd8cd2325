import { expect, test } from "@playwright/test";
import { documentOf, open, pause, settled, watchErrors } from "./page";

test("a motion is cut by its handles, looped, mirrored and sped up, and undo takes it all back", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pause(page);
  const before = await documentOf(page);
  const [motion] = before.motion.files;
  const said = async () => (await documentOf(page)).clips?.[motion];
  await page.getByRole("button", { name: "Motion", exact: true }).click();
  const end = page.getByRole("slider", { name: "End of the dance" });
  await expect(end).toHaveAttribute("aria-valuenow", "116");

  // By the hand, which snaps to a step that is near; then by the keys.
  const lane = await page.locator("rigless-take .lane").boundingBox();
  const handle = await end.boundingBox();
  if (!lane || !handle) throw new Error("There are no handles.");
  await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
  await page.mouse.down();
  await page.mouse.move(lane.x + (lane.width * 74.6) / 116, handle.y + 8, { steps: 6 });
  await expect(page.locator("rigless-take .tip")).toHaveText("0.0 s to 2.5 s");
  await page.mouse.up();
  await settled(page);
  expect(await said()).toEqual({ cut: [0, 75] });
  expect(await page.evaluate(() => rigless?.frames)).toBe(76);
  await page.getByRole("slider", { name: "Begin of the dance" }).press("ArrowRight");
  await expect.poll(said).toEqual({ cut: [1, 75] });

  await page.getByRole("switch", { name: "Mirrored" }).click();
  await page.getByRole("combobox", { name: "Speed" }).selectOption("2");
  await page.getByRole("switch", { name: "Make it a loop" }).click();
  await settled(page);
  const all = await said();
  expect(all).toMatchObject({ speed: 2, mirror: true, loop: true });
  const ends = await page.evaluate(() =>
    [0, (rigless?.frames ?? 1) - 1].map((frame) => rigless?.vertices(frame)?.filter((_, i) => i % 3 === 1)),
  );
  const [first, last] = ends.map((heights) => Array.from(Object.values(heights ?? {})));
  expect(first.length).toBeGreaterThan(500);
  first.forEach((height, i) => expect(Math.abs(height - last[i])).toBeLessThan(1e-3));

  await page.getByText("Does the human look wrong?").click();
  await page.getByRole("button", { name: "Turn by a quarter" }).click();
  await expect.poll(said).toEqual({ ...all, file: { turn: 90 } });
  await page.getByRole("combobox", { name: "Left foot" }).selectOption("RightFoot");
  await expect.poll(said).toEqual({ ...all, file: { turn: 90, joints: { "left foot": "RightFoot", "right foot": "LeftFoot" } } });
  for (let step = 0; step < 7; step++) await page.keyboard.press("Control+z");
  await expect.poll(() => documentOf(page)).toEqual(before);
  expect(errors).toEqual([]);
});
