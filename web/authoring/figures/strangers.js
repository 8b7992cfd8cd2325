// How models dance that nobody here made: bakes each by the command line, draws contact sheets, writes a table.
// Run: node web/authoring/figures/strangers.js --models <folder>   the sheets docs/figures/strangers/*.png and docs/figures/strangers.md
//   --hostile        those of authoring/strangers too, written as files first
//   --only <pattern> some of them by name: --out is needed, no table of the docs is written
//   --out <folder>   sheets and table go there instead
//   --clone <folder> another checkout's command line is judged (its `npm run build:node` must have run)
//   --raw            only how the files stand: seen along -z and -x with y up, and from above
//   Ratings lie in ratings.json beside the sheets: { "fox": { "rating": 2, "note": "" } }. A run adds of which dance each is.
//   --collect <clones> fills the folder of models from clones of their repositories, each at <clones>/<owner>+<name>
// What was baked before from the same bytes is not baked again. CHROMIUM names the browser.
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, extname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { encodePng } from "../kit/png.js";
import { writeHostile } from "../strangers/hostile.js";
import { openPage } from "./browser.js";
import { collect } from "./strangers-collect.js";
import { Baker } from "./strangers-bake.js";
import { humanSwing, strangersTable } from "./strangers-table.js";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const figures = `${root}docs/figures/`;
const FRAMES = 6;
const CELL = 104;
const MODELS = [".glb", ".gltf", ".obj", ".off", ".ply", ".stl", ".fbx", ".vrm", ".dae", ".3mf", ".usdz"];

const { values: asked } = parseArgs({
  options: {
    models: { type: "string" },
    hostile: { type: "boolean" },
    only: { type: "string", default: "" },
    out: { type: "string" },
    clone: { type: "string", default: root },
    raw: { type: "boolean" },
    collect: { type: "string" },
  },
});
if (!asked.models && !asked.hostile) throw new Error("--models <folder>, --hostile or both are needed.");
if (asked.only && !asked.out) throw new Error("--only draws a part: --out <folder> is needed.");

const json = (path, absent) => (existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : absent);
const known = json(`${figures}strangers.json`, []);
if (asked.collect) collect(known, resolve(asked.collect), asked.models);

const wanted = new RegExp(asked.only, "i");
const inFolder = (folder, rows) => {
  const order = (file) => (rows.findIndex((row) => row.file === file) + rows.length + 1) % (rows.length + 1);
  return readdirSync(folder)
    .filter((file) => MODELS.includes(extname(file).toLowerCase()))
    .sort((a, b) => order(a) - order(b))
    .map((file) => ({
      name: basename(file, extname(file)),
      what: "",
      ...rows.find((row) => row.file === file),
      path: resolve(folder, file),
    }));
};
const scratch = `${root}build/strangers/`;
mkdirSync(scratch, { recursive: true });
const models = [
  ...(asked.models ? inFolder(asked.models, known) : []),
  ...(asked.hostile ? writeHostile(`${scratch}hostile/`, wanted) : []),
].filter(({ name }) => wanted.test(name));

const out = asked.out ? resolve(asked.out) : `${figures}strangers`;
mkdirSync(out, { recursive: true });
const page = await openPage("strangers.html", { outside: true, stay: true });
const served = (path) => `/@fs${path.split("/").map(encodeURIComponent).join("/")}`;

/** Rows of strips under each other; gives the sheets' names. */
async function writeSheets(name, rows) {
  const sheets = rows.length > 0 ? await page.call("drawSheets", rows) : [];
  return sheets.map(({ width, height, rgb }, n) => {
    const png = encodePng(width, height, Buffer.from(rgb, "base64"));
    const file = `${name}-${String(n + 1).padStart(2, "0")}.png`;
    writeFileSync(join(out, file), png);
    console.log(`${join(out, file)}: ${(png.length / 1000).toFixed(0)} kB`);
    return file;
  });
}

const ratingsText = (ratings) =>
  `{\n${Object.entries(ratings)
    .map(([name, rating]) => `  ${JSON.stringify(name)}: ${JSON.stringify(rating)}`)
    .join(",\n")}\n}\n`;

/** What eyes said of this very dance: a rating without `of` is of today's, one of another dance stands in brackets. */
function ratingOf(ratings, name, { strip, refused }) {
  const rating = ratings[name];
  if (!rating) return { rating: null, note: "", stale: false };
  const of = createHash("sha256")
    .update(strip ?? refused)
    .digest("hex")
    .slice(0, 8);
  rating.of ??= of;
  return { rating: rating.rating, note: rating.note, stale: rating.of !== of };
}

if (asked.raw) {
  const rows = [];
  for (const { name, path } of models) {
    const strip = await page.call("drawRaw", { url: served(path), cell: 200 }).catch((error) => console.log(name, error.message));
    if (strip) rows.push({ title: `${name}: +z towards you, y up; +x towards you, y up; from above`, strip });
  }
  await writeSheets("raw", rows);
} else {
  const baker = new Baker(resolve(asked.clone), scratch);
  const ratings = json(join(out, "ratings.json"), {});
  const human = humanSwing();
  const results = [];
  for (const model of models) {
    const result = await baker.judge(model, async (dances) =>
      page.call("drawStranger", { dances: dances.map(({ path, points }) => ({ url: served(path), points })), frames: FRAMES, cell: CELL }),
    );
    results.push({ ...model, ...result, ...ratingOf(ratings, model.name, result) });
    console.log(model.name, result.refused ?? `${result.up} ${result.front} swing ${result.measures.swing.map(Math.round)}`);
  }
  // In the docs only what its licence lets anybody show; ours have none.
  const drawn = results.filter(({ strip, licence = "CC0" }) => strip && (asked.out || licence.startsWith("CC")));
  const sheets = await writeSheets(
    "sheet",
    drawn.map(({ name, up, front, measures, rating, points, strip, stale }) => ({
      title:
        `${name}: ${measures.triangles.toLocaleString("en-US")} triangles, ${measures.shells} shells; ${up} up, looks along ${front}; ` +
        `swings ${measures.swing.map(Math.round).join("/")} of ${human.map(Math.round).join("/")}; ` +
        `${points.join(", ")}${rating === null ? "" : `; rated ${rating}${stale ? " before" : ""}`}`,
      strip,
    })),
  );
  const table = strangersTable(results, human, sheets);
  writeFileSync(asked.out ? join(out, "strangers.md") : `${figures}strangers.md`, table);
  if (Object.keys(ratings).length > 0) writeFileSync(join(out, "ratings.json"), ratingsText(ratings));
  writeFileSync(
    join(scratch, "last.json"),
    JSON.stringify(
      results.map(({ strip, ...row }) => row),
      null,
      1,
    ),
  );
}
await page.close();
