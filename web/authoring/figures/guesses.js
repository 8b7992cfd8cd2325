// Draws guess-<model>-<motion>.webp: how a model dances that nobody has said anything about, eight moments each.
// Run: node web/authoring/figures/guesses.js [model motion...]   without arguments: two models with two clips each
//   (docs/figures), which lie beside the project; the page's WASM must have been built, CHROMIUM names the browser
import { writeFileSync } from "node:fs";
import { basename, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { createServer } from "vite";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const data = fileURLToPath(new URL("../../../../shared/data/", import.meta.url));
const given = process.argv.slice(2).map((path) => resolve(path));
const clips = [["02.asf", "02_01.amc"], ["02.asf", "02_04.amc"]].map((files) => files.map((file) => `${data}motions/${file}`));
const jobs = given.length > 1 ? [given] : ["spot.obj", "cheburashka.off"].flatMap((model) => clips.map((clip) => [`${data}meshes/${model}`, ...clip]));

const server = await createServer({
  root: root + "web",
  configFile: false,
  logLevel: "error",
  appType: "mpa",
  cacheDir: root + "build/guesses",
  server: { host: "127.0.0.1", port: 5183, strictPort: true, hmr: false, fs: { strict: false } },
});
await server.listen();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"],
});
const page = await browser.newPage();
page.on("pageerror", (error) => {
  throw error;
});
const stem = (path) => basename(path).replace(/\.[^.]*$/, "");
for (const [model, ...motion] of jobs) {
  await page.goto("http://127.0.0.1:5183/authoring/figures/guesses.html");
  await page.waitForFunction(() => "drawGuess" in window, null, { timeout: 60_000 });
  const url = await page.evaluate((input) => window.drawGuess(input), { model: `/@fs${model}`, motion: motion.map((file) => `/@fs${file}`), frames: 8 });
  const path = `${root}docs/figures/guess-${stem(model)}-${stem(motion.at(-1))}.webp`;
  writeFileSync(path, Buffer.from(url.split(",")[1], "base64"));
  console.log(path.slice(root.length));
}
await browser.close();
await server.close();
