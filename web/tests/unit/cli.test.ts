import { type ChildProcess, execFile, spawn } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { validateBytes } from "gltf-validator";
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from "vitest";
import { build } from "vite";

import { version } from "../../package.json";
import { FORMATS } from "../../src/io/formats";
import { saveProject } from "../../src/io/project-file";
import { companionOf, setCompanion } from "../../src/document/duet";
import { parseProject, serializeProject } from "../../src/document/project";
import type { Track } from "../../src/io/write-track";
import { hasShared, PNG, sharedFile } from "../support/files";
import { openGlb, triangle, valuesOf } from "../support/gltf";
import { gliding, movingFbx, movingGlb } from "../support/clips";
import { SNAKE } from "../support/joints";
import { post } from "./engine-support";

const web = fileURLToPath(new URL("../../", import.meta.url));
const program = join(web, "cli/rigless.js");
const cactus = join(web, "assets/cactus/project.json");

vi.setConfig({ testTimeout: 180_000 }); // whole bakes, on a busy machine too

let folder = "";

beforeAll(() => build({ root: web, configFile: join(web, "vite.node.config.ts"), logLevel: "error" }), 120_000);
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), "rigless-"))));
afterEach(() => rmSync(folder, { recursive: true }));

interface Run {
  code: number | null;
  stdout: string;
  stderr: string;
}

function rigless(...args: string[]): Promise<Run> {
  return new Promise((resolve) => {
    execFile(process.execPath, [program, ...args], { cwd: folder }, (error, stdout, stderr) =>
      resolve({ code: error ? (typeof error.code === "number" ? error.code : null) : 0, stdout, stderr }),
    );
  });
}

const bytesOf = (name: string): Uint8Array<ArrayBuffer> => new Uint8Array(readFileSync(join(folder, name)));
const trackOf = (name: string): Track => JSON.parse(readFileSync(join(folder, name), "utf8")) as Track;

/** V x 3 of target n played alone. */
async function playedFrame(glb: Uint8Array<ArrayBuffer>, n: number): Promise<{ positions: Float32Array; targets: number }> {
  const document = await openGlb(glb);
  const rest = valuesOf(document, "POSITION") ?? [];
  const delta = valuesOf(document, "POSITION", { target: n }) ?? [];
  const { targets = [] } = document.json.meshes![0].primitives[0];
  return { positions: Float32Array.from(rest, (x, i) => x + delta[i]), targets: targets.length };
}

function copySpot(into: string): void {
  mkdirSync(into, { recursive: true });
  copyFileSync(new URL("../fixtures/spot-walk/project.json", import.meta.url), join(into, "project.json"));
  for (const file of ["meshes/spot.obj", "motions/02.asf", "motions/02_01.amc"])
    writeFileSync(join(into, basename(file)), sharedFile(file).bytes);
}

it("does what README.md says, as it is written there", async () => {
  const readme = readFileSync(join(web, "../README.md"), "utf8");
  const commands = [...readme.matchAll(/^node web\/cli\/rigless\.js (.+)$/gm)].map((match) => match[1].split(" "));
  expect(commands).toHaveLength(2);
  for (const args of commands) {
    const run = await rigless(...args.map((arg) => (arg.includes("/") ? join(web, "..", arg) : arg)));
    expect(run, run.stderr).toMatchObject({ code: 0 });
    expect(readdirSync(folder)).toContain("dance.glb");
    rmSync(join(folder, "dance.glb"));
  }
});

