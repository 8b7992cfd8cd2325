import { expect, test } from "@playwright/test";
import type { Page } from "@playwright/test";
import { dance, documentOf, pointAt, dragBy, open, pause, pauseBetweenPoses, settled, watchErrors } from "./page";

const clip = async (page: Page) => (await documentOf(page)).clips?.["hop.bvh"];
const slider = (page: Page) => page.getByRole("slider", { name: "Frame" });

test("contacts and flights are moved on the timeline, by hand and by keys, undone, and given back to the motion", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pause(page);
  const before = await dance(page);
  const { contacts, frames, flights } = await page.evaluate(() => {
    const { contacts, frames, flights } = rigless!.performance!;
    return { contacts: Array.from(contacts), frames, flights };
  });
  const C = contacts.length / frames;
  const left = 4;
  expect((await documentOf(page)).points[left].id).toBe("left-edge");
  const runs = contacts
    .flatMap((_, i): number[] => (i % C === left ? [contacts[i]] : []))
    .join("")
    .matchAll(/1+/g);
  const expected = [...runs].map((run) => [run.index, run.index + run[0].length]);

  const row = page.locator("rigless-contact-rows .pair").filter({ hasText: "Left edge" });
  await row.locator(".who").click();
  const bar = row.locator(".bar").first();
  const box = (await bar.boundingBox())!;
  const wide = (await row.locator(".lane").boundingBox())!.width;
  const x = box.x + box.width;
  await dragBy(page, { x, y: box.y + box.height / 2 }, (-5 * wide) / (frames - 1), 0);
  await page.mouse.up();
  await settled(page);
  expect((await clip(page))?.contacts?.["left-edge"]).toEqual([[expected[0][0], expected[0][1] - 5], ...expected.slice(1)]);
  expect(await dance(page)).not.toBe(before);

  await bar.focus();
  await page.keyboard.press("ArrowRight");
  expect((await clip(page))?.contacts?.["left-edge"]?.[0]).toEqual([expected[0][0], expected[0][1] - 4]);
  await page.keyboard.press("Delete");
  expect((await clip(page))?.contacts?.["left-edge"]).toEqual(expected.slice(1));
  for (let k = 0; k < 3; k++) await page.keyboard.press("Control+z");
  await settled(page);
  expect(await dance(page)).toBe(before);

  await page.keyboard.press("Control+Shift+z");
  await row.getByRole("button", { name: "as in the motion again" }).click();
  expect((await clip(page))?.contacts).toEqual({});
  await settled(page);
  expect(await dance(page)).toBe(before);

  const air = page.locator("rigless-contact-rows .pair").filter({ hasText: "In the air" });
  await air.locator(".who").click();
  await air.locator(".bar").first().focus();
  await page.keyboard.press("Delete");
  await settled(page);
  expect((await clip(page))?.flights).toEqual(flights.slice(1));
  expect(await page.evaluate(() => rigless!.performance!.flights)).toEqual(flights.slice(1));
  expect(errors).toEqual([]);
});

test("a pin is made by a drag and kept; two that contradict each other are told", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await pauseBetweenPoses(page);
  const poses = (await documentOf(page)).examples.length;
  await page.getByRole("button", { name: "Pin", exact: true }).click();
  await dragBy(page, await pointAt(page, "Left arm"), 60, -50);
  await page.mouse.up();
  await settled(page);
  const [pin] = (await clip(page))?.pins ?? [];
  expect(pin).toMatchObject({ point: "left-arm", kind: "place" });
  expect((await documentOf(page)).examples.length).toBe(poses);
  await expect(page.getByRole("heading", { name: `Left arm is held at frame ${pin.frame}.` })).toBeVisible();
  expect(await page.evaluate(() => rigless!.performance!.missed.worst[0])).toBeLessThan(1e-4);

  // Still against a place that is far from the frame before.
  await slider(page).fill(String(pin.frame - 1));
  await page.keyboard.press("c"); // the selected point, where it is
  await slider(page).fill(String(pin.frame));
  await settled(page);
  await page.getByRole("button", { name: `Pin at frame ${pin.frame}:` }).click();
  await page.getByRole("button", { name: "Stand still" }).click();
  await settled(page);
  expect((await clip(page))?.pins).toHaveLength(2);
  await page.getByRole("button", { name: "Done" }).click();
  await page.getByRole("button", { name: "Pin", exact: true }).click();
  await dragBy(page, await pointAt(page, "Left arm"), 70, 60);
  await page.mouse.up();
  await settled(page);
  expect((await clip(page))?.pins).toHaveLength(3);
  await expect(page.getByRole("heading", { name: "A pin is not kept." })).toBeVisible();
  await expect(page.getByText(/is missed by \d+ cm\. The pin of Left arm at frame \d+ stands against it/)).toBeVisible();
  await page.getByRole("button", { name: "Delete it" }).click();
  await settled(page);
  await expect(page.getByRole("heading", { name: "A pin is not kept." })).toHaveCount(0);
  expect((await clip(page))?.pins).toHaveLength(2);
  expect(errors).toEqual([]);
});

