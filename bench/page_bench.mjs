// A model dropped on the page: how soon it dances, what it costs to play and to drag, and how much memory it takes.
// node bench/page_bench.mjs [--csv FILE] [MODEL...]; without a model two of our own, of 7 thousand and of a million triangles. The
// page must have been built (npm run build in web). CHROMIUM names the browser.
// Where there is no graphics card the browser plays one: then drawing a million triangles takes seconds of the processor's
// time, which what is timed here has to wait for.
import { appendFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { glbBytes, HOSTILE, objText } from "../web/authoring/strangers/hostile.js";

const WEB = fileURLToPath(new URL("../web/", import.meta.url));
const require = createRequire(join(WEB, "package.json"));
const { chromium } = require("@playwright/test");
const { preview } = await import(require.resolve("vite"));
const { values: options, positionals } = parseArgs({ allowPositionals: true, options: { csv: { type: "string" } } });
const folder = mkdtempSync(join(tmpdir(), "rigless-"));

const server = await preview({ root: WEB, configFile: false, logLevel: "error", preview: { port: 0 } });
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
});

/** Resident megabytes of a process. */
const resident = (pid) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1000;

/** In the page: drops the file of an input, and the milliseconds until what it is dances. */
async function dropped(input) {
  const begin = performance.now();
  const data = new DataTransfer();
  data.items.add(input.files[0]);
  const before = rigless.document.mesh.file;
  const blocks = [];
  const observer = new PerformanceObserver((list) => blocks.push(...list.getEntries().map(({ duration }) => duration)));
  observer.observe({ entryTypes: ["longtask"] });
  document.querySelector("rigless-app").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, composed: true, cancelable: true }));
  const until = async (holds) => {
    while (!holds()) await new Promise((resolve) => setTimeout(resolve, 4));
    return performance.now() - begin;
  };
  const motion = await until(() => {
    const { document, performance: dance, frames, stale } = rigless;
    const points = document.points.length;
    return document.mesh.file !== before && points > 0 && dance !== null && dance.controls.length === 3 * dance.frames * points && stale < frames;
  });
  const whole = await until(() => rigless.stale === 0 && !rigless.solving);
  observer.disconnect();
  return { motion, whole: whole - motion, blocks: blocks.sort((a, b) => b - a) };
}

function written(name) {
  const made = HOSTILE[name]();
  const file = join(folder, `${name}.${made.format}`);
  writeFileSync(file, made.format === "glb" ? glbBytes(made) : objText(made));
  return file;
}

async function figuresOf(file) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.goto(`http://localhost:${server.httpServer.address().port}/`);
  await page.waitForFunction(() => rigless?.performance && rigless.stale === 0 && !rigless.solving, null, { timeout: 300_000 });
  await page.waitForTimeout(3000); // shaders and small pictures
  const devtools = await page.context().newCDPSession(page);
  const input = await page.evaluateHandle(() => Object.assign(document.createElement("input"), { type: "file" }));
  await input.setInputFiles(file);
  const { motion, whole, blocks } = await page.evaluate(dropped, input);
  await page.waitForTimeout(5000);

  await devtools.send("Profiler.enable");
  await devtools.send("Profiler.start");
  const shown = await page.evaluate(async () => {
    const seen = new Set();
    for (const end = performance.now() + 5000; performance.now() < end; seen.add(rigless.frame)) await new Promise(requestAnimationFrame);
    return seen.size;
  });
  const { profile } = await devtools.send("Profiler.stop");
  const ours = new Set(profile.nodes.filter(({ callFrame }) => callFrame.url.includes("/assets/")).map(({ id }) => id));
  const script = profile.samples.reduce((sum, id, k) => sum + (ours.has(id) ? profile.timeDeltas[k] / 1000 : 0), 0);

  await page.keyboard.press("Space");
  const dot = await page.locator(".point.model").nth(1).boundingBox();
  await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
  await page.mouse.down();
  for (let k = 1; k <= 20; k++) await page.mouse.move(dot.x + dot.width / 2 + 2 * k, dot.y + dot.height / 2 - 2 * k);
  await page.waitForTimeout(2500);
  const drag = Number(/solved in\s+([\d.]+)\s+ms/.exec(await page.getByText("solved in").innerText())?.[1] ?? NaN);
  await page.mouse.up();
  const processes = (await (await browser.newBrowserCDPSession()).send("SystemInfo.getProcessInfo")).processInfo;
  const memory = Math.max(...processes.filter(({ type }) => type === "renderer").map(({ id }) => resident(id)));
  await page.close();
  return [
    ["drop to first motion", motion, "ms"],
    ["the whole dance after that", whole, "ms"],
    ["longest block of the page, drawing included", blocks[0] ?? 0, "ms"],
    ["script a frame while it plays, three.js included", script / shown, "ms"],
    ["a drag in the worker", drag, "ms"],
    ["memory of the page and its workers", memory, "MB"],
  ];
}

try {
  for (const file of positionals.length > 0 ? positionals : ["person-a", "million"].map(written)) {
    for (const [figure, value, unit] of await figuresOf(file)) {
      console.log(`page ${`${basename(file)}: ${figure}`.padEnd(72)} ${value.toPrecision(4).padStart(11)} ${unit}`);
      if (options.csv) appendFileSync(options.csv, `page,${basename(file)}: ${figure},${value.toPrecision(5)},,${unit},\n`);
    }
  }
} finally {
  await browser.close();
  await server.close();
  rmSync(folder, { recursive: true, force: true });
}
