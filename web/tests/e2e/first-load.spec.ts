import { gzipSync } from "node:zlib";
import { expect, test } from "@playwright/test";

test("what the first load transfers fits in 450 kB, gzipped", async ({ page }) => {
  const sizes = new Map<string, number>();
  const pending: Promise<void>[] = [];
  page.on("response", (response) => {
    if (!response.url().startsWith("http")) return;
    pending.push(
      response.body().then((body) => {
        sizes.set(new URL(response.url()).pathname, gzipSync(body).length);
      }),
    );
  });
  await page.goto("/");
  await page.waitForLoadState("networkidle");
  await Promise.all(pending);

  const paths = [...sizes.keys()];
  for (const kind of [/^\/$/, /\.js$/, /\.css$/, /\.wasm$/]) expect(paths.filter((path) => kind.test(path))).not.toEqual([]);
  const total = [...sizes.values()].reduce((sum, size) => sum + size, 0);
  const table = [...sizes].map(([path, size]) => `${path} ${size}`).join("\n");
  test.info().annotations.push({ type: "first load", description: `${total} bytes gzipped` });
  expect(total, table).toBeLessThanOrEqual(450_000);
});
