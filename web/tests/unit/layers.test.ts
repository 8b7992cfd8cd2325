import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";

// util, skeleton, document, engine <- sync <- io, viewport <- app <- ui. What each directory of src may import besides itself.
const base = ["util", "skeleton", "document", "engine"];
const below: Record<string, string[]> = {
  util: [],
  skeleton: ["util"],
  engine: ["util"],
  document: ["util"],
  sync: base,
  io: [...base, "sync"],
  viewport: [...base, "sync"],
  app: [...base, "sync", "io", "viewport", "ui", "assets"], // viewport and ui until the session is split
  ui: [...base, "sync", "io", "viewport", "app", "styles", "assets"],
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
      if (!specifier.startsWith(".")) return layer === "engine" && !specifier.startsWith("node:");
      const target =
        join(path, "..", specifier)
          .replace(/^\.\.\//, "")
          .split("/")[0] ?? ""; // ../assets lies beside src
      return target !== layer && !allowed.includes(target);
    })
    .map((specifier) => `${path}: ${specifier}`);
}

test("no import goes up or sideways", () => {
  const src = join(import.meta.dirname, "../../src");
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
  expect(forbidden("ui/a.ts", `import { a } from "../sync/a";\nimport { b } from "./b";\nimport { html } from "lit";`)).toEqual([]);
});
