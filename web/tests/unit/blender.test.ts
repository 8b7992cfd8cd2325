// examples/blender, where Blender is installed.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it, onTestFinished } from "vitest";

import { readClips } from "../../src/io/clips/read-clips";
import { readModel } from "../../src/io/read-model";

const root = fileURLToPath(new URL("../../..", import.meta.url));
// Its importer needs numpy, which is a package of its own.
const probe = ["--background", "--python-exit-code", "1", "--python-expr", "import numpy"];
const hasBlender = spawnSync("blender", probe).status === 0;

it.skipIf(!hasBlender)("makes an FBX of a dance: all clips, joints and triangles", { timeout: 120_000 }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "rigless-"));
  onTestFinished(() => rmSync(folder, { recursive: true }));
  const run = (command: string, ...args: string[]): void => {
    const { status, stdout, stderr } = spawnSync(command, args, { cwd: root, encoding: "utf8" });
    expect(status, stdout + stderr).toBe(0);
  };
  const [glb, fbx] = [join(folder, "dance.glb"), join(folder, "dance.fbx")];
  const assets = "web/assets";
  const motions = [`${assets}/motions/hop.bvh`, `${assets}/motions/walk.bvh`];
  run("node", "web/cli/rigless.js", "bake", `${assets}/characters/egg/project.json`, ...motions, "--out", glb, "-q");
  const script = ["--python-exit-code", "1", "--python", join(root, "examples/blender/glb_to_fbx.py")];
  run("blender", "--background", ...script, "--", glb, fbx);
  const fileOf = (path: string) => ({ name: path, bytes: new Uint8Array(readFileSync(path)) });
  const [before, after] = [await readModel([fileOf(glb)]), await readModel([fileOf(fbx)])];
  expect(after.faces.length).toBe(before.faces.length);
  expect(after.joints.map(({ name }) => name).filter((name) => name !== "root")).toEqual(
    expect.arrayContaining(before.joints.map(({ name }) => name).filter((name) => name !== "root")),
  );
  const [there, here] = [await readClips([fileOf(glb)]), await readClips([fileOf(fbx)])];
  expect(here.map(({ name }) => name.replace(/^.*\|/, "")).sort()).toEqual(there.map(({ name }) => name).sort());
  for (const { name, seconds } of here) {
    expect(seconds).toBeCloseTo(there.find((clip) => name.endsWith(clip.name))?.seconds ?? 0, 1);
  }
});
