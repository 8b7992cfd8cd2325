// What the graphics card makes of the nodes' maps, read back and compared with what the core makes of them.

import { readFileSync } from "node:fs";
import type { AddressInfo } from "node:net";
import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import { createServer, type ViteDevServer } from "vite";
import type {} from "./carried/carried";
import { documentOf, dragBy, drop, open, pauseBetweenPoses, pointAt, settled, watchErrors } from "./page";

const root = fileURLToPath(new URL("../../", import.meta.url));
let server: ViteDevServer;

test.beforeAll(async () => {
  server = await createServer({
    root,
    configFile: false,
    logLevel: "error",
    appType: "mpa",
    cacheDir: `${root}../build/figures-cache`,
    assetsInclude: ["**/*.glb", "**/*.bvh"],
    server: { port: 0, hmr: false },
  });
  await server.listen();
});

test.afterAll(() => server.close());

test("the card carries vertices to where the core does and turns normals by the map's gradient; light and shadow agree", async ({
  page,
}) => {
  await page.goto(`http://localhost:${(server.httpServer?.address() as AddressInfo).port}/tests/e2e/carried/index.html`);
  await page.waitForFunction(() => "carried" in window, null, { timeout: 60_000 });
  const found = await page.evaluate(() => window.carried("lamp", "hop.bvh", [0, 25, 83]));
  console.log(found);
  expect(found.numbers).toBe(12 * found.nodes);
  expect(found.moved).toBeGreaterThan(0.3);
  expect(found.apart).toBeLessThan(1.7e-5); // 1e-5 of the height
  expect(found.turned).toBeGreaterThan(20);
  expect(found.tilted).toBeLessThan(0.5);
  expect(found.other).toBeGreaterThan(0.03);
  expect(found.odd).toBeLessThan(0.003);
});

test("a model that a solid carries is dropped, dances and is dragged like any other", async ({ page }) => {
  const errors = watchErrors(page);
  await open(page);
  await drop(page, [{ name: "gnome.glb", bytes: readFileSync(`${root}assets/characters/gnome/gnome.glb`) }]);
  await expect.poll(async () => (await documentOf(page)).mesh.solve, { timeout: 60_000 }).toBe("solid");
  await expect(page.getByText(/^Guessed 7 points/)).toBeVisible({ timeout: 60_000 });
  await settled(page);
  await pauseBetweenPoses(page);
  await dragBy(page, await pointAt(page, "Left foot"), 30, -30);
  // From where it was: a hand's breadth, however the drag is seen.
  await expect(page.getByText(/^Left foot: \d\d cm (up|right), \d\d cm (up|right|in|out)/)).toBeVisible();
  await page.mouse.up();
  await expect.poll(async () => (await documentOf(page)).examples.length).toBe(1);
  await settled(page);
  expect(errors).toEqual([]);
});
