// Writes docs/figures from what bench/thesis_bench.cpp computes. Run by ./dev figures.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { createServer } from "vite";
import { curves } from "./curves.js";
import { readme } from "./readme.js";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const build = root + "build/figures/";
const figures = root + "docs/figures/";
const CACTUS = "/assets/cactus/cactus.glb";
const json = (name) => JSON.parse(readFileSync(build + name, "utf8"));
for (const folder of [build, figures]) mkdirSync(folder, { recursive: true });

const server = await createServer({
  root: root + "web",
  configFile: false,
  logLevel: "error",
  appType: "mpa",
  cacheDir: build + "vite",
  assetsInclude: ["**/*.glb"],
  server: { host: "127.0.0.1", port: 5175, strictPort: true, hmr: false },
});
await server.listen();

// The cactus for the native program, numbered as the page numbers it.
const { readModel } = await server.ssrLoadModule("/src/io/read-model.ts");
const cactus = await readModel([{ name: "cactus.glb", bytes: new Uint8Array(readFileSync(root + "web" + CACTUS)) }]);
const lines = (letter, values, plus) =>
  Array.from({ length: values.length / 3 }, (_, i) =>
    [letter, ...Array.from(values.subarray(3 * i, 3 * i + 3), (x) => x + plus)].join(" "),
  );
writeFileSync(build + "cactus.obj", [...lines("v", cactus.positions, 0), ...lines("f", cactus.faces, 1)].join("\n") + "\n");

const programs = process.argv.slice(2);
for (const program of programs) execFileSync(program, ["--out", build], { stdio: "inherit" });

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
});
const page = await browser.newPage({ viewport: { width: 1200, height: 420 }, reducedMotion: "reduce", colorScheme: "light" });
page.on("pageerror", (error) => {
  throw error;
});
const draw = async (name, width, height, labels, skin) => {
  await page.setViewportSize({ width, height });
  await page.goto("http://127.0.0.1:5175/authoring/figures/index.html");
  await page.waitForFunction(() => "draw" in window, null, { timeout: 60_000 });
  const data = json(name + ".json");
  const captions = labels.map((label, k) => `${label}, volume ${data.surfaces[k].volume.toFixed(2)}`);
  await page.evaluate(([surfaces, texts, glb]) => window.draw(surfaces, texts, glb), [data, captions, skin]);
  await page.waitForTimeout(1500); // dots behind a surface fade
  await page.screenshot({ path: figures + name + ".png", timeout: 60_000 });
};
await draw("fig-4-1", 1204, 300, ["(a) rest", "(b) ARAP", "(b) thesis", "(b) ours", "(c) ARAP", "(c) thesis", "(c) ours"], CACTUS);
await draw("fig-3-6", 1000, 320, ["(a) rest", "(b) λ\u1d65 = 0", "(c) λ\u1d65 = 3", "(d) λ\u1d65 = 0", "(e) λ\u1d65 = 3"], null);
await browser.close();
await server.close();

const sets = json("fig-4-3.json");
writeFileSync(figures + "fig-4-3.svg", curves(sets));
const tables = ["avx2", "sse2"]
  .filter((kind) => existsSync(`${build}table-4-1-${kind}.json`))
  .map((kind) => ({ kind, rows: json(`table-4-1-${kind}.json`) }));
const cpu = /model name\s*: (.*)/.exec(readFileSync("/proc/cpuinfo", "utf8"))?.[1] ?? "an unnamed processor";
writeFileSync(
  figures + "README.md",
  readme({ cpu, tables, sets, volumes: json("volumes.json"), fig41: json("fig-4-1.json"), fig36: json("fig-3-6.json") }),
);
