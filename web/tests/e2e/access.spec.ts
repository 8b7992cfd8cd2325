import AxeBuilder from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { documentOf, open, pauseBetweenPoses, settled } from "./page";

for (const scheme of ["light", "dark"] as const) {
  test(`axe finds nothing serious, ${scheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
    await open(page);
    for (const key of ["", "1", "2", "3", "4", "?"]) {
      if (key) await page.keyboard.press(key);
      const axe = new AxeBuilder({ page }).setLegacyMode(); // there are no frames: no page of its own for each answer
      const { violations } = await (scheme === "dark" ? axe.withRules("color-contrast") : axe).analyze(); // nothing else differs
      const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
      expect(
        serious.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ")}`),
        `after ${key}`,
      ).toEqual([]);
    }
  });
}

test("where motion is unwelcome the page opens paused", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  expect(await page.evaluate(() => rigless?.playing)).toBe(false);
});

test("a pose by the keyboard alone: arrows on a point of the list move it", async ({ page }) => {
  await open(page);
  await pauseBetweenPoses(page);
  const before = await documentOf(page);
  await page.keyboard.press("3");
  const top = page.locator("rigless-panel-points .item").first();
  await top.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  await expect.poll(async () => (await documentOf(page)).examples.length).toBe(before.examples.length + 1);
  await settled(page);
});

test("on a phone every button is large enough for a thumb", async ({ browser }) => {
  const context = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const page = await context.newPage();
  await open(page);
  for (const panel of [null, "Model", "Motion", "Points", "Poses"]) {
    if (panel) await page.getByRole("button", { name: panel, exact: true }).tap();
    const small = await page.evaluate(() => {
      const found: string[] = [];
      const visit = (root: ParentNode): void => {
        for (const element of root.querySelectorAll("*")) {
          if (element.shadowRoot) visit(element.shadowRoot);
          if (!element.matches("button, select, input:not([type=range]):not([role=switch])")) continue;
          const { width, height } = element.getBoundingClientRect();
          if (width > 0 && height > 0 && (width < 40 || height < 40) && !element.matches(".handle"))
            found.push(`${element.outerHTML.slice(0, 120)} ${width} x ${height}`);
        }
      };
      visit(document);
      return found;
    });
    expect(small, panel ?? "at rest").toEqual([]);
  }
  await context.close();
});
