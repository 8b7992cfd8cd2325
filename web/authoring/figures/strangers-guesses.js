// What is guessed of models that nobody here made, against what eyes see: how they stand, and which limbs they have. Nothing is baked.
// Run: node web/authoring/figures/strangers-guesses.js --models <folder> [--hostile] [--only <pattern>] [--all]
// Truth lies in docs/figures/strangers.json. Right is: up, front, and of head, hands and feet as many as the truth says, hands and feet
// on their own sides. --all prints right ones too, --nameless leaves joints and parts without names.
import { readdirSync, readFileSync } from "node:fs";
import { extname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { createServer } from "vite";
import { glbBytes, HOSTILE, objText } from "../strangers/hostile.js";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const { values: asked } = parseArgs({
  options: {
    models: { type: "string" },
    hostile: { type: "boolean" },
    only: { type: "string", default: "" },
    all: { type: "boolean" },
    nameless: { type: "boolean" },
  },
});
if (!asked.models && !asked.hostile) throw new Error("--models <folder>, --hostile or both are needed.");

const server = await createServer({
  root: `${root}web`,
  configFile: false,
  logLevel: "error",
  appType: "custom",
  assetsInclude: ["**/draco3dgltf/*.wasm"],
  optimizeDeps: { noDiscovery: true },
  server: { middlewareMode: true, hmr: false, ws: false },
});
const load = (path) => server.ssrLoadModule(`/src/${path}.ts`);
const [{ readModel }, { analyseShape }, { shapeInput }] = await Promise.all(
  ["io/read-model", "engine/analyse-shape", "sync/shape-input"].map(load),
);
const wasm = readFileSync(`${root}web/src/engine/shape-analysis.wasm`).buffer;

/** Head, hands, feet and forelegs that the truth lists; null where it says nothing of them. */
function wantedOf({ limbs, truth }) {
  const has = (limb) => limbs.includes(limb);
  if (truth.limbs) return truth.limbs;
  const feet = /(\d) feet/.exec(limbs.join(" "));
  return {
    ...(has("head") && { head: 1 }),
    ...((has("hands") || has("wings")) && { hand: 2 }),
    ...(has("feet") && { foot: 2 }),
    ...(feet && { legs: Number(feet[1]) }),
  };
}

function faultsOf(row, said, positions) {
  const faults = [];
  const { up, front } = row.truth;
  if (!up.split("|").includes(said.up)) faults.push(`up ${said.up}, not ${up}`);
  if (front && !front.split("|").includes(said.facing)) faults.push(`front ${said.facing}, not ${front}`);
  const wanted = said.points.filter((point) => point.wanted);
  const number = (...roles) => wanted.filter(({ role }) => roles.includes(role)).length;
  for (const [role, n] of Object.entries(wantedOf(row))) {
    const found = role === "legs" ? number("foot", "foreleg") : number(role);
    if (found !== n) faults.push(`${role} ${found}, not ${n}`);
  }
  const [u, f] = [said.up, said.facing].map((name) => ["x", "y", "z"].map((k) => (name[1] === k ? Number(`${name[0]}1`) : 0)));
  const left = [u[1] * f[2] - u[2] * f[1], u[2] * f[0] - u[0] * f[2], u[0] * f[1] - u[1] * f[0]];
  const along = (axis, vertex) => axis.reduce((sum, x, k) => sum + x * positions[3 * vertex + k], 0);
  const sided = wanted.filter(({ side }) => side !== null);
  for (const role of ["hand", "foot", "foreleg"]) {
    const of = (side) => sided.filter((one) => one.role === role && one.side === side).map(({ vertex }) => along(left, vertex));
    if (Math.min(...of("left")) < Math.max(...of("right"))) faults.push(`${role}: sides`);
  }
  return faults;
}

/** "head 0.98, left hand 0.55": heights in those of the body. */
function pointsText(said, positions) {
  const k = "xyz".indexOf(said.up[1]);
  const sign = said.up[0] === "-" ? -1 : 1;
  const heights = positions.filter((_, i) => i % 3 === k).map((x) => sign * x);
  const low = heights.reduce((a, b) => Math.min(a, b));
  const tall = heights.reduce((a, b) => Math.max(a, b)) - low;
  return said.points
    .filter(({ wanted }) => wanted)
    .map(({ role, side, vertex }) => `${side ? `${side[0]} ` : ""}${role} ${((heights[vertex] - low) / tall).toFixed(2)}`)
    .join(", ");
}

const pattern = new RegExp(asked.only, "i");
const rows = asked.models ? JSON.parse(readFileSync(`${root}docs/figures/strangers.json`, "utf8")) : [];
const beside = rows.some(({ file }) => extname(file) === ".gltf")
  ? readdirSync(asked.models)
      .filter((name) => extname(name) === ".bin")
      .map((name) => ({ name, bytes: readFileSync(resolve(asked.models, name)) }))
  : [];
const tally = { models: 0, up: 0, front: 0, limbs: 0, all: 0 };
async function judge(row, model) {
  const input = shapeInput({ ...model, joints: asked.nameless ? [] : model.joints });
  const said = analyseShape({ mesh: input, wasm });
  const faults = faultsOf(row, said, model.positions);
  tally.models++;
  tally.up += faults.some((fault) => fault.startsWith("up")) ? 0 : 1;
  tally.front += faults.some((fault) => fault.startsWith("front")) ? 0 : 1;
  tally.limbs += faults.some((fault) => !/^(up|front)/.test(fault)) ? 0 : 1;
  tally.all += faults.length === 0 ? 1 : 0;
  if (faults.length === 0 && !asked.all) return;
  const by = input.landmarks?.length ? "names" : "shape";
  console.log(`${row.name} (${by}, sure ${said.sure.toFixed(2)}): ${faults.join("; ") || "right"}. ${pointsText(said, model.positions)}`);
}

for (const row of rows.filter(({ name }) => pattern.test(name))) {
  const bytes = new Uint8Array(readFileSync(resolve(asked.models, row.file)));
  const model = await readModel([{ name: row.file, bytes }, ...beside]).catch((error) => error.message);
  if (typeof model === "string") console.log(`${row.name}: ${model}`);
  else await judge(row, model);
}
for (const [name, make] of asked.hostile ? Object.entries(HOSTILE) : []) {
  if (!pattern.test(`hostile-${name}`)) continue;
  const made = make();
  const { truth, format, what } = made;
  const count = (end) => Object.keys(truth.limbs).filter((key) => key.endsWith(end)).length;
  const limbs = Object.fromEntries(
    [
      ["head", "head"],
      ["hand", "hand"],
    ]
      .map(([role, end]) => [role, count(end)])
      .filter(([, n]) => n > 0),
  );
  const row = {
    name: `hostile-${name}`,
    what,
    limbs: [],
    truth: { ...truth, limbs: { ...limbs, ...(count("foot") && { legs: count("foot") }) } },
  };
  const bytes = format === "glb" ? glbBytes(made) : new TextEncoder().encode(objText(made));
  await judge(row, { ...(await readModel([{ name: `${name}.${format}`, bytes }])), joints: [] });
}
const share = (n) => `${n} (${((100 * n) / tally.models).toFixed(0)} %)`;
console.log(
  `${tally.models} models: up ${share(tally.up)}, front ${share(tally.front)}, limbs ${share(tally.limbs)}, all right ${share(tally.all)}`,
);
await server.close();
