// Draws docs/figures/cast-<id>.webp, every motion a row of eight moments, and writes the table docs/figures/cast.md.
// Run: node web/authoring/figures/cast.js [id...]   (only the named ones' sheets are drawn, and no table is written;
// the page's WASM must have been built, CHROMIUM names the browser)
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { BASE, bytesOf, openPage, placeOf, WEB } from "./browser.js";

const figures = fileURLToPath(new URL("../../../docs/figures/", import.meta.url));
const list = (kind) => JSON.parse(readFileSync(`${WEB}assets/${kind}/index.json`, "utf8"));
const wanted = process.argv.slice(2);
const characters = list("characters").filter(({ id }) => wanted.length === 0 || wanted.includes(id));
const motions = list("motions");

const page = await openPage("cast.html");
const percent = (x, digits) => (100 * x).toFixed(digits);

const tables = [];
for (const character of characters) {
  const { id, name, vertices } = character;
  const strips = [];
  const rows = [];
  for (const motion of motions) {
    const { strip, quality: q } = await page.call("castRow", { ...placeOf(character), motion: `${BASE}assets/motions/${motion.file}` });
    strips.push(strip);
    rows.push(
      `| ${motion.name} | ${percent(q.slip, 3)} | ${percent(q.penetration, 2)} | ${q.volume.map((v) => v.toFixed(2)).join(" to ")} | ${q.acceleration.toFixed(0)} | ${q.guesswork.toFixed(2)} |`,
    );
    console.log(id, rows.at(-1));
  }
  writeFileSync(`${figures}cast-${id}.webp`, bytesOf(await page.call("castSheet", strips)));
  tables.push(`## ${name}

${vertices.toLocaleString("en-US")} vertices. From the top: ${motions.map((motion) => motion.name.toLowerCase()).join(", ")}.

![Eight moments of each motion](cast-${id}.webp)

| motion | slip, % of height/s | penetration, % of height | volume | peak acceleration, heights/s² | guesswork |
|---|---|---|---|---|---|
${rows.join("\n")}
`);
}
await page.close();

if (wanted.length === 0) {
  writeFileSync(
    `${figures}cast.md`,
    `# The cast and its repertoire

Written by \`node web/authoring/figures/cast.js\`: every character with every motion, solved and drawn by the page's own engine and viewport.
Slip is the mean horizontal speed of points while they stand; penetration the deepest that any vertex ever lies below the ground; peak
acceleration that of any point in the body's frame; guesswork how far frames are from the poses that were made by hand (0 taught, 1 guessed).

${tables.join("\n")}`,
  );
}
