// Draws the pictures that the galleries show: for each character its own dance, for each motion the mannequin.
// They are drawn here and not in the page, because the page would have to load and solve every one of them first.
// Run: node web/authoring/figures/pictures.js [id or file...]   (the page's WASM must have been built)
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { BASE, bytesOf, openPage, placeOf, WEB } from "./browser.js";

const list = (kind) => JSON.parse(readFileSync(`${WEB}assets/${kind}/index.json`, "utf8"));
const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.includes(name);

const characters = list("characters");
const page = await openPage("pictures.html");
const draw = async (path, performance) => {
  const bytes = bytesOf(await page.call("drawPicture", performance));
  mkdirSync(new URL(".", `file://${WEB}${path}`), { recursive: true });
  writeFileSync(WEB + path, bytes);
  console.log(`${path}: ${(bytes.length / 1000).toFixed(1)} kB`);
};

for (const character of characters.filter(({ id }) => isWanted(id))) {
  const at = placeOf(character);
  const { motion } = JSON.parse(readFileSync(WEB + new URL(at.folder).pathname.slice(1) + at.project, "utf8"));
  await draw(`assets/characters/pictures/${character.id}.webp`, { ...at, motion: new URL(motion.files[0], at.folder).href, who: "model" });
}
for (const { file } of list("motions").filter(({ file }) => isWanted(file))) {
  const path = `assets/motions/pictures/${file.replace(/\.bvh$/, ".webp")}`;
  await draw(path, { ...placeOf(characters[0]), motion: `${BASE}assets/motions/${file}`, who: "human" });
}
await page.close();
