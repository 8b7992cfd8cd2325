import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Page } from "@playwright/test";
import { expect } from "@playwright/test";
import type {} from "../../src/ui/debug";

/** Every error that the page reports, from now on. */
export function watchErrors(page: Page): string[] {
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  return errors;
}

/** Waits until the present document has been solved and every frame is there. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => rigless?.performance && rigless.stale === 0 && !rigless.solving, null, { timeout: 60_000 });
}

export async function open(page: Page): Promise<void> {
  await page.goto("/");
  await settled(page);
}

export async function pause(page: Page): Promise<void> {
  if (await page.evaluate(() => rigless?.playing)) await page.getByRole("button", { name: "Pause" }).click();
}

/** Pauses at a frame that has no pose of its own. */
export async function pauseBetweenPoses(page: Page): Promise<void> {
  await pause(page);
  const { examples, motion } = await documentOf(page);
  const taken = new Set(examples.filter((pose) => pose.source.motion === motion.files.at(-1)).map((pose) => pose.source.frame));
  let frame = 40;
  while (taken.has(frame)) frame++;
  await page.getByRole("slider", { name: "Frame" }).fill(String(frame));
}

export function vertices(page: Page, frame: number): Promise<number[] | null> {
  return page.evaluate((f) => {
    const positions = rigless?.vertices(f);
    return positions ? Array.from(positions) : null;
  }, frame);
}

/** Every frame's vertices in one string of bits, for comparing. */
export function dance(page: Page): Promise<string> {
  return page.evaluate(async () => {
    const frames = Array.from({ length: rigless?.frames ?? 0 }, (_, f) => rigless?.vertices(f) ?? new Float32Array(0));
    const digest = await crypto.subtle.digest("SHA-256", await new Blob(frames as BlobPart[]).arrayBuffer());
    return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, "0")).join("");
  });
}

export function documentOf(page: Page) {
  return page.evaluate(() => {
    if (!rigless) throw new Error("The page is not there.");
    return rigless.document;
  });
}

/** The middle of a dot on the model, once the picture has come to rest. */
export async function pointAt(page: Page, name: string): Promise<{ x: number; y: number }> {
  const point = page.locator(".point.model", { has: page.locator(`xpath=self::*[contains(@aria-label, ", ${name},")]`) });
  let last = { x: NaN, y: NaN };
  await expect
    .poll(
      async () => {
        const box = await point.boundingBox();
        const now = box ? { x: box.x + box.width / 2, y: box.y + box.height / 2 } : { x: NaN, y: NaN };
        const still = Math.hypot(now.x - last.x, now.y - last.y) < 1;
        last = now;
        return still;
      },
      { intervals: [300] },
    )
    .toBe(true);
  return last;
}

export async function dragBy(page: Page, from: { x: number; y: number }, dx: number, dy: number): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let k = 1; k <= 8; k++) await page.mouse.move(from.x + (dx * k) / 8, from.y + (dy * k) / 8);
}

export interface DroppedFile {
  name: string;
  bytes: Buffer;
}

/** Drops files on the middle of the window. */
export async function drop(page: Page, files: readonly DroppedFile[]): Promise<void> {
  const data = await page.evaluateHandle(
    (list) => {
      const transfer = new DataTransfer();
      for (const { name, base64 } of list) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        transfer.items.add(new File([bytes], name));
      }
      return transfer;
    },
    files.map(({ name, bytes }) => ({ name, base64: bytes.toString("base64") })),
  );
  await page.locator("rigless-app").dispatchEvent("dragenter", { dataTransfer: data });
  await page.locator("rigless-app").dispatchEvent("drop", { dataTransfer: data });
}

const SHARED = new URL("../../../../shared/data/", import.meta.url);

/** A file of the test data beside the repository; null where there is none. */
export function shared(path: string): DroppedFile | null {
  const file = fileURLToPath(new URL(path, SHARED));
  return existsSync(file) ? { name: path.replace(/^.*\//, ""), bytes: readFileSync(file) } : null;
}

/** A closed box of 8 corners and 12 triangles, y up. */
export const BOX_OBJ = `v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 4 -1
v 1 4 -1
v 1 4 1
v -1 4 1
f 1 2 3 4
f 8 7 6 5
f 1 5 6 2
f 2 6 7 3
f 3 7 8 4
f 4 8 5 1
`;
