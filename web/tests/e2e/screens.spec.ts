import { expect, type Page, test } from "@playwright/test";
import { open } from "./page";

type Size = readonly [width: number, height: number];
const FINGERS: readonly Size[] = [
  [360, 640],
  [390, 844],
  [768, 1024],
];
const MICE: readonly Size[] = [
  [960, 540],
  [1024, 600],
  [1366, 625],
  [1440, 900],
  [1920, 1080],
  [2560, 1440],
];

/** What lies outside of the window or over something else, and what is too small for a thumb. */
function faults(page: Page, touch: boolean): Promise<string[]> {
  return page.evaluate((thumbs) => {
    const found: string[] = [];
    const root = document.querySelector("rigless-app")!.shadowRoot!;
    const inside = (element: Element): Element[] => {
      const below = [...(element.shadowRoot ?? element).querySelectorAll("*")];
      return [element, ...below.flatMap((one) => (one.shadowRoot ? inside(one) : [one]))];
    };
    const boxOf = (element: Element): DOMRect => element.getBoundingClientRect();
    const there = (element: Element): boolean => element.checkVisibility() && boxOf(element).width > 1 && boxOf(element).height > 1;
    const name = (element: Element): string => {
      const { left, top, right, bottom } = boxOf(element);
      const box = [left, top, right, bottom].map(Math.round).join(" ");
      const words = element.getAttribute("aria-label") ?? element.textContent?.trim().slice(0, 24);
      return `<${element.localName} ${element.className}> ${words} [${box}]`;
    };
    const part = (selector: string): Element | null => root.querySelector(selector);
    const stage = boxOf(part("main")!);

    // Cards and bars do not cover each other.
    const intro = part("rigless-intro")?.shadowRoot;
    const cards = [
      ...["rigless-top-bar", "rigless-rail", ".panel > *", "rigless-inspector", "rigless-status", "rigless-view", ".dock", ".sheet"].map(
        part,
      ),
      part("rigless-notices:not([quiet])"),
      ...(intro?.querySelectorAll(".chip, .line") ?? []),
    ].filter((card) => card !== null && there(card) && !card.parentElement?.closest(".sheet")) as Element[]; // which scrolls
    const holds = (a: Element, b: Element): boolean => a.contains(b) || b.contains(a);
    cards.forEach((a, k) => {
      for (const b of cards.slice(k + 1)) {
        const [p, q] = [boxOf(a), boxOf(b)];
        const over = Math.min(p.right, q.right) - Math.max(p.left, q.left) > 1 && Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top) > 1;
        if (over && !holds(a, b)) found.push(`${name(a)} lies over ${name(b)}`);
      }
    });

    // The stage is worth looking at, and the figures and their dots are on it and not under a card.
    if (stage.height < 150) found.push(`the stage is ${stage.height} px high`);
    for (const dot of inside(part("main")!).filter((one) => one.matches(".point.model .mark") && there(one))) {
      const { left, top, right, bottom } = boxOf(dot);
      if (left < stage.left || top < stage.top || right > stage.right || bottom > stage.bottom) found.push(`${name(dot)} is off the stage`);
      const over = cards.find((card) => {
        const box = boxOf(card);
        const [x, y] = [(left + right) / 2, (top + bottom) / 2];
        return box.left < x && x < box.right && box.top < y && y < box.bottom;
      });
      if (over) found.push(`${name(dot)} is under ${name(over)}`);
    }

    // Controls are whole, or can be scrolled to; words are not cut without a sign.
    const parent = (element: Element): Element | null =>
      element.assignedSlot ?? element.parentElement ?? ((element.getRootNode() as ShadowRoot).host as Element | undefined) ?? null;
    const scrolls = (element: Element): boolean => {
      for (let up = parent(element); up; up = parent(up)) {
        const { overflowX, overflowY } = getComputedStyle(up);
        if (["auto", "scroll"].includes(overflowY) || ["auto", "scroll"].includes(overflowX)) return true;
      }
      return false;
    };
    const controls = [...root.children].flatMap(inside).filter((one) => one.matches("button, input, select") && there(one));
    for (const control of controls) {
      if (control.matches(".point, .scrub, .bar, .flag, .pose")) continue;
      const { left, top, right, bottom } = boxOf(control);
      const out = left < -1 || top < -1 || right > innerWidth + 1 || bottom > innerHeight + 1;
      if (out && !scrolls(control)) found.push(`${name(control)} is outside of the window`);
      if (!out && !scrolls(control) && control.matches("button")) {
        const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        let deep = at;
        while (deep?.shadowRoot?.elementFromPoint((left + right) / 2, (top + bottom) / 2)) {
          const next = deep.shadowRoot.elementFromPoint((left + right) / 2, (top + bottom) / 2)!;
          if (next.getRootNode() !== deep.shadowRoot) break; // nothing of its own is there
          deep = next;
        }
        if (deep && !control.contains(deep)) found.push(`${name(control)} is covered by ${name(deep)}`);
      }
      if (control.scrollWidth > control.clientWidth + 1 && control.matches("button") && !control.matches(".handle, .tile, .book, .item"))
        found.push(`the words of ${name(control)} are cut`);
    }

    // A thumb hits: with what reaches beyond the drawing.
    if (thumbs) {
      for (const control of controls) {
        if (control.matches(".bar, [type=range], [role=switch]")) continue; // as long as they last; on a row of their own
        const { width, height } = boxOf(control);
        const reach = getComputedStyle(control, "::before");
        const grown = (value: string): number => (reach.content === "none" ? 0 : Math.max(0, -Number.parseFloat(value) || 0));
        const w = width + grown(reach.left) + grown(reach.right);
        const h = height + grown(reach.top) + grown(reach.bottom);
        if (w < 43.5 || h < 43.5) found.push(`${name(control)} is ${w} x ${h} for a thumb`);
      }
    }
    return [...new Set(found)];
  }, touch);
}

