// Draws the pictures that the galleries show: for each character its own dance, for each motion the mannequin.
// They are drawn here and not in the page, because the page would have to load and solve every one of them first.
// Run: node web/authoring/figures/pictures.js [id or file...]   (the page's WASM must have been built)
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { createServer } from "vite";

const web = fileURLToPath(new URL("../../", import.meta.url));
const list = (kind) => JSON.parse(readFileSync(`${web}assets/${kind}/index.json`, "utf8"));
const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.includes(name);

const server = await createServer({
  root: web,
  configFile: false,
  logLevel: "error",
  appType: "mpa",
  cacheDir: web + "../build/pictures",
  assetsInclude: ["**/*.glb", "**/*.bvh"],
  server: { host: "127.0.0.1", port: 5305, strictPort: true, hmr: false },
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

const characters = list("characters");
/** The page's address of a character's folder, and its project's name in it. */
const place = ({ project }) => {
  const url = new URL(project, "http://127.0.0.1:5305/assets/characters/");
  return { folder: new URL(".", url).href, project: url.pathname.split("/").at(-1) };
};
const draw = async (path, performance) => {
  await page.goto("http://127.0.0.1:5305/authoring/figures/pictures.html");
  await page.waitForFunction(() => "draw" in window, null, { timeout: 60_000 });
  const url = await page.evaluate((input) => window.draw(input), performance);
  const bytes = Buffer.from(url.split(",")[1], "base64");
  mkdirSync(new URL(".", `file://${path}`), { recursive: true });
  writeFileSync(path, bytes);
  console.log(`${path.slice(web.length)}: ${(bytes.length / 1000).toFixed(1)} kB`);
};

for (const character of characters.filter(({ id }) => isWanted(id))) {
  const at = place(character);
  const { motion } = JSON.parse(readFileSync(web + new URL(at.folder).pathname.slice(1) + at.project, "utf8"));
  await draw(`${web}assets/characters/pictures/${character.id}.webp`, { ...at, motion: new URL(motion.files[0], at.folder).href, who: "model" });
}
for (const { file } of list("motions").filter(({ file }) => isWanted(file))) {
  const path = `${web}assets/motions/pictures/${file.replace(/\.bvh$/, ".webp")}`;
  await draw(path, { ...place(characters[0]), motion: `http://127.0.0.1:5305/assets/motions/${file}`, who: "human" });
}
await browser.close();
await server.close();
