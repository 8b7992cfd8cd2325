// Before npm pack: everything that the package holds. After it: node pack.js --clean takes the copies away.

import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const web = fileURLToPath(new URL("./", import.meta.url));
const types = `${web}dist-node/types/`;
const core = ["rigless.wasm", "shape-analysis.wasm", "skin.wasm"];
const copies = ["README.md", "LICENSE"];

const run = (program, ...args) => execFileSync(program, args, { cwd: web, stdio: ["ignore", process.stderr, process.stderr] });

if (process.argv.includes("--clean")) {
  for (const file of copies) rmSync(web + file, { force: true });
  process.exit();
}

if (!core.every((file) => existsSync(`${web}src/engine/${file}`))) {
  mkdirSync(`${web}../build`, { recursive: true });
  run(`${web}../wasm/build.sh`, "build/rigless.wasm");
  for (const file of core) copyFileSync(`${web}../build/${file}`, `${web}src/engine/${file}`);
}

run(process.execPath, "node_modules/vite/bin/vite.js", "build", "--config", "vite.node.config.ts", "--logLevel", "warn");

run(process.execPath, "node_modules/typescript/bin/tsc", "-p", "tsconfig.package.json");
// TypeScript keeps imports as they are written, but Node's resolution wants their endings. What the entry does not reach is left out.
const reached = new Set(["package/node.d.ts"]);
for (const file of reached) {
  const text = readFileSync(types + file, "utf8").replace(/(\bfrom |\bimport\()"(\.[^"]*)"/g, '$1"$2.js"');
  writeFileSync(types + file, text);
  for (const [, path] of text.matchAll(/"(\.[^"]*)\.js"/g)) reached.add(join(dirname(file), `${path}.d.ts`));
}
for (const file of readdirSync(types, { recursive: true, encoding: "utf8" })) {
  if (file.endsWith(".d.ts") && !reached.has(file)) rmSync(types + file);
}

for (const file of copies) copyFileSync(`${web}../${file}`, web + file);