test("the page asks for the pose that teaches most; the answer closes the question", async ({ page }) => {
  await open(page);
  await pause(page);
  // Without the poses of its own the dance is guesswork.
  await page.getByRole("button", { name: "Poses", exact: true }).click();
  for (let n = (await documentOf(page)).examples.length; n > 2; n--)
    await page
      .getByRole("button", { name: /^Delete the pose/ })
      .last()
      .click();
  await settled(page);
  const { have, want } = await page.evaluate(() => rigless!.performance!.enough);
  expect(want).toBeGreaterThan(have);
  await expect(page.getByText(have < 4 ? `${have} of 4 poses` : "Better still", { exact: true })).toBeVisible();
  await page.getByRole("button", { name: "Teach me here" }).click();
  await expect(page.getByRole("heading", { name: "Show me this one." })).toBeVisible();
  const frame = await page.evaluate(() => rigless!.frame);
  expect(await page.evaluate(() => rigless!.performance!.ask[0].frame)).toBe(frame);
  await page.keyboard.press("Enter");
  await settled(page);
  await expect(page.getByRole("heading", { name: "Show me this one." })).toHaveCount(0);
  expect((await documentOf(page)).examples.at(-1)?.source).toEqual({ motion: "hop.bvh", frame });
  expect(await page.evaluate((f) => rigless!.performance!.coverage[f], frame)).toBeLessThan(0.01);
});

test("symmetry: a switch, a partner that mirrors what the hand does", async ({ page }) => {
  await open(page);
  await pauseBetweenPoses(page);
  const before = await dance(page);
  await page.getByRole("switch", { name: "Symmetry" }).click();
  await settled(page);
  expect((await documentOf(page)).settings.symmetry).toBe(false);
  expect(await dance(page)).not.toBe(before);
  await dragBy(page, await pointAt(page, "Left arm"), 40, -40);
  await page.keyboard.press("m");
  await page.mouse.up();
  await settled(page);
  const { points, examples } = await documentOf(page);
  const [a, b] = ["left-arm", "right-arm"].map((id) => {
    const rest = points.find((point) => point.id === id)!.position;
    return examples.at(-1)!.points[id].map((value, k) => value - rest[k]);
  });
  expect([-b[0], b[1], b[2]]).toEqual(a.map((value) => expect.closeTo(value, 3)));
});

test("how soon the new dance is there after a drag (printed, not judged)", async ({ page }) => {
  await open(page);
  const times: number[] = [];
  for (let k = 0; k < 5; k++) {
    await pauseBetweenPoses(page);
    await dragBy(page, await pointAt(page, "Top"), 30, -10 * (k + 1));
    await page.evaluate(() => {
      const old = rigless!.performance;
      const examples = rigless!.document.examples.length;
      let begin = 0;
      const look = (): void => {
        if (begin === 0 && rigless!.document.examples.length > examples) begin = performance.now();
        if (begin > 0 && rigless!.performance !== old && rigless!.stale < rigless!.frames)
          document.title = String(performance.now() - begin);
        else setTimeout(look);
      };
      document.title = "";
      look();
    });
    await page.mouse.up();
    await expect(page).toHaveTitle(/^[\d.]+(e-\d+)?$/);
    times.push(Number(await page.title()));
    await settled(page);
    await page.keyboard.press("Control+z");
    await settled(page);
  }
  const sorted = times.toSorted((a, b) => a - b);
  console.log(
    `a dragged pose to the first frame of the new dance: median ${sorted[2].toFixed(0)} ms, ` +
      `${sorted[0].toFixed(0)} to ${sorted[4].toFixed(0)}`,
  );
  expect(times).toHaveLength(5);
});
