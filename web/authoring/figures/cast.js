// Draws docs/figures/cast-<id>.webp, every motion a row of eight moments, and writes the table docs/figures/cast.md.
// Run: node web/authoring/figures/cast.js [id...]   (only the named ones' sheets are drawn, and no table is written;
// the page's WASM must have been built, CHROMIUM names the browser)
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { createServer } from "vite";

const web = fileURLToPath(new URL("../../", import.meta.url));
const figures = fileURLToPath(new URL("../../../docs/figures/", import.meta.url));
const PORT = 5306;
const list = (kind) => JSON.parse(readFileSync(`${web}assets/${kind}/index.json`, "utf8"));
const wanted = process.argv.slice(2);
const characters = list("characters").filter(({ id }) => wanted.length === 0 || wanted.includes(id));
const motions = list("motions");

const server = await createServer({
  root: web,
  configFile: false,
  logLevel: "error",
  appType: "mpa",
  cacheDir: web + "../build/cast",
  assetsInclude: ["**/*.glb", "**/*.bvh"],
  server: { host: "127.0.0.1", port: PORT, strictPort: true, hmr: false },
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
const base = `http://127.0.0.1:${PORT}/`;
const percent = (x, digits) => (100 * x).toFixed(digits);

const tables = [];
for (const { id, name, project, vertices } of characters) {
  const url = new URL(project, `${base}assets/characters/`);
  const strips = [];
  const rows = [];
  for (const motion of motions) {
    await page.goto(`${base}authoring/figures/cast.html`);
    await page.waitForFunction(() => "castRow" in window, null, { timeout: 60_000 });
    const { strip, quality: q } = await page.evaluate((input) => window.castRow(input), {
      folder: new URL(".", url).href, project: url.pathname.split("/").at(-1), motion: `${base}assets/motions/${motion.file}`,
    });
    strips.push(strip);
    rows.push(`| ${motion.name} | ${percent(q.slip, 3)} | ${percent(q.penetration, 2)} | ${q.volume.map((v) => v.toFixed(2)).join(" to ")} | ${q.acceleration.toFixed(0)} | ${q.guesswork.toFixed(2)} |`);
    console.log(id, rows.at(-1));
  }
  const sheet = await page.evaluate((all) => window.castSheet(all), strips);
  writeFileSync(`${figures}cast-${id}.webp`, Buffer.from(sheet.split(",")[1], "base64"));
  tables.push(`## ${name}

${vertices.toLocaleString("en-US")} vertices. From the top: ${motions.map((motion) => motion.name.toLowerCase()).join(", ")}.

![Eight moments of each motion](cast-${id}.webp)

| motion | slip, % of height/s | penetration, % of height | volume | peak acceleration, heights/s² | guesswork |
|---|---|---|---|---|---|
${rows.join("\n")}
`);
}
await browser.close();
await server.close();

if (wanted.length === 0) {
  writeFileSync(`${figures}cast.md`, `# The cast and its repertoire

Written by \`node web/authoring/figures/cast.js\`: every character with every motion, solved and drawn by the page's own engine and viewport.
Slip is the mean horizontal speed of points while they stand; penetration the deepest that any vertex ever lies below the ground; peak
acceleration that of any point in the body's frame; guesswork how far frames are from the poses that were made by hand (0 taught, 1 guessed).

${tables.join("\n")}`);
}
