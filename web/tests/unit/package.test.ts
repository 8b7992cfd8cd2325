// The npm package as a stranger gets it: packed, installed into an empty project without a network, compiled against and run.

import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, describe, expect, it } from "vitest";

import packageJson from "../../package.json";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const text = (path: string): string => readFileSync(join(root, path), "utf8");

let folder = "";
let project = "";

/** Answers what the program prints. */
function run(cwd: string, program: string, ...args: string[]): string {
  const environment = { ...process.env, npm_config_offline: "true", npm_config_update_notifier: "false" };
  return execFileSync(program, args, { cwd, encoding: "utf8", env: environment, stdio: ["ignore", "pipe", "pipe"] });
}

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "rigless-package-"));
  // Packed from a copy, because packing builds, and other tests use what is built.
  for (const path of ["README.md", "LICENSE", "web/src", "web/cli", "web/package.json", "web/pack.js", "web/vite.node.config.ts"])
    cpSync(join(root, path), join(folder, path), { recursive: true });
  for (const file of readdirSync(join(root, "web")).filter((name) => /^tsconfig.*\.json$/.test(name)))
    cpSync(join(root, "web", file), join(folder, "web", file));
  symlinkSync(join(root, "web/node_modules"), join(folder, "web/node_modules"));
  const packed = run(join(folder, "web"), "npm", "pack", "--pack-destination", folder).trim().split("\n").at(-1) ?? "";

  project = join(folder, "project");
  mkdirSync(project);
  writeFileSync(join(project, "package.json"), '{ "type": "module" }');
  run(project, "npm", "install", join(folder, packed));
  cpSync(join(root, "web/assets/motions/hop.bvh"), join(project, "dance.bvh"));
}, 120_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

const examples = [...text("README.md").matchAll(/```js\n(.*?)```/gs)].map((match) => match[1] ?? "");

describe("the npm package", () => {
  it("holds what it needs and nothing else", () => {
    const files = readdirSync(join(project, "node_modules/rigless"), { recursive: true, encoding: "utf8" });
    expect(files).toEqual(expect.arrayContaining(["README.md", "LICENSE", "package.json", "cli/rigless.js", "dist-node/rigless.wasm"]));
    const known =
      /^(README\.md|LICENSE|package\.json|cli(\/rigless\.js)?|dist-node(\/[\w.-]+\.(js|wasm)|\/types(\/\w+(\/[\w-]+\.d\.ts)?)?)?)$/;
    expect(files.filter((file) => !known.test(file))).toEqual([]);
    expect(readdirSync(join(project, "node_modules")).filter((name) => !name.startsWith("."))).toEqual(["rigless"]);
    expect(readdirSync(join(folder, "web"))).not.toContain("README.md"); // the copies went away again
  });

  it("shows examples of at most 20 lines in its README, the ones of examples/", () => {
    expect(examples).toEqual([text("examples/node/main.js"), text("examples/page/main.js")]);
    for (const example of examples) expect(example.trim().split("\n").length).toBeLessThanOrEqual(20);
  });

  it("retargets in Node by the README's example", () => {
    writeFileSync(join(project, "main.js"), examples[0]);
    const lines = run(project, process.execPath, "main.js").trim().split("\n");
    expect(lines).toHaveLength(117);
    const heights = lines.map((line) => Number(/^frame \d+: the top is at [^,]+,([^,]+),/.exec(line)?.[1]));
    // The human hops about 20 cm of his 1.7 m, and the post is 160 tall in its own units.
    expect(Math.max(...heights) - Math.min(...heights)).toBeGreaterThan(15);
    expect(heights[0]).toBeGreaterThan(120);
    expect(heights[0]).toBeLessThan(200);
  });

  it("has types that a strict project compiles against", () => {
    mkdirSync(join(project, "node_modules/@types"));
    symlinkSync(join(root, "web/node_modules/@types/node"), join(project, "node_modules/@types/node"));
    symlinkSync(join(root, "web/node_modules/undici-types"), join(project, "node_modules/undici-types"));
    writeFileSync(join(project, "main.ts"), examples[0].replace("const faces = [];", "const faces: number[] = [];"));
    writeFileSync(
      join(project, "wrong.ts"),
      'import { createRigless } from "rigless";\n(await createRigless()).retarget({ mesh: 3, motion: "" });',
    );
    const options = ["--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "--types", "node", "main.ts", "wrong.ts"];
    let said = "";
    try {
      run(project, process.execPath, join(root, "web/node_modules/typescript/bin/tsc"), ...options);
    } catch (error) {
      said = String((error as { stdout: string }).stdout);
    }
    expect(
      said
        .trim()
        .split("\n")
        .filter((line) => !line.startsWith(" ")),
    ).toEqual([expect.stringMatching(/^wrong\.ts\(2,.*TS2/)]);
  });

  it("brings the command line", () => {
    expect(run(project, "npx", "--offline", "rigless", "--version")).toBe(`${packageJson.version}\n`);
    const bake = ["bake", join(root, "web/assets/cactus/project.json"), "--track", "track.json", "-q"];
    run(project, "node_modules/.bin/rigless", ...bake);
    expect(JSON.parse(readFileSync(join(project, "track.json"), "utf8"))).toMatchObject({ format: "rigless-track", name: "Cactus" });
  });
});
