// Both sides of the boundary say the same.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { ABI } from "../../src/engine/abi";
import { createNodeEngine } from "../../src/engine/node";
import { nod, post } from "./engine-support";

const web = join(import.meta.dirname, "../..");
const engine = join(web, "src/engine");
let scratch: string;
beforeAll(() => void (scratch = mkdtempSync(join(tmpdir(), "rigless-abi-"))));
afterAll(() => rmSync(scratch, { recursive: true }));

test.each(["engine/abi.ts", "util/constants.ts"])("src/%s is what wasm/abi.mjs makes of the C++; if not, run it", (file) => {
  execFileSync(process.execPath, [join(web, "../wasm/abi.mjs"), scratch]);
  expect(readFileSync(join(web, "src", file), "utf8")).toBe(readFileSync(join(scratch, file), "utf8"));
});

/** The functions of an interface in abi.ts. */
function declared(name: string): string[] {
  const body = new RegExp(`export interface ${name} \\{\\n(.*?)\\n\\}`, "s").exec(readFileSync(join(engine, "abi.ts"), "utf8"))?.[1] ?? "";
  return [...body.matchAll(/^ {2}(\w+)\(/gm)].map((found) => found[1]);
}

test.each([
  ["rigless.wasm", "RiglessExports"],
  ["shape-analysis.wasm", "ShapeAnalysisExports"],
  ["skin.wasm", "SkinExports"],
])("%s exports what %s declares, and nothing else", (file, name) => {
  const exported = WebAssembly.Module.exports(new WebAssembly.Module(readFileSync(join(engine, file))))
    .filter(({ kind }) => kind === "function")
    .map((one) => one.name)
    .filter((one) => !/^(stack|_*emscripten_|__errno_location$)/.test(one)); // the compiler's own
  expect(exported.sort()).toEqual(declared(name).sort());
});

describe("a module that was built from another description is refused in a sentence", () => {
  /** Both files in a folder of their own, one of them changed. */
  const folderWith = (changed: string, bytes: Uint8Array): URL => {
    const folder = join(scratch, `${changed}-${bytes.length}`);
    mkdirSync(folder);
    for (const file of ["rigless.wasm", "shape-analysis.wasm"]) copyFileSync(join(engine, file), join(folder, file));
    writeFileSync(join(folder, changed), bytes);
    return pathToFileURL(join(folder, "rigless.wasm"));
  };
  /** As if abi.h had been changed since: the module answers another number. */
  const stale = (file: string): Uint8Array => {
    const bytes = readFileSync(join(engine, file));
    const number = [0, 7, 14, 21, 28].map((shift) => ((ABI >> shift) & 0x7f) | (shift < 28 ? 0x80 : 0));
    const at = bytes.indexOf(Uint8Array.of(0x41, ...number));
    expect(at).toBeGreaterThan(0);
    bytes[at + 1] ^= 1;
    return bytes;
  };
  const empty = () => Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

  test.each([
    ["rigless.wasm", stale],
    ["rigless.wasm", empty],
    ["shape-analysis.wasm", stale],
  ])("%s", async (file, made) => {
    const core = await createNodeEngine(folderWith(file, made(file)));
    const call = file === "rigless.wasm" ? core.setMotion(nod()) : core.analyseShape(post());
    await expect(call).rejects.toMatchObject({
      code: "engine_lost",
      message: `The engine stopped: ${file} was not built together with this program; load it anew, or build both again.`,
    });
  });
});
