// One model's dances through the real command line, kept by what they were made of.
import { spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const MOTIONS = ["walk", "disco"];
const PATIENCE = 240_000;
const here = (name) => readFileSync(fileURLToPath(new URL(name, import.meta.url)));

function filesOf(folder) {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath ?? entry.path}/${entry.name}`)
    .sort();
}

export class Baker {
  constructor(clone, scratch) {
    this.clone = clone;
    this.scratch = scratch;
    if (!existsSync(`${clone}/web/dist-node`)) throw new Error(`${clone}/web: npm run build:node must have run.`);
    const code = createHash("sha256");
    for (const file of filesOf(`${clone}/web/dist-node`)) if (!file.endsWith(".d.ts")) code.update(readFileSync(file));
    for (const motion of MOTIONS) code.update(readFileSync(this.motion(motion)));
    for (const part of ["strangers.ts", "posed.ts", "measures.ts", "strangers-bake.js"]) code.update(here(part));
    this.code = code.digest("hex");
    mkdirSync(`${scratch}cache`, { recursive: true });
  }

  motion(name) {
    return `${this.clone}/web/assets/motions/${name}.bvh`;
  }

  /** draw(dances): the strip and the measures of baked GLBs. Gives these, what was said and guessed, or `refused`: the sentence. */
  async judge({ path }, draw) {
    const key = createHash("sha256").update(this.code).update(readFileSync(path)).digest("hex").slice(0, 24);
    const kept = `${this.scratch}cache/${key}.json`;
    if (existsSync(kept)) return JSON.parse(readFileSync(kept, "utf8"));
    const folder = `${this.scratch}work-${process.pid}/`;
    mkdirSync(folder, { recursive: true });
    try {
      const result = await this.bakeAndDraw(path, folder, draw);
      if (!result.late) writeFileSync(kept, JSON.stringify(result));
      return result;
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  }

  async bakeAndDraw(model, folder, draw) {
    const dances = [];
    let said = "";
    let seconds = 0;
    for (const name of MOTIONS) {
      const baked = await this.bake(model, name, folder);
      if (baked.code !== 0) return { refused: lastSentence(baked), late: baked.code === null, seconds: baked.seconds };
      said = baked.said;
      seconds += baked.seconds / MOTIONS.length;
      const { points, controls } = JSON.parse(readFileSync(`${folder}${name}.json`, "utf8"));
      dances.push({ path: `${folder}${name}.glb`, points: points.map((point, c) => ({ name: point.name, place: controls[0][c] })) });
    }
    const drawn = await draw(dances);
    const axis = (pattern) => /[+-]?[xyz]/.exec(pattern.exec(said)?.[0].replace(/up|along|stand|with|look/g, "") ?? "?")?.[0] ?? "?";
    return {
      ...drawn,
      up: axis(/[+-][xyz] up/),
      front: axis(/along [+-][xyz]/),
      points: dances[0].points.map((point) => point.name),
      seconds,
    };
  }

  /** Few frames are enough to look at; a large model keeps as few as the command line asks for. */
  async bake(model, name, folder) {
    let every = 3;
    for (;;) {
      const baked = await this.run([
        "bake",
        model,
        this.motion(name),
        "--out",
        `${folder}${name}.glb`,
        "--track",
        `${folder}${name}.json`,
        "--every",
        String(every),
      ]);
      const fewer = Number(/--every (\d+) keeps fewer/.exec(baked.said)?.[1] ?? 0);
      if (baked.code === 0 || fewer <= every) return baked;
      every = fewer;
    }
  }

  run(args) {
    const begun = performance.now();
    return new Promise((resolve) => {
      const child = spawn(process.execPath, [`${this.clone}/web/cli/rigless.js`, ...args], { stdio: ["ignore", "pipe", "pipe"] });
      let said = "";
      for (const stream of [child.stdout, child.stderr]) stream.on("data", (text) => (said += text));
      const patience = setTimeout(() => child.kill("SIGKILL"), PATIENCE);
      child.on("close", (code) => {
        clearTimeout(patience);
        resolve({ code, said, seconds: (performance.now() - begun) / 1000 });
      });
    });
  }
}

const lastSentence = ({ code, said }) =>
  code === null
    ? `not done after ${PATIENCE / 1000} s`
    : (said
        .trim()
        .split("\n")
        .findLast((line) => line.startsWith("rigless:")) ?? said.trim().slice(-300));