for (const [sizes, touch] of [
  [FINGERS, true],
  [MICE, false],
] as const) {
  test(`nothing is cut or covered at ${sizes.map((size) => size.join("x")).join(", ")}, whichever panel is open`, async ({ browser }) => {
    test.setTimeout(300_000);
    const [[width, height]] = sizes as [Size];
    const context = await browser.newContext({ viewport: { width, height }, hasTouch: touch, isMobile: touch, reducedMotion: "reduce" });
    const page = await context.newPage();
    await open(page);
    for (const [width, height] of sizes) {
      await page.setViewportSize({ width, height });
      for (const panel of ["at rest", "Model", "Motion", "Points", "Poses"]) {
        if (panel !== "at rest") await page.getByRole("button", { name: panel, exact: true }).click();
        const message = `${width}x${height}, ${panel}`;
        await expect
          .configure({ soft: true })
          .poll(() => faults(page, touch), { message, timeout: 10_000, intervals: [300] })
          .toEqual([]);
      }
      await page.getByRole("button", { name: "Poses", exact: true }).click(); // closes it
    }
    await context.close();
  });
}

test("844x390: a phone on its side shows the dance and plays it; upright it shows the rest", async ({ browser }) => {
  const context = await browser.newContext({
    viewport: { width: 844, height: 390 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: "reduce",
  });
  const page = await context.newPage();
  await open(page);
  await expect.poll(() => faults(page, true), { timeout: 10_000, intervals: [500] }).toEqual([]);
  const stage = await page.getByRole("main").boundingBox();
  expect(stage!.height).toBeGreaterThan(300);
  await expect(page.getByRole("button", { name: "Export" })).toBeHidden();
  await page.getByRole("button", { name: "Play" }).tap();
  expect(await page.evaluate(() => rigless?.playing)).toBe(true);
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.getByRole("button", { name: "Export" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Model", exact: true })).toBeVisible();
  await context.close();
});
