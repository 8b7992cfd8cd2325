// Draws docs/figures/cast-<id>.webp, every motion a row of eight moments, and writes the table docs/figures/cast.md.
// Run: node web/authoring/figures/cast.js [--table] [id...]   (only the named ones' sheets are drawn, and no table is written;
// --table: no sheet is drawn; the page's WASM must have been built, CHROMIUM names the browser)
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { BASE, bytesOf, openPage, placeOf, WEB } from "./browser.js";

const figures = fileURLToPath(new URL("../../../docs/figures/", import.meta.url));
const list = (kind) => JSON.parse(readFileSync(`${WEB}assets/${kind}/index.json`, "utf8"));
const { values, positionals: wanted } = parseArgs({ options: { table: { type: "boolean" } }, allowPositionals: true });
const characters = list("characters").filter(({ id }) => wanted.length === 0 || wanted.includes(id));
const motions = list("motions");

const page = await openPage("cast.html", { stay: true });
const percent = (x, digits) => (100 * x).toFixed(digits);

const COLUMNS = {
  rise: (q) => q.rise.toFixed(2),
  amplitude: (q) => q.amplitude.toFixed(2),
  slide: (q) => q.slide.toFixed(2),
  "floats, % of frames": (q) => percent(q.floats, 0),
  "moves, % of height": (q) => percent(q.movement, 1),
  seam: (q, { loops }) => (loops ? q.seam.toFixed(2) : ""),
  crossings: (q) => q.crossings,
  "penetration, % of height": (q) => percent(q.penetration, 2),
  volume: (q) => q.volume.map((v) => v.toFixed(2)).join(" to "),
  "peak acceleration": (q) => q.acceleration.toFixed(0),
  guesswork: (q) => q.guesswork.toFixed(2),
};
const row = (cells) => `| ${cells.join(" | ")} |`;
const head = ["motion", ...Object.keys(COLUMNS)];

const tables = [];
for (const character of characters) {
  const { id, name, vertices } = character;
  const strips = [];
  const rows = [];
  for (const motion of motions) {
    const url = `${BASE}assets/motions/${motion.file}`;
    const { strip, quality } = await page.call("castRow", { ...placeOf(character), motion: url, draw: !values.table });
    strips.push(strip);
    rows.push(row([motion.name, ...Object.values(COLUMNS).map((cell) => cell(quality, motion))]));
    console.log(id, rows.at(-1));
  }
  if (!values.table) writeFileSync(`${figures}cast-${id}.webp`, bytesOf(await page.call("castSheet", strips)));
  tables.push(`## ${name}

${vertices.toLocaleString("en-US")} vertices. From the top: ${motions.map((motion) => motion.name.toLowerCase()).join(", ")}.

![Eight moments of each motion](cast-${id}.webp)

${row(head)}
${row(head.map(() => "---"))}
${rows.join("\n")}
`);
}
await page.close();

if (wanted.length === 0) {
  writeFileSync(
    `${figures}cast.md`,
    `# The cast and its repertoire

Written by \`node web/authoring/figures/cast.js\`: every character with every motion, solved and drawn by the page's own engine and viewport.
Heights are the character's or the human's own. Rise is how far the body's middle goes up and down, over the middle of the human's joints;
amplitude how far points move in the body's frame, over their joints; slide the 95th percentile of the speed over the ground, in heights per
second, of vertices that touch it. A frame floats if it neither stands nor flies. A body moves as far as its surface does on average, peak to
peak, without its travel. Seam is the step at a loop's end over the 95th percentile of its steps. Crossings are pairs of triangles in the worst
of every fourth frame, beyond those at rest. Penetration is the deepest that any vertex ever lies below the ground; peak acceleration, in
heights/s², that of any point in the body's frame; guesswork how far frames are from the poses that were made by hand (0 taught, 1 guessed).

${tables.join("\n")}`,
  );
}
