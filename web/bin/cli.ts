// The command line: the page's readers, engine and writers without a page.

import { basename } from "node:path";
import { parseArgs } from "node:util";

import { version } from "../package.json";
import { DocumentError } from "../src/document/project";
import { EngineError } from "../src/engine/types";
import { createNodeEngine } from "../src/engine/node";
import { bake } from "../src/io/bake";
import { count } from "../src/io/model";
import { ModelError } from "../src/io/named-file";
import { readModel } from "../src/io/read-model";
import { glbBytes, keptFrames, writeGlb } from "../src/io/write-glb";
import { serializeTrack, trackOf } from "../src/io/write-track";
import { meshInput, pairingNotes, stageFor } from "../src/sync/prepare";
import { FileError, loadProject, OutputFiles } from "./files";
import { Progress } from "./progress";

const HELP = `Human motion on any mesh, without a rig.

  rigless bake <project> --out dance.glb [--track track.json] [--every K] [--quiet]

<project> is a project.json beside the files that it names, or a saved .rigless file.

  --out FILE     an animated GLB: one morph target per kept frame
  --track FILE   the dance as numbers: points, root, contacts
  --every K      keep every K-th frame in the GLB (default 1)
  --quiet        say nothing but errors
  --help         this page
  --version      ${version}
`;

/** Viewers draw so many morph targets at most, the strictest of them. */
const MOST_TARGETS = 256;

/** A larger GLB cannot be made in one piece, nor opened. */
const MOST_BYTES = 2 ** 31;

class UsageError extends Error {}

interface BakeCommand {
  project: string;
  out: string | null;
  track: string | null;
  every: number;
  quiet: boolean;
}

/** Runs one command; answers the exit code: 0 done, 1 could not, 2 was not understood, 130 interrupted. */
export async function main(args: readonly string[]): Promise<number> {
  const interrupt = new AbortController();
  const onSignal = (): void => interrupt.abort();
  process.on("SIGINT", onSignal);
  process.on("SIGTERM", onSignal);
  try {
    const command = readArguments(args);
    if (typeof command === "string") process.stdout.write(command);
    else await runBake(command, interrupt.signal);
    return 0;
  } catch (error) {
    if (interrupt.signal.aborted) {
      process.stderr.write("rigless: interrupted, nothing was written.\n");
      return 130;
    }
    const message = error instanceof Error ? error.message : String(error);
    process.stderr.write(`rigless: ${isExpected(error) ? "" : "this should not have happened: "}${message}\n`);
    return error instanceof UsageError ? 2 : 1;
  } finally {
    process.off("SIGINT", onSignal);
    process.off("SIGTERM", onSignal);
  }
}

/** Errors (FileError): the GLB would be too large. */
function checkSize(out: string, vertices: number, frames: number, every: number): void {
  const bytes = (k: number): number => glbBytes(vertices, keptFrames(frames, k).length);
  if (bytes(every) <= MOST_BYTES) return;
  let k = every;
  while (k < frames && bytes(k) > MOST_BYTES) k++;
  throw new FileError(`${out} would hold ${(bytes(every) / 1e9).toFixed(1)} GB, more than a GLB can: --every ${k} keeps fewer of its ${frames.toLocaleString("en-US")} frames.`);
}

function isExpected(error: unknown): boolean {
  return [UsageError, FileError, DocumentError, ModelError, EngineError].some((kind) => error instanceof kind);
}

/** A command, or a text to print. */
function readArguments(args: readonly string[]): BakeCommand | string {
  const { values, positionals } = parsed(args);
  if (values.help || args.length === 0) return HELP;
  if (values.version) return `${version}\n`;
  const [verb, project, ...more] = positionals;
  if (verb !== "bake") throw new UsageError(`"${verb ?? ""}" is no command. See rigless --help.`);
  if (project === undefined) throw new UsageError("bake needs a project. See rigless --help.");
  if (more.length > 0) throw new UsageError(`bake takes one project; "${more[0]}" is too much.`);
  if (values.out === undefined && values.track === undefined) throw new UsageError("bake needs --out, --track or both.");
  const every = Number(values.every ?? 1);
  if (!Number.isInteger(every) || every < 1) throw new UsageError(`--every should be a whole number from 1, but it is "${values.every}".`);
  return { project, out: values.out ?? null, track: values.track ?? null, every, quiet: values.quiet ?? false };
}

function parsed(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        out: { type: "string", short: "o" }, track: { type: "string" }, every: { type: "string" },
        quiet: { type: "boolean", short: "q" }, help: { type: "boolean", short: "h" }, version: { type: "boolean", short: "v" },
      },
    });
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}

async function runBake(command: BakeCommand, signal: AbortSignal): Promise<void> {
  const progress = new Progress(command.quiet);
  const outputs = await OutputFiles.prepare([command.out, command.track]);
  const { document, modelFiles, motion } = await loadProject(command.project);
  if (document.points.length === 0) throw new FileError(`${basename(command.project)}: points is empty; at least one is needed to dance.`);
  progress.step("Reading the model");
  const model = await readModel(modelFiles);
  const vertices = model.positions.length / 3;
  if (document.points.length > vertices) {
    throw new FileError(`${basename(command.project)} has ${count(document.points.length, "point")}, but ${model.name} only ${count(vertices, "vertex", "vertices")}.`);
  }
  const engine = await createNodeEngine();
  try {
    const baked = await bake(engine, document, model, motion, {
      signal,
      onProgress: (step, done) => progress.step(step, done),
      onSolved: (frames) => command.out !== null && checkSize(command.out, model.drawn.toVertex.length, frames, command.every),
    });
    for (const note of [...model.notes, ...baked.motion.notes, ...pairingNotes(document, baked.motion)]) progress.note(note);
    if (command.out !== null) {
      progress.step("Writing");
      const rest = meshInput(model, document.mesh).positions;
      const scale = 1 / stageFor(model, document.mesh).scale;
      const name = document.name || motion.name.replace(/\.[^.]*$/, "");
      const glb = await writeGlb({ name, drawn: model.drawn, faces: model.faces, rest, frames: baked.frames, scale, every: command.every });
      await outputs.add(command.out, glb);
      const targets = keptFrames(baked.frames.length, command.every).length;
      progress.done(`${command.out}: ${count(targets, "morph target")}, ${count(model.drawn.toVertex.length, "vertex", "vertices")}, ${(glb.length / 1e6).toFixed(1)} MB`);
      if (targets > MOST_TARGETS) {
        progress.note(`Some viewers draw at most ${MOST_TARGETS} morph targets: --every ${Math.ceil(baked.frames.length / (MOST_TARGETS - 1))} stays below.`);
      }
    }
    if (command.track !== null) {
      await outputs.add(command.track, new TextEncoder().encode(serializeTrack(trackOf(document, model, baked))));
      progress.done(`${command.track}: ${count(document.points.length, "point")}, ${count(baked.frames.length, "frame")}`);
    }
    signal.throwIfAborted();
    await outputs.commit();
  } finally {
    engine.close();
    await outputs.discard();
  }
}
