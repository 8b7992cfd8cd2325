// Draws guess-<model>-<motion>.webp: how a model dances that nobody has said anything about, eight moments each.
// Run: node web/authoring/figures/guesses.js [model motion...]   without arguments: two models with two clips each
//   (docs/figures), which lie beside the project; the page's WASM must have been built, CHROMIUM names the browser
import { writeFileSync } from "node:fs";
import { basename, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { bytesOf, openPage } from "./browser.js";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const data = fileURLToPath(new URL("../../../../shared/data/", import.meta.url));
const given = process.argv.slice(2).map((path) => resolve(path));
const clips = [
  ["02.asf", "02_01.amc"],
  ["02.asf", "02_04.amc"],
].map((files) => files.map((file) => `${data}motions/${file}`));
const jobs =
  given.length > 1 ? [given] : ["spot.obj", "cheburashka.off"].flatMap((model) => clips.map((clip) => [`${data}meshes/${model}`, ...clip]));

const page = await openPage("guesses.html", { outside: true });
const stem = (path) => basename(path).replace(/\.[^.]*$/, "");
for (const [model, ...motion] of jobs) {
  const url = await page.call("drawGuess", { model: `/@fs${model}`, motion: motion.map((file) => `/@fs${file}`), frames: 8 });
  const path = `${root}docs/figures/guess-${stem(model)}-${stem(motion.at(-1))}.webp`;
  writeFileSync(path, bytesOf(url));
  console.log(path.slice(root.length));
}
await page.close();
