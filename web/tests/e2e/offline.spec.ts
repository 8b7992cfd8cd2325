import { readFileSync } from "node:fs";
import type { Server } from "node:http";
import type { AddressInfo } from "node:net";
import { fileURLToPath } from "node:url";
import { expect, type Page, test } from "@playwright/test";
import { type PreviewServer, preview } from "vite";
import { BOX_OBJ, dance, documentOf, drop, pause, settled, watchErrors } from "./page";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** The page from a server that can be stopped, which adds some words to the service worker. */
function serve(port: number, words: string): Promise<PreviewServer> {
  return preview({
    root,
    logLevel: "error",
    preview: { port, strictPort: false },
    plugins: [
      {
        name: "versions",
        configurePreviewServer: ({ middlewares }) => {
          middlewares.use("/service-worker.js", (_, response) => {
            response.setHeader("content-type", "text/javascript");
            response.end(`${readFileSync(`${root}dist/service-worker.js`, "utf8")}\n// ${words}`);
          });
        },
      },
    ],
  });
}

async function stop({ httpServer, close }: PreviewServer): Promise<void> {
  (httpServer as Server).closeAllConnections(); // those that browsers hold open would be waited for
  await close();
}

async function saved(page: Page, name: string): Promise<string> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
  return download.suggestedFilename();
}

test("after the first visit the page needs no network, and a new version waits until it is asked for", async ({ page, context }) => {
  const errors = watchErrors(page);
  const first = await serve(5190, "first");
  const { port } = first.httpServer.address() as AddressInfo;
  await page.goto(`http://rigless.localhost:${port}/`); // a name that is not this machine's own, and as safe
  await settled(page);
  const danced = await dance(page);
  await page.waitForFunction(() => navigator.serviceWorker.controller, null, { timeout: 60_000 });
  await context.setOffline(true);
  await stop(first);

  await page.reload();
  await settled(page);
  await pause(page);
  expect(await dance(page)).toBe(danced);
  await page.getByRole("button", { name: "Export" }).click();
  await expect(page.getByRole("dialog").getByRole("button", { name: "Save Cactus.glb" })).toBeEnabled({ timeout: 60_000 });
  expect(await saved(page, "Save Cactus.glb")).toBe("Cactus.glb");
  await page.keyboard.press("Escape");
  await drop(page, [{ name: "box.obj", bytes: Buffer.from(BOX_OBJ) }]);
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe("box.obj");
  await settled(page);
  expect(await saved(page, "Save")).toBe("box.rigless");
  expect(errors).toEqual([]);

  const second = await serve(port, "second");
  await context.setOffline(false);
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.update());
  await expect(page.getByText("A new version is there.")).toBeVisible();
  const state = () => page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.waiting?.state);
  expect(await state()).toBe("installed");
  const reloaded = page.waitForEvent("load");
  await page.getByRole("button", { name: "Reload" }).click();
  await reloaded;
  expect(await state()).toBe(undefined);
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe("box.obj");
  await stop(second);
});
