import { expect, type Page, test } from "@playwright/test";
import { BOX_OBJ, dance, documentOf, drop, open, pause, settled, watchErrors } from "./page";

async function rename(page: Page, name: string): Promise<void> {
  await page.evaluate((to) => {
    const field = document.querySelector("rigless-app")?.shadowRoot?.querySelector("rigless-top-bar")?.shadowRoot?.querySelector("input");
    if (!field) throw new Error("The name is not there.");
    field.value = to;
    field.dispatchEvent(new Event("change", { bubbles: true }));
  }, name);
  await expect.poll(async () => (await documentOf(page)).name).toBe(name);
}

/** The browser has what was done last. */
async function kept(page: Page, name: string): Promise<void> {
  const names = () =>
    page.evaluate(
      () =>
        new Promise<string[]>((resolve) => {
          const opening = indexedDB.open("rigless");
          opening.onsuccess = () => {
            if (!opening.result.objectStoreNames.contains("projects")) return resolve([]);
            const all = opening.result.transaction("projects").objectStore("projects").getAll();
            all.onsuccess = () => {
              opening.result.close();
              resolve(all.result.map((project: { steps: { present: { name: string } } }) => project.steps.present.name));
            };
          };
        }),
    );
  await expect.poll(names).toContain(name);
}

test("what was done is there again after a reload, a closed tab and in a second one", async ({ page, context }) => {
  const errors = watchErrors(page);
  await open(page);
  await drop(page, [{ name: "box.obj", bytes: Buffer.from(BOX_OBJ) }]);
  await expect.poll(async () => (await documentOf(page)).mesh.file).toBe("box.obj");
  await rename(page, "Crate");
  await settled(page);
  await pause(page);
  await kept(page, "Crate");
  const before = await documentOf(page);
  const danced = await dance(page);

  await page.reload();
  await expect(page.getByText("Crate is as you left it.")).toBeVisible({ timeout: 60_000 });
  await settled(page);
  expect(await documentOf(page)).toEqual(before);
  expect(await dance(page)).toBe(danced);
  await page.keyboard.press("Control+z");
  expect((await documentOf(page)).name).toBe("box");
  await page.keyboard.press("Control+Shift+z");

  const second = await context.newPage();
  await second.goto("/");
  await expect(second.getByText("This is a copy of Crate.")).toBeVisible({ timeout: 60_000 });
  await second.close();

  await kept(page, "Crate");
  await page.close();
  const third = await context.newPage();
  await third.goto("/");
  await third.getByRole("button", { name: "Start fresh" }).waitFor({ timeout: 60_000 });
  expect(await documentOf(third)).toEqual(before);
  await third.getByRole("button", { name: "Start fresh" }).click();
  await expect.poll(async () => (await documentOf(third)).name).toBe("Cactus");
  await third.getByRole("button", { name: "Model", exact: true }).click();
  await third.getByRole("button", { name: /^Crate/ }).click();
  await expect.poll(() => documentOf(third)).toEqual(before);
  expect(errors).toEqual([]);
});

test("where the browser keeps nothing, that is said once, with what to do", async ({ page, context }) => {
  await context.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException("not here", "SecurityError");
    };
  });
  await open(page);
  await expect(page.getByText("This browser cannot keep your work.")).toHaveCount(0);
  await rename(page, "First");
  await expect(page.getByText("This browser cannot keep your work.")).toBeVisible();
  const download = page.waitForEvent("download");
  await page.locator("rigless-notices").getByRole("button", { name: "Save", exact: true }).click();
  expect((await download).suggestedFilename()).toBe("First.rigless");
});

test("Save does not depend on the network once the page has danced for a while", async ({ page, context }) => {
  const fetched: Promise<unknown>[] = [];
  page.on("request", (request) => fetched.push(request.response().then((response) => response?.finished())));
  const saving = page.waitForResponse(/\/project-saving-[^/]*\.js$/);
  await open(page);
  await saving;
  await Promise.all(fetched);
  await context.setOffline(true);
  await rename(page, "Far away");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  expect((await download).suggestedFilename()).toBe("Far away.rigless");
});
