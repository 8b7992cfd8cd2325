import { execFile } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import { expect, test } from "vitest";

const web = join(import.meta.dirname, "../..");
const run = promisify(execFile);

// util, skeleton, document, engine <- sync <- io, viewport <- app <- ui; package, what import "rigless" gives, stands on io.
// What each directory of src may import besides itself.
const base = ["util", "skeleton", "document", "engine"];
const below: Record<string, string[]> = {
  util: [],
  gltf: ["util"],
  stage: ["util", "skeleton", "gltf"],
  skeleton: ["util"],
  engine: ["util"],
  document: ["util"],
  sync: base,
  io: [...base, "gltf", "sync"],
  package: [...base, "sync", "io"],
  viewport: ["util", "skeleton", "document", "gltf", "stage"],
  app: [...base, "gltf", "stage", "sync", "io"],
  page: ["app", "engine", "io", "assets"],
  ui: ["util", "skeleton", "app"],
  styles: [],
};

/** Imports of one file (path relative to src) that its layer may not have. */
function forbidden(path: string, text: string): string[] {
  const layer = path.split("/")[0] ?? "";
  if (!path.includes("/")) return []; // main.ts puts everything together
  const allowed = below[layer];
  if (!allowed) return [`${path}: no such layer`];
  const specifiers = [...text.matchAll(/\b(?:from|import|import\(|new URL\()\s*["']([^"']+)["']/g)].map((m) => m[1] ?? "");
  return specifiers
    .filter((specifier) => {
      if (!specifier.startsWith(".")) return ["engine", "app"].includes(layer) && !specifier.startsWith("node:");
      const target =
        join(path, "..", specifier)
          .replace(/^\.\.\//, "")
          .split("/")[0] ?? ""; // ../assets lies beside src
      return target !== layer && !allowed.includes(target);
    })
    .map((specifier) => `${path}: ${specifier}`);
}

test("no import goes up or sideways", () => {
  const src = join(web, "src");
  const files = readdirSync(src, { recursive: true, encoding: "utf8" }).filter((file) => /\.(ts|css)$/.test(file));
  expect(files.length).toBeGreaterThan(0);
  expect(files.flatMap((file) => forbidden(file, readFileSync(join(src, file), "utf8")))).toEqual([]);
});

test("a back edge is seen", () => {
  expect(forbidden("sync/a.ts", `import { b } from "../io/b";`)).toHaveLength(1);
  expect(forbidden("sync/deep/a.ts", `import type { b } from '../../ui/b.ts';`)).toHaveLength(1);
  expect(forbidden("engine/a.ts", `import "../document/types";`)).toHaveLength(1);
  expect(forbidden("document/a.ts", `export * from "../engine/types";`)).toHaveLength(1);
  expect(forbidden("io/a.ts", `const v = await import("../viewport/index");`)).toHaveLength(1);
  expect(forbidden("viewport/a.ts", `new Worker(new URL("../io/worker.ts", import.meta.url));`)).toHaveLength(1);
  expect(forbidden("engine/a.ts", `import * as three from "three";`)).toHaveLength(1);
  expect(forbidden("app/a.ts", `import { html } from "lit";`)).toHaveLength(1);
  expect(forbidden("app/a.ts", `import type { a } from "../viewport/a";`)).toHaveLength(1);
  expect(forbidden("ui/a.ts", `import type { a } from "../document/a";`)).toHaveLength(1);
  expect(forbidden("ui/a.ts", `import { a } from "../app/a";\nimport { b } from "./b";\nimport { html } from "lit";`)).toEqual([]);
});

test("nothing of the app imports the session, which puts it together", () => {
  const app = join(web, "src/app");
  const knows = readdirSync(app).filter((file) => /from "\.\/session"/.test(readFileSync(join(app, file), "utf8")));
  expect(knows).toEqual([]);
});

/** What the type checker says of the app layer under the few globals of app-globals.d.ts, without those of a page. */
async function check(project: string): Promise<string> {
  return run("node_modules/.bin/tsc", ["--noEmit", "--project", project], { cwd: web }).then(
    () => "",
    ({ stdout }: { stdout: string }) => stdout,
  );
}

test("the app compiles where there is no page, and what it reads of one is refused", async () => {
  expect(await check("tsconfig.app.json")).toBe("");
  const said = await check("tests/fixtures/page-globals/tsconfig.json");
  for (const name of ["document", "window", "matchMedia", "HTMLElement", "Worker", "localStorage", "requestAnimationFrame"])
    expect(said).toContain(`'${name}'`);
});

/** Files that import each other in a circle, types counted; an empty list if there is none. */
function circle(imports: ReadonlyMap<string, readonly string[]>): string[] {
  const done = new Set<string>();
  const visit = (file: string, path: readonly string[]): string[] => {
    if (path.includes(file)) return [...path.slice(path.indexOf(file)), file];
    if (done.has(file)) return [];
    done.add(file);
    for (const next of imports.get(file) ?? []) {
      const found = visit(next, [...path, file]);
      if (found.length > 0) return found;
    }
    return [];
  };
  for (const file of imports.keys()) {
    const found = visit(file, []);
    if (found.length > 0) return found;
  }
  return [];
}

test("no circle, not even of types", () => {
  const src = join(web, "src");
  const files = readdirSync(src, { recursive: true, encoding: "utf8" }).filter((file) => file.endsWith(".ts"));
  const importsOf = (file: string): string[] =>
    [...readFileSync(join(src, file), "utf8").matchAll(/\b(?:from|import|import\()\s*["'](\.[^"']+)["']/g)].map((match) =>
      join(file, "..", match[1] ?? "").replace(/(\.ts)?$/, ".ts"),
    );
  const imports = new Map(files.map((file) => [file, importsOf(file)]));
  expect([...imports.values()].flat().length).toBeGreaterThan(300);
  expect(circle(imports)).toEqual([]);
  expect(circle(new Map(Object.entries({ a: ["b"], b: ["c", "d"], c: [], d: ["b"] })))).toEqual(["b", "d", "b"]);
});

test("no line is longer than 140 columns", () => {
  const long = ["src", "cli", "tests"].flatMap((folder) =>
    readdirSync(join(web, folder), { recursive: true, encoding: "utf8" })
      .filter((file) => /\.(ts|js|css)$/.test(file))
      .flatMap((file) =>
        readFileSync(join(web, folder, file), "utf8")
          .split("\n")
          .flatMap((line, k) => ([...line].length > 140 ? [`${folder}/${file}:${k + 1}`] : [])),
      ),
  );
  expect(long).toEqual([]);
});
