import { gzipSync } from "node:zlib";
import { expect, test } from "@playwright/test";

test("what the first load transfers fits in 480 kB, gzipped", async ({ page }) => {
  const urls = new Set<string>();
  page.on("request", (request) => {
    if (request.url().startsWith("http")) urls.add(request.url());
  });
  await page.goto("/");
  for (const kind of [/\.css$/, /\.js$/, /\.wasm$/, /\.glb$/, /\.bvh$/, /look-[^/]*\.js$/]) {
    await expect
      .poll(() => [...urls].filter((url) => kind.test(url)).length, { message: String(kind), timeout: 60_000 })
      .toBeGreaterThan(0);
  }
  await page.waitForLoadState("networkidle");
  await page.waitForTimeout(2_000);
  const all = [...urls];
  const ahead = all.findIndex((url) => /offline-[^/]*\.js$/.test(url)); // with it begins what is fetched for later
  const first = ahead < 0 ? all : all.slice(0, ahead);

  let total = 0;
  const table: string[] = [];
  for (const url of first) {
    const size = gzipSync(await (await page.request.get(url)).body()).length;
    total += size;
    table.push(`${size} ${new URL(url).pathname}`);
  }
  console.log(`first load: ${total} bytes gzipped`);
  expect(total, table.join("\n")).toBeLessThanOrEqual(480_000);
});
