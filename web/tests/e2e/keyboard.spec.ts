import { expect, type Page, test } from "@playwright/test";
import { documentOf, open, settled, watchErrors } from "./page";

/** What has the focus, as a person would call it. */
function focus(page: Page): Promise<{ part: string; name: string }> {
  return page.evaluate(() => {
    let element = document.activeElement;
    const path: string[] = [];
    while (element) {
      path.push(element.localName);
      const inner = element.shadowRoot?.activeElement;
      if (!inner) break;
      element = inner;
    }
    const said = element?.getAttribute("aria-label") ?? element?.textContent?.trim() ?? "";
    const labelled = element?.id === "slider" ? (element.getRootNode() as ShadowRoot).querySelector("label")!.textContent! : "";
    return { part: path.slice(1).join(" "), name: labelled || said };
  });
}

async function press(page: Page, key: string, times = 1): Promise<void> {
  for (let k = 0; k < times; k++) await page.keyboard.press(key);
}

test.use({ viewport: { width: 1000, height: 560 } });

test("Tab goes as the eye does and enters each list once; F6 spares most of it", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await page.keyboard.press("Tab"); // brings what makes lists one stop
  await page.waitForTimeout(1_000);
  await page.keyboard.press("Shift+Tab");
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());

  const parts: string[] = [];
  const count: Record<string, number> = {};
  for (let k = 0; k < 24; k++) {
    await page.keyboard.press("Tab");
    const { part, name: words } = await focus(page);
    if (part === "" || (parts.length > 1 && words === "Name of the project")) break; // around
    const [first] = part.replace(/^rigless-app ?/, "").split(" ");
    const name = first || "none";
    count[name] = (count[name] ?? 0) + 1;
    if (parts.at(-1) !== name) parts.push(name);
  }
  const at = (name: string): number => parts.findIndex((part) => part === name);
  expect(parts).toContain("rigless-timeline");
  expect(at("rigless-top-bar")).toBeLessThan(at("rigless-rail"));
  expect(at("rigless-rail")).toBeLessThan(at("rigless-inspector"));
  expect(at("rigless-inspector")).toBeLessThan(at("rigless-transport"));
  expect(at("rigless-transport")).toBeLessThan(at("rigless-timeline"));
  expect(Math.max(...Object.values(count)), JSON.stringify(count)).toBeLessThanOrEqual(6);

  // F6: five parts, and the farthest stop of any is no more than twelve presses away.
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  const heads: string[] = [];
  for (let k = 0; k < 5; k++) {
    await page.keyboard.press("F6");
    heads.push((await focus(page)).part);
  }
  expect(heads.map((head) => head.replace(/^rigless-app ?/, "").split(" ")[0])).toEqual([
    "rigless-top-bar",
    "rigless-rail",
    expect.stringMatching(/div|button|main/),
    "rigless-inspector",
    "rigless-transport",
  ]);
  expect(5 + Math.max(...Object.values(count))).toBeLessThanOrEqual(12);
});

test("a pose taught and a file taken along by the keyboard alone; every change is spoken, a burst of arrows is one step", async ({
  page,
}) => {
  test.setTimeout(240_000);
  const errors = watchErrors(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  const spoken = page.locator("rigless-app").locator("p[role=status]");
  const before = await documentOf(page);
  const frames = before.examples.map((pose) => pose.source.frame);

  // To the timeline, and to a frame of its own.
  await page.keyboard.press("F6");
  await page.waitForTimeout(1_000);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await press(page, "F6", 5);
  expect((await focus(page)).part).toContain("rigless-transport");
  await page.keyboard.press("Tab");
  expect((await focus(page)).name).toBe("Frame");
  await press(page, "ArrowRight", 40);
  while (frames.includes(await page.evaluate(() => rigless!.frame))) await page.keyboard.press("ArrowRight");

  // To the dots, to the second of them, and up.
  await press(page, "Shift+F6", 2);
  expect((await focus(page)).name).toMatch(/^1, /);
  await page.keyboard.press("PageDown");
  const { name } = await focus(page);
  expect(name).toMatch(/^2, /);
  const point = /^2, ([^,]+),/.exec(name)![1]!;
  await page.waitForTimeout(1_000); // until the stage shows that frame
  await press(page, "ArrowUp", 4);
  await expect.poll(async () => (await documentOf(page)).examples.length, { timeout: 20_000 }).toBe(before.examples.length + 1);
  await expect(spoken).toHaveText(new RegExp(`^${point} 4 cm up.*, ${before.examples.length + 1} poses$`));
  await settled(page);

  // A setting, with arrows of its own; and both back.
  await page.keyboard.press("F6");
  expect((await focus(page)).name).toBe("Volume");
  await page.keyboard.press("ArrowRight");
  await expect(spoken).toHaveText(/^Volume 1/);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(() => documentOf(page)).toEqual(before);
  await expect(spoken).toHaveText(/is gone, \d+ poses$/);
  await page.keyboard.press("Control+Shift+z");
  await expect.poll(async () => (await documentOf(page)).examples.length).toBe(before.examples.length + 1);
  await settled(page);

  // To Export, the last of the bar at the top, and out.
  await press(page, "Shift+F6", 3);
  expect((await focus(page)).part).toContain("rigless-top-bar");
  await page.keyboard.press("Tab");
  await page.keyboard.press("End");
  expect((await focus(page)).name).toBe("Export");
  await page.keyboard.press("Enter");
  const dialog = page.locator("rigless-export dialog");
  await expect(dialog).toBeVisible();
  await expect(dialog.getByRole("button", { name: /^Save / })).toBeEnabled({ timeout: 60_000 });
  const coming = page.waitForEvent("download");
  for (let k = 0; k < 20 && !(await focus(page)).name.startsWith("Save "); k++) await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  expect((await coming).suggestedFilename()).toMatch(/\.(glb|gltf|zip)$/);
  expect(errors).toEqual([]);
});
