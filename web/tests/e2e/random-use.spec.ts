import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import { BOX_OBJ, dance, documentOf, drop, open, watchErrors } from "./page";

/** More and other steps: SEED=7 STEPS=2000 npx playwright test random-use */
const seed = Number(process.env["SEED"] ?? 1);
const steps = Number(process.env["STEPS"] ?? 16);

const KEYS = [
  ..."kcmfqstr1234[],.",
  ...["Space", "Enter", "Escape", "Delete", "Tab", "ArrowUp", "ArrowRight", "PageDown", "F6", "?"],
  ...["Control+z", "Control+z", "Control+Shift+z"],
];

const FILES = [
  { name: "box.obj", bytes: Buffer.from(BOX_OBJ) },
  { name: "words.obj", bytes: Buffer.from("nothing of its kind") },
  { name: "noise.mp3", bytes: Buffer.from("no song") },
  { name: "egg.glb", bytes: readFileSync(new URL("../../assets/characters/egg/egg.glb", import.meta.url)) },
  { name: "wave.bvh", bytes: readFileSync(new URL("../../assets/motions/wave.bvh", import.meta.url)) },
];

/** The same numbers from 0 to 1 for the same seed (mulberry32). */
function chance(from: number): () => number {
  let state = from;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Waits until nothing is under way: a file that is being opened shows itself after a while. */
async function rested(page: Page): Promise<void> {
  let last: unknown;
  let now: unknown = null;
  while (now !== last) {
    last = now;
    await page.waitForTimeout(800);
    await expect(page.locator("rigless-jobs").getByRole("progressbar")).toHaveCount(0, { timeout: 60_000 });
    await page.waitForFunction(() => rigless?.stale === 0 && !rigless.solving, null, { timeout: 60_000 });
    now = JSON.stringify(await documentOf(page));
  }
}

/** Presses a key as long as its button can be pressed; how often that was. */
async function press(page: Page, key: string, button: string): Promise<number> {
  let times = 0;
  while (await page.locator("rigless-top-bar").getByRole("button", { name: button, exact: true }).isEnabled()) {
    await page.keyboard.press(key);
    times++;
  }
  return times;
}

test("whatever is clicked, dragged, pressed and dropped, nothing breaks, and all of it can be undone and redone", async ({ page }) => {
  test.setTimeout(60_000 + 3_000 * steps);
  const errors = watchErrors(page);
  await open(page);
  const { width, height } = page.viewportSize()!;
  const next = chance(seed);
  const one = <T>(list: readonly T[]): T => list[Math.floor(next() * list.length)]!;
  const place = (): [number, number] => [next() * width, next() * height];
  const log: string[] = [];
  for (let k = 0; k < steps; k++) {
    const kind = next();
    if (kind < 0.35) {
      const key = one(KEYS);
      log.push(key);
      await page.keyboard.press(key);
    } else if (kind < 0.6) {
      const [x, y] = place();
      log.push(`click ${Math.round(x)} ${Math.round(y)}`);
      await page.mouse.click(x, y);
    } else if (kind < 0.9) {
      const dots = page.locator(".point.model");
      const box = next() < 0.6 ? await dots.nth(Math.floor(next() * (await dots.count()))).boundingBox() : null;
      const [x, y] = box ? [box.x + box.width / 2, box.y + box.height / 2] : place();
      const [dx, dy] = [(next() - 0.5) * 200, (next() - 0.5) * 200];
      log.push(`drag ${[x, y, dx, dy].map(Math.round).join(" ")}`);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + dx / 2, y + dy / 2);
      await page.mouse.move(x + dx, y + dy);
      await page.mouse.up();
    } else {
      const file = one(FILES);
      log.push(file.name);
      await drop(page, [file]);
    }
    if (await page.getByRole("dialog").isVisible()) await page.keyboard.press("Escape");
    expect(errors, log.join(", ")).toEqual([]);
  }
  for (let k = 0; k < 4; k++) await page.keyboard.press("Escape");
  await rested(page);
  const broken = await page.evaluate(() => {
    const frames = Array.from({ length: rigless?.frames ?? 0 }, (_, f) => f);
    return frames.filter((f) => rigless?.vertices(f)?.some((value) => !Number.isFinite(value)));
  });
  expect(broken, log.join(", ")).toEqual([]);

  await press(page, "Control+Shift+z", "Redo");
  await rested(page);
  const before = { document: await documentOf(page), dance: await dance(page) };
  const undone = await press(page, "Control+z", "Undo");
  expect(await press(page, "Control+Shift+z", "Redo"), log.join(", ")).toBe(undone);
  await rested(page);
  expect({ document: await documentOf(page), dance: await dance(page) }, log.join(", ")).toEqual(before);
  expect(errors, log.join(", ")).toEqual([]);
});
