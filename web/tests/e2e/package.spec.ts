// The npm package in a page of somebody else: the README's example, built by Vite and opened.

import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import { build, preview, type PreviewServer } from "vite";

const web = fileURLToPath(new URL("../../", import.meta.url));

let folder = "";
let server: PreviewServer;

test.beforeAll(async () => {
  test.setTimeout(180_000);
  folder = mkdtempSync(join(tmpdir(), "rigless-page-"));
  const npm = (cwd: string, ...args: string[]): string =>
    execFileSync("npm", [...args, "--offline"], { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
  const packed = npm(web, "pack", "--pack-destination", folder).trim().split("\n").at(-1) ?? "";
  const page = join(folder, "page");
  cpSync(join(web, "../examples/page"), page, { recursive: true });
  writeFileSync(join(page, "package.json"), '{ "type": "module" }');
  npm(page, "install", join(folder, packed));
  cpSync(join(web, "assets/motions/hop.bvh"), join(page, "dance.bvh"));
  await build({ root: page, configFile: false, logLevel: "error", assetsInclude: ["**/*.bvh"], build: { target: "es2022" } });
  server = await preview({ root: page, configFile: false, logLevel: "error", preview: { port: 0 } });
});

test.afterAll(async () => {
  await server.close();
  rmSync(folder, { recursive: true, force: true });
});

test("the package dances in a page that Vite built", async ({ page }) => {
  const wrong: string[] = [];
  page.on("pageerror", (error) => wrong.push(error.message));
  page.on("console", (message) => message.type() === "error" && !/favicon/.test(message.location().url) && wrong.push(message.text()));
  await page.goto(`http://localhost:${(server.httpServer.address() as AddressInfo).port}/`);

  /** Height of the highest pixel that is drawn; null: none is. */
  const top = (): Promise<number | null> =>
    page.evaluate(() => {
      const canvas = document.querySelector("canvas");
      const pixels = canvas?.getContext("2d")?.getImageData(0, 0, 400, 400).data ?? [];
      const first = [...pixels].findIndex((value, i) => i % 4 === 3 && value > 0);
      return first < 0 ? null : Math.floor(first / 1600);
    });
  await expect.poll(top, { timeout: 60_000 }).not.toBeNull();
  const seen = new Set<number | null>();
  await expect.poll(async () => seen.add(await top()).size, { timeout: 30_000 }).toBeGreaterThan(3);
  expect(wrong).toEqual([]);
});