describe("rigless bake", () => {
  it("makes a faultless GLB and a track of the cactus that comes with the page", async () => {
    const run = await rigless("bake", cactus, "--out", "dance.glb", "--track", "track.json", "--profile", "morph");
    expect(run).toMatchObject({ code: 0, stdout: "" });
    const glb = bytesOf("dance.glb");
    const { issues } = await validateBytes(glb);
    expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });

    const track = trackOf("track.json");
    const C = track.points.length;
    expect(track).toMatchObject({ format: "rigless-track", version: 1, fps: 30 });
    expect(C).toBeGreaterThan(0);
    expect(track.controls).toHaveLength(track.frames);
    expect(track.contacts.labels).toHaveLength(track.frames);
    expect(track.controls.every((frame) => frame.length === C && frame.flat().every(Number.isFinite))).toBe(true);
    track.contacts.runs.forEach((runs, c) => {
      const labels = track.contacts.labels.map((row) => row[c]);
      expect(labels.map((_, f) => Number(runs.some(([a, b]) => a <= f && f < b)))).toEqual(labels);
    });

    // Each frame stands on the ground, and the model's own surface is where the track says that its points are.
    const at = Math.floor(track.frames / 2);
    const { positions, targets } = await playedFrame(glb, at);
    expect(targets).toBe(track.frames);
    const height = 1.7 / track.units.metresPerUnit;
    for (const point of track.controls[at]) {
      let nearest = Infinity;
      for (let v = 0; v < positions.length; v += 3) {
        nearest = Math.min(nearest, Math.hypot(positions[v] - point[0], positions[v + 1] - point[1], positions[v + 2] - point[2]));
      }
      expect(nearest / height).toBeLessThan(0.02);
    }

    // Fewer frames of the same dance, in the same bytes.
    const again = await rigless("bake", cactus, "--out", "few.glb", "--track", "again.json", "--every", "10", "--profile", "morph", "-q");
    expect(again).toEqual({ code: 0, stdout: "", stderr: "" });
    expect(bytesOf("again.json")).toEqual(bytesOf("track.json"));
    const few = await playedFrame(bytesOf("few.glb"), 3);
    expect(few.targets).toBe(Math.ceil((track.frames - 1) / 10) + 1);
    expect(few.positions).toEqual((await playedFrame(glb, 30)).positions);
  });

  it("makes a small game character unless told otherwise, and says how like the dance it is", async () => {
    const run = await rigless("bake", cactus, "--out", "game.glb");
    expect(run.code).toBe(0);
    expect(run.stderr).toMatch(
      /\n.*\d+ joints; 0\.\d\d % of the model's size off on average, 0\.\d\d % in the worst place; light [\d.]+ degrees off\./,
    );
    expect((await validateBytes(bytesOf("game.glb"))).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
    expect((await openGlb(bytesOf("game.glb"))).json.skins).toHaveLength(1);
    expect(bytesOf("game.glb").length).toBeLessThan(200_000);
  });

  it("bakes both dancers of a project into one file, and only the first with several motions", async () => {
    const asset = (path: string) => join(web, "assets", path);
    const read = (path: string): Uint8Array => new Uint8Array(readFileSync(asset(path)));
    const project = (path: string) => parseProject(readFileSync(asset(path), "utf8"), path).document;
    const hand = project("cactus/project.json");
    const lamp = project("characters/lamp/project.json");
    const motion = { files: ["kick.bvh"] };
    const offset = { seconds: 0.5, place: [1.6, 0], yaw: 0 } as const;
    const duet = setCompanion(companionOf(lamp, offset, null))({ ...hand, motion });
    const files = [
      { name: "cactus.glb", bytes: read("cactus/cactus.glb") },
      { name: "lamp.glb", bytes: read("characters/lamp/lamp.glb") },
      { name: "kick.bvh", bytes: read("motions/kick.bvh") },
    ];
    writeFileSync(join(folder, "duet.rigless"), saveProject(duet, files));
    const run = await rigless("bake", "duet.rigless", "--out", "duet.glb", "--json", "--to", "0.4", "--profile", "morph", "--every", "10");
    expect(run.code, run.stderr).toBe(0);
    expect((await validateBytes(bytesOf("duet.glb"))).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
    const { json } = await openGlb(bytesOf("duet.glb"));
    expect([json.meshes?.length, json.animations?.length]).toEqual([2, 1]);

    // The same beside the files that it names.
    for (const { name, bytes } of files) writeFileSync(join(folder, name), bytes);
    writeFileSync(join(folder, "project.json"), serializeProject(duet));
    const again = await rigless("bake", "project.json", "--out", "again.glb", "--to", "0.4", "--profile", "morph", "--every", "10", "-q");
    expect(again.code, again.stderr).toBe(0);
    expect(bytesOf("again.glb")).toEqual(bytesOf("duet.glb"));
    const more = [asset("motions/kick.bvh"), asset("motions/folk.bvh")];
    const alone = await rigless(
      "bake",
      "project.json",
      ...more,
      "--out",
      "alone.glb",
      "--to",
      "0.4",
      "--profile",
      "morph",
      "--every",
      "10",
    );
    expect(alone.stderr).toContain("lamp dances beside to one motion, so it is left out.");
    expect((await openGlb(bytesOf("alone.glb"))).json.meshes).toHaveLength(1);
  });

  it("makes one file of several motions, at the asked pace, and tells a machine of it", async () => {
    const motions = ["kick", "folk"].map((name) => join(web, `assets/motions/${name}.bvh`));
    const run = await rigless("bake", cactus, ...motions, "-q", "--json", "--out", "two.glb", "--in-place", "--fps", "24");
    expect(run.code, run.stderr).toBe(0);
    const glb = bytesOf("two.glb");
    const report = JSON.parse(run.stdout);
    expect(report).toMatchObject({ file: "two.glb", bytes: glb.length, clips: [{ name: "kick" }, { name: "folk" }] });
    expect(report.warnings).toEqual(["kick.bvh seems to be in centimetres.", "folk.bvh seems to be in centimetres."]);
    expect(report.worst).toBeGreaterThan(report.rms);
    expect((await validateBytes(glb)).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
    const { accessors = [], animations = [], skins = [] } = (await openGlb(glb)).json;
    expect(skins).toHaveLength(1);
    expect(skins[0].joints).toHaveLength(report.joints);
    const ends = animations.map(({ samplers }) => accessors[samplers[0].input]);
    ends.forEach(({ count, max = [] }, n) => {
      expect(count).toBe(report.clips[n].frames);
      expect(24 * max[0]).toBeCloseTo(count - 1, 4);
    });
  });

  it("cuts, speeds up, mirrors and loops motions, as the project says and over it", async () => {
    const said = { "hop.bvh": { cut: [20, 60], speed: 2, mirror: true } };
    const project = JSON.parse(readFileSync(cactus, "utf8"));
    for (const file of ["cactus/cactus.glb", "motions/hop.bvh"]) copyFileSync(join(web, "assets", file), join(folder, basename(file)));
    writeFileSync(join(folder, "said.json"), JSON.stringify({ ...project, motion: { files: ["hop.bvh"] }, clips: said }));
    const dance = async (input: string, ...args: string[]) => {
      const run = await rigless("bake", input, ...args, "--track", "track.json", "--out", "dance.glb", "-q", "--json");
      expect(run.code, run.stderr).toBe(0);
      const { clips, warnings } = JSON.parse(run.stdout);
      return { clip: clips[0], warnings, track: trackOf("track.json") };
    };
    const own = await dance("said.json");
    expect(own.track).toMatchObject({ fps: 60, frames: 41 });
    expect(own.clip).toMatchObject({ frames: 21, seconds: 40 / 60 });
    const over = await dance(cactus, "--from", "0.667", "--to", "2", "--speed", "2", "--mirror");
    expect(over.track).toEqual({ ...own.track, source: over.track.source });
    const loop = await dance(cactus, "--loop");
    expect(loop.warnings).toContain("hop.bvh loops best from 0.40 s to 2.30 s, and is cut there.");
    expect(loop.track.frames).toBe(58);
    const [first, last] = [loop.track.root[0], loop.track.root[57]];
    expect(last[1]).toBeCloseTo(first[1], 4);
    const asCut = await dance(cactus, "--loop", "--to", "1");
    expect(asCut.track.frames).toBe(31);
    for (const [args, problem] of [
      [["--speed", "9"], '--speed should be a number from 0.25 to 4, but it is "9".'],
      [["--from", "soon"], '--from should be a number of seconds that a motion may last, but it is "soon".'],
      [["--from", "2", "--to", "1"], "--to should be later than --from by a frame, 0.034 seconds, but they are 1 and 2."],
    ] as const) {
      const run = await rigless("bake", cactus, ...args, "--track", "none.json");
      expect([run.code, run.stderr.includes(problem)], run.stderr).toEqual([2, true]);
    }
    const kept = await dance("said.json", "--from", "1");
    expect(kept.track.frames).toBe(own.track.frames - 10); // ends where the project has it
    const short = await rigless("bake", cactus, "--loop", "--to", "0.1", "--track", "none.json");
    expect([short.code, short.stderr]).toEqual([1, expect.stringContaining("hop.bvh has 4 frames to loop, but 8 are needed")]);
    writeFileSync(
      join(folder, "far.json"),
      JSON.stringify({ ...project, motion: { files: ["hop.bvh"] }, clips: { "hop.bvh": { cut: [500, 600] } } }),
    );
    const far = await rigless("bake", "far.json", "--track", "none.json");
    expect([far.code, far.stderr]).toEqual([1, expect.stringContaining("hop.bvh lasts 3.87 s, so its dance cannot begin at 16.67 s.")]);
    const [one, two] = project.points;
    const place = (id: string, point: string, y: number) => ({ id, point, frame: 30, kind: "place", position: [0, y, 0] });
    const odd = {
      file: { joints: { "left hand": "Nope" } },
      pins: [place("n1", one.id, 1), place("n2", one.id, 2), place("n3", two.id, 1)],
    };
    writeFileSync(join(folder, "odd.json"), JSON.stringify({ ...project, motion: { files: ["hop.bvh"] }, clips: { "hop.bvh": odd } }));
    const { warnings } = await dance("odd.json");
    expect(warnings).toContain('hop.bvh has no joint "Nope": its left hand is guessed.');
    const missed = warnings.filter((words: string) => words.startsWith("The pin of "));
    expect(missed).toHaveLength(2);
    expect(missed[0]).toMatch(/ at frame 30 is missed by \d+ cm\. The pin of .* stands against it; they met half way\.$/);
    const late = await rigless("bake", cactus, "--from", "60", "--track", "none.json");
    expect([late.code, late.stderr]).toEqual([1, expect.stringContaining("hop.bvh lasts 3.87 s, so its dance cannot begin at 60.00 s.")]);
  }, 120_000);

  it("writes to standard output as -", async () => {
    const bytes = await new Promise<Buffer>((resolve) => {
      const args = [program, "bake", cactus, "--out", "-", "-q", "--every", "8"];
      execFile(process.execPath, args, { cwd: folder, encoding: "buffer", maxBuffer: 1e8 }, (_, stdout) => resolve(stdout));
    });
    expect(bytes.subarray(0, 4).toString()).toBe("glTF");
    expect(bytes.readUInt32LE(8)).toBe(bytes.length);
    expect(readdirSync(folder)).toEqual([]);
  });

  it.skipIf(!hasShared)(
    "walks a cow with an ASF and an AMC, from a folder and from a saved file (skipped where ../shared/data is absent)",
    async () => {
      copySpot(join(folder, "spot"));
      const run = await rigless("bake", "spot/project.json", "--track", "loose.json", "--out", "spot.glb");
      expect(run.code).toBe(0);
      const track = trackOf("loose.json");
      expect(track.frames).toBe(86);
      expect(track.source).toEqual({ model: "spot.obj", motion: ["02.asf", "02_01.amc"], frames: 343, fps: 120 });
      expect((await validateBytes(bytesOf("spot.glb"))).issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
      // It goes somewhere, with its hind hooves on the ground by turns.
      expect(Math.hypot(track.root[85][0] - track.root[0][0], track.root[85][2] - track.root[0][2])).toBeGreaterThan(0.5);
      expect(track.contacts.runs[2].length).toBeGreaterThan(0);
      expect(track.contacts.runs[3].length).toBeGreaterThan(0);

      const { document } = parseProject(readFileSync(join(folder, "spot/project.json"), "utf8"), "project.json");
      const files = ["meshes/spot.obj", "motions/02.asf", "motions/02_01.amc"].map(sharedFile);
      writeFileSync(join(folder, "cow.rigless"), saveProject(document, files));
      expect((await rigless("bake", "cow.rigless", "--track", "saved.json", "-q")).code).toBe(0);
      expect(trackOf("saved.json")).toEqual(track);
    },
  );
});

describe("rigless bake without a project", () => {
  const HOP = join(web, "assets/motions/hop.bvh");

  it("guesses how a model stands and what moves it, and says so", async () => {
    const { positions, faces } = post();
    const rows = (kind: string, numbers: number[]): string =>
      Array.from({ length: numbers.length / 3 }, (_, n) => `${kind} ${numbers.slice(3 * n, 3 * n + 3).join(" ")}\n`).join("");
    writeFileSync(
      join(folder, "post.obj"),
      rows("v", [...positions]) +
        rows(
          "f",
          Array.from(faces, (v) => v + 1),
        ),
    );
    const run = await rigless("bake", "post.obj", HOP, "--out", "dance.glb", "--track", "track.json", "--profile", "morph");
    expect(run).toMatchObject({ code: 0, stdout: "" });
    expect(run.stderr).toContain("note: post.obj is taken to stand with +y up and to look along +z; its sides are alike.\n");
    expect(run.stderr).toContain(
      "note: guessed 5 points: Head follows Head, Left foot follows LeftFoot, Right foot follows RightFoot, " +
        "Chest follows Spine2, Hips follows Hips.\n",
    );
    expect((await validateBytes(bytesOf("dance.glb"))).issues.numErrors).toBe(0);
    expect(trackOf("track.json").points.length).toBeGreaterThan(1);
  });

  it("takes the motion of an FBX, and a model with its own; of several the one that is named", async () => {
    const person = movingGlb({ Walk: gliding(1), Run: gliding(2) }, { mesh: true });
    const files = { "ball.glb": movingGlb({}, { mesh: true }).bytes, "walk.fbx": movingFbx().bytes, "person.glb": person.bytes };
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    const bake = (...args: string[]): Promise<Run> => rigless("bake", ...args, "--track", "track.json");
    expect(await bake("ball.glb", "walk.fbx")).toMatchObject({ code: 0 });
    expect(trackOf("track.json").source).toMatchObject({ model: "ball.glb", motion: ["walk.bvh"] });
    expect(await bake("ball.glb", "person.glb")).toMatchObject({
      code: 2,
      stderr: expect.stringContaining(
        "person.glb holds 2 motions; choose one with --clip NAME, or --all:\n  Walk (1.0 s)\n  Run (1.0 s)\n",
      ) as string,
    });
    expect((await bake("ball.glb", "person.glb", "--clip", "Sit")).stderr).toContain('person.glb holds no motion "Sit", but:\n  Walk');
    expect(await bake("ball.glb", "person.glb", "--clip", "run")).toMatchObject({ code: 0 });
    expect(trackOf("track.json").source).toMatchObject({ model: "ball.glb", motion: ["person Run.bvh"] });
    expect(await bake("person.glb", "--clip", "Walk", "--anyway")).toMatchObject({ code: 0 });
    expect(trackOf("track.json").source).toMatchObject({ model: "person.glb", motion: ["person Walk.bvh"] });
    const taken = await rigless("bake", "person.glb", "--clip", "Walk", "--anyway", "--out", "taken.glb");
    expect(taken.stderr).toContain("note: The model's own skeleton and 2 clips are replaced.\n");
    expect((await bake("ball.glb")).stderr).toBe("rigless: ball.glb holds no motion: name one beside it, as in ball.glb motion.bvh.\n");
  });

  it.skipIf(!hasShared)("walks a cow that nobody has said anything about (skipped where ../shared/data is absent)", async () => {
    for (const file of ["meshes/spot.obj", "motions/02.asf", "motions/02_01.amc"])
      writeFileSync(join(folder, basename(file)), sharedFile(file).bytes);
    const run = await rigless("bake", "spot.obj", "02_01.amc", "02.asf", "--track", "track.json");
    expect(run.code).toBe(0);
    expect(run.stderr).toContain("note: spot.obj is taken to stand with +y up and to look along -z; its sides are alike.\n");
    expect(run.stderr).toContain("Head follows head");
    const track = trackOf("track.json");
    expect(track.source).toMatchObject({ model: "spot.obj", motion: ["02.asf", "02_01.amc"] });
    // It goes somewhere, with all four hooves on the ground by turns.
    expect(Math.hypot(track.root[85][0] - track.root[0][0], track.root[85][2] - track.root[0][2])).toBeGreaterThan(0.5);
    expect(track.contacts.runs.filter((runs) => runs.length > 0)).toHaveLength(4);
  });
});

describe("what cannot be done", () => {
  const project = (change: object): string =>
    JSON.stringify({
      version: 1,
      mesh: { file: "bean.obj" },
      motion: { files: ["hop.bvh"] },
      points: [{ id: "a", name: "a", position: [0, 0, 0], joint: null }],
      ...change,
    });

  async function refused(files: Record<string, string | Uint8Array>, ...args: string[]): Promise<string> {
    for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
    const before = readdirSync(folder);
    const run = await rigless(...(args.length ? args : ["bake", "project.json", "--out", "dance.glb", "--quiet"]));
    expect(run.stdout).toBe("");
    expect(run.stderr).toMatch(/^rigless: [^\n]+\n$/);
    expect(readdirSync(folder)).toEqual(before);
    expect(run.code).toBe(/--(?!every \d|anyway bakes)|bake /.test(run.stderr) ? 2 : 1);
    return run.stderr.slice("rigless: ".length, -1);
  }

  const hop = readFileSync(join(web, "assets/motions/hop.bvh"));
  const bean = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

  it("names the file and what is wrong with it", async () => {
    expect(await refused({})).toBe("project.json: there is no such file.");
    expect(await refused({ "project.json": "{" })).toMatch(/^project\.json is not whole JSON: /);
    expect(await refused({ "project.json": new Uint8Array([1, 0, 2]) })).toBe(
      "project.json is neither a project.json nor a saved project.",
    );
    expect(await refused({ "project.json": project({ version: 3 }) })).toContain("saved by a newer Rigless (version 3)");
    expect(await refused({ "project.json": project({ points: 3 }) })).toBe(
      "project.json: points should be a list of objects, but it is 3.",
    );
    expect(await refused({ "project.json": project({}) })).toBe("project.json names bean.obj: there is no such file.");
    expect(await refused({ "bean.obj": bean })).toBe("project.json names hop.bvh: there is no such file.");
    expect(await refused({ "hop.bvh": hop, "bean.obj": bean + "f 1 2 9\n" })).toBe(
      "bean.obj, line 9: a face names vertex 9, but there are 4 vertices above it.",
    );
    expect(await refused({ "bean.obj": bean, "hop.bvh": "HIERARCHY\nROOT a\n{\n" })).toMatch(/^hop\.bvh/);
    expect(
      await refused(
        { "project.json": readFileSync(program).subarray(0, 3), "x.zip": "PK\u0003\u0004junk" },
        "bake",
        "x.zip",
        "--out",
        "a.glb",
      ),
    ).toMatch(/^x\.zip is a broken zip: /);
  });

  it("is not led astray by what a model names beside it", async () => {
    writeFileSync(join(folder, "project.json"), project({ mesh: { file: "bean.obj" } }));
    writeFileSync(join(folder, "hop.bvh"), hop);
    writeFileSync(join(folder, "bean.obj"), "\n".repeat(300_000) + "mtllib bean.obj\nmtllib a.mtl\nmtllib /dev/zero\n" + bean);
    writeFileSync(join(folder, "a.mtl"), "newmtl a\nmap_Kd a.mtl\n");
    expect(await rigless("bake", "project.json", "--track", "t.json", "-q")).toEqual({ code: 0, stdout: "", stderr: "" });
    const gltf = '{"asset":{"version":"2.0"},"buffers":[{"uri":"%zz.bin","byteLength":4}]}';
    expect(await refused({ "bean.gltf": gltf, "project.json": project({ mesh: { file: "bean.gltf" } }) })).toBe(
      "bean.gltf needs %zz.bin; drop both together.",
    );
    expect(await refused({ "project.json": project({ mesh: { file: "/dev/zero" } }) })).toBe(
      "project.json names /dev/zero: there is no such file.",
    );
    symlinkSync("/dev/zero", join(folder, "zero.obj"));
    expect(await refused({ "project.json": project({ mesh: { file: "zero.obj" } }) })).toBe(
      "project.json names zero.obj: it is not a file.",
    );
  });

  it("takes nothing from outside the model's folder, but what has the same name in it", async () => {
    const inside = join(folder, "inside");
    mkdirSync(inside);
    const { maker, primitive } = triangle();
    primitive.attributes.TEXCOORD_0 = maker.floats([0, 0, 1, 0, 0, 1], "VEC2");
    primitive.material = 0;
    maker.json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    maker.json.textures = [{ source: 0 }, { source: 1 }, { source: 2 }];
    maker.json.images = [{ uri: "../secret.png" }, { uri: join(folder, "diary.png") }, { uri: "notes.txt" }];
    writeFileSync(join(inside, "bean.glb"), maker.glb().bytes);
    writeFileSync(join(inside, "hop.bvh"), hop);
    writeFileSync(join(inside, "notes.txt"), "no picture");
    writeFileSync(join(inside, "project.json"), project({ mesh: { file: "bean.glb" } }));
    for (const name of ["secret.png", "diary.png"]) writeFileSync(join(folder, name), PNG);
    const bake = () => rigless("bake", "inside/project.json", "--out", "dance.glb", "--anyway");
    const alone = await bake();
    expect(alone.stderr).toContain("note: This model names secret.png, diary.png; drop them too.\n");
    expect(alone.stderr).toContain("note: notes.txt is not a PNG, JPEG, WebP, KTX2, BMP or TGA picture; we show the model without it.\n");
    expect((await openGlb(bytesOf("dance.glb"))).images).toEqual([null, null, null]);
    writeFileSync(join(inside, "secret.png"), PNG);
    await bake();
    expect((await openGlb(bytesOf("dance.glb"))).images.map((image) => image?.bytes ?? null)).toEqual([PNG, null, null]);

    // Neither does a buffer come from elsewhere: its numbers could be read off the dance.
    writeFileSync(join(folder, "far.bin"), "0123456789");
    const gltf = '{"asset":{"version":"2.0"},"buffers":[{"uri":"../far.bin","byteLength":4}]}';
    writeFileSync(join(inside, "bean.gltf"), gltf);
    writeFileSync(join(inside, "project.json"), project({ mesh: { file: "bean.gltf" } }));
    expect((await bake()).stderr).toContain("rigless: bean.gltf needs far.bin; drop both together.\n");
  });

  it("needs a point, and frames that fit into a file", async () => {
    expect(await refused({ "bean.obj": bean, "hop.bvh": hop, "project.json": project({ points: [] }) })).toBe(
      "project.json: points is empty; at least one is needed to dance.",
    );
    const points = Array.from({ length: 5 }, (_, n) => ({ id: `${n}`, name: "", position: [0, 0, 0], joint: null }));
    expect(await refused({ "project.json": project({ points }) })).toBe("project.json has 5 points, but bean.obj only 4 vertices.");
    const slow =
      "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n}\nMOTION\nFrames: 300\nFrame Time: 0.99\n" +
      Array.from({ length: 300 }, (_, f) => `0 ${f % 2} 0\n`).join("");
    const anyway = ["bake", "project.json", "--out", "dance.glb", "--profile", "morph", "--quiet", "--anyway"];
    expect(await refused({ "hop.bvh": slow, "project.json": project({}) }, ...anyway)).toBe(
      "dance.glb would hold 318 MB, more than the 200 MB that viewers open: --every 2 keeps fewer of its 8,881 frames.",
    );
  });

  it("does not bake a motion that cannot move the points, unless it is told to", async () => {
    const untold =
      "We cannot tell which joints of hop.bvh are its head, hands and feet, neither by their names nor by how they hang together.";
    expect(await refused({ "bean.obj": bean, "hop.bvh": SNAKE, "project.json": project({}) })).toBe(
      `${untold} --anyway bakes it all the same.`,
    );
    expect(await refused({}, "bake", "bean.obj", "hop.bvh", "--track", "t.json", "--quiet")).toBe(
      `${untold} --anyway bakes it all the same.`,
    );
    const run = await rigless("bake", "project.json", "--track", "t.json", "--anyway");
    expect(run).toMatchObject({ code: 0, stderr: expect.stringContaining(`note: ${untold}\n`) as string });

    const points = ["Fin", "Tail"].map((joint, n) => ({ id: joint, name: joint, position: [n, 0, 0], joint }));
    expect(await refused({ "hop.bvh": hop, "project.json": project({ points }) })).toBe(
      'hop.bvh has none of the joints "Fin", "Tail", which the points follow. --anyway bakes it all the same.',
    );
    const lost = await rigless("bake", "project.json", "--track", "t.json", "--anyway");
    expect(lost).toMatchObject({
      code: 0,
      stderr: expect.stringContaining('note: hop.bvh has none of the joints "Fin", "Tail": all points follow the whole pose.\n') as string,
    });
    const some = [...points, { id: "h", name: "Hand", position: [0, 1, 0], joint: "rig:l_hand" }];
    writeFileSync(join(folder, "project.json"), project({ points: some }));
    const run2 = await rigless("bake", "project.json", "--track", "t.json");
    expect(run2).toMatchObject({
      code: 0,
      stderr: expect.stringContaining('has no joint "Fin": "Fin" follows the whole pose.\n') as string,
    });
    expect(run2.stderr).not.toContain("Hand");
  });

  it("takes one model and one motion", async () => {
    const bake = (...files: string[]): string[] => ["bake", ...files, "--out", "dance.glb"];
    expect(await refused({ "bean.obj": bean, "hop.bvh": hop }, ...bake("bean.obj", "no.bvh"))).toBe("no.bvh: there is no such file.");
    expect(await refused({ "two.obj": bean }, ...bake("bean.obj", "two.obj"))).toBe(
      "one model and a motion are needed, but among bean.obj, two.obj there are 2 and 0.",
    );
    expect(await refused({ "a.amc": ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\n" }, ...bake("bean.obj", "a.amc"))).toContain(
      "needs its skeleton",
    );
  });

  it("does not begin when there is no place for the result", async () => {
    expect(await refused({ "project.json": project({}) }, "bake", "project.json", "--out", "no/where.glb")).toBe(
      "no/where.glb: there is no folder no.",
    );
    expect(await refused({}, "bake", "project.json", "--out", ".")).toBe(".: it is a folder.");
  });

  it("replaces no input, device or link to nothing, and no result by another", async () => {
    const files = { "project.json": project({}), "bean.obj": bean, "hop.bvh": hop };
    const own = "it is read for this; a result goes elsewhere.";
    const bake = (...args: string[]): string[] => ["bake", "project.json", "--anyway", "--quiet", ...args];
    expect(await refused(files, ...bake("--out", "bean.obj"))).toBe(`bean.obj: ${own}`);
    symlinkSync("hop.bvh", join(folder, "link.glb"));
    expect(await refused({}, ...bake("--out", "link.glb"))).toBe(`link.glb: ${own}`);
    expect(bytesOf("hop.bvh")).toEqual(new Uint8Array(hop));
    symlinkSync("nothing", join(folder, "lost.glb"));
    expect(await refused({}, ...bake("--out", "lost.glb"))).toBe("lost.glb: it is a link to nothing.");
    expect(await refused({}, ...bake("--out", "/dev/null"))).toBe("/dev/null: it is a device or a pipe, not a file.");
    expect(await refused({}, ...bake("--out", "a.glb", "--track", "./a.glb"))).toBe("./a.glb: two results cannot be one file.");
  });

  it("asks for what it needs", async () => {
    expect(await refused({}, "bake")).toBe("bake needs a project, or a model and a motion. See rigless --help.");
    expect(await refused({}, "bake", "a.json")).toBe("bake needs --out, --track or both.");
    expect(await refused({}, "bake", "a.json", "--out", "a.glb", "--every", "0")).toBe(
      '--every should be a whole number from 1, but it is "0".',
    );
    expect(await refused({}, "bake", "a.json", "--out", "a.glb", "--profile", "no")).toBe(
      '--profile should be game, cartoon or morph, but it is "no".',
    );
    expect(await refused({}, "bake", "a.json", "b.json", "--out", "a.glb")).toBe('bake takes one project; "b.json" is too much.');
    expect(await refused({}, "bake", "a.obj", "--out", "a.glb")).toBe(
      "bake needs a motion too: rigless bake a.obj motion.bvh --out dance.glb",
    );
    expect(await refused({}, "bake", "--louder")).toBe("There is no option --louder. See rigless --help.");
    expect(await refused({}, "bake", "a.json", "--speed", "--loop")).toBe("--speed needs a value after it.");
    expect(await refused({}, "bake", "a.json", "--loop=3")).toBe("--loop takes no value.");
    expect(await refused({}, "boil")).toBe('"boil" is no command. See rigless --help.');
  });

  it("leaves nothing behind when it is interrupted", async () => {
    const child: ChildProcess = spawn(process.execPath, [program, "bake", cactus, "--out", "dance.glb"], { cwd: folder });
    let said = "";
    const code = await new Promise<number | null>((resolve) => {
      child.stderr?.on("data", (chunk: Buffer) => {
        if (said === "") child.kill("SIGINT");
        said += chunk.toString();
      });
      child.on("exit", resolve);
    });
    expect(code).toBe(130);
    expect(said).toMatch(/rigless: interrupted, nothing was written\.\n$/);
    expect(readdirSync(folder)).toEqual([]);
  });
});

it("knows its version and tells what it can do", async () => {
  expect(await rigless("--version")).toEqual({ code: 0, stdout: `${version}\n`, stderr: "" });
  const help = await rigless("--help");
  expect(help.code).toBe(0);
  for (const word of ["bake", "--out", "--track", "--every", "--quiet", "--help", "--version"]) expect(help.stdout).toContain(word);
  const verbs = readdirSync(join(web, "cli/verbs")).map((file) => file.replace(".ts", ""));
  for (const verb of verbs) {
    expect(help.stdout).toContain(`\n  rigless ${verb} <`);
    expect((await rigless(verb, "--help")).stdout).toContain(`\n  rigless ${verb} <`);
  }
  for (const { kind, words } of FORMATS) if (kind === "model" || kind === "motion") expect(help.stdout).toContain(words);
});
