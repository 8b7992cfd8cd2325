// Draws docs/dance.gif, the loop of the README's first screen.
// Run: node web/authoring/figures/loop.js [motion [id...]]   (the page's WASM must have been built, CHROMIUM names the browser)
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { BASE, openPage, placeOf, WEB } from "./browser.js";

const [motion = "disco", ...ids] = process.argv.slice(2);
const wanted = ids.length > 0 ? ids : ["dinosaur", "cactus", "puppy", "egg", "lamp"];
const characters = JSON.parse(readFileSync(`${WEB}assets/characters/index.json`, "utf8"));
const dancers = wanted.map((id) => placeOf(characters.find((character) => character.id === id)));

const page = await openPage("loop.html");
const gif = Buffer.from(
  await page.call("drawLoop", { dancers, motion: `${BASE}assets/motions/${motion}.bvh`, pixels: 144, every: 2 }),
  "base64",
);
await page.close();
writeFileSync(fileURLToPath(new URL("../../../docs/dance.gif", import.meta.url)), gif);
console.log(`docs/dance.gif: ${(gif.length / 1000).toFixed(0)} kB`);
