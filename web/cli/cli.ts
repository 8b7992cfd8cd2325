// The command line: the page's readers, engine and writers without a page.

import { basename } from "node:path";
import { parseArgs } from "node:util";

import { version } from "../package.json";
import { DocumentError } from "../src/document/project";
import type { ProjectDocument } from "../src/document/types";
import { EngineError } from "../src/engine/types";
import type { Engine, Motion, MotionInput } from "../src/engine/types";
import { createNodeEngine } from "../src/engine/node";
import { bake } from "../src/io/bake";
import { count } from "../src/io/model";
import type { Model } from "../src/io/model";
import { MODEL_EXTENSIONS } from "../src/io/model-format";
import { extension, ModelError } from "../src/io/named-file";
import { readModel } from "../src/io/read-model";
import { glbBytes, keptFrames, writeGlb } from "../src/io/write-glb";
import { serializeTrack, trackOf } from "../src/io/write-track";
import { guessProject } from "../src/sync/guess";
import { pairingFault, pairingNotes } from "../src/sync/pairing";
import { meshInput, stageFor } from "../src/sync/prepare";
import { FileError, loadModelAndMotion, loadProject, OutputFiles } from "./files";
import { Progress } from "./progress";

const HELP = `Human motion on any mesh, without a rig.

  rigless bake <project> --out dance.glb [--track track.json] [--every K] [--anyway] [--quiet]
  rigless bake <model> <motion> --out dance.glb [...]

<project> is a project.json beside the files that it names, or a saved .rigless file.
<model> is an OBJ, OFF, PLY, STL, glTF or GLB file, <motion> a .bvh, or an .asf and an .amc. How the model stands, where it is
held and which joints move it is then guessed from its shape, and said.

  --out FILE     an animated GLB: one morph target per kept frame
  --track FILE   the dance as numbers: points, root, contacts
  --every K      keep every K-th frame in the GLB (default 1)
  --anyway       bake even if the motion has none of the joints that the points follow
  --quiet        say nothing but errors
  --help         this page
  --version      ${version}
`;

/** Viewers draw so many morph targets at most, the strictest of them. */
const MOST_TARGETS = 256;

/** A larger GLB cannot be made in one piece, nor opened. */
const MOST_BYTES = 2 ** 31;

const PROJECTS: readonly string[] = ["json", "rigless"];
const MODELS: readonly string[] = MODEL_EXTENSIONS;

class UsageError extends Error {}

interface BakeCommand {
  /** One project, or a model and the files of a motion. */
  inputs: string[];
  out: string | null;
  track: string | null;
  every: number;
  anyway: boolean;
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
  throw new FileError(
    `${out} would hold ${(bytes(every) / 1e9).toFixed(1)} GB, more than a GLB can: ` +
      `--every ${k} keeps fewer of its ${frames.toLocaleString("en-US")} frames.`,
  );
}

/** Errors (FileError): nothing of the model would move as the human does. With --anyway the notes say so. */
function checkPairing(document: ProjectDocument, motion: Motion, anyway: boolean): void {
  const fault = anyway ? null : pairingFault(document, motion);
  if (fault !== null) throw new FileError(`${fault} --anyway bakes it all the same.`);
}

function isExpected(error: unknown): boolean {
  return [UsageError, FileError, DocumentError, ModelError, EngineError].some((kind) => error instanceof kind);
}

/** A command, or a text to print. */
function readArguments(args: readonly string[]): BakeCommand | string {
  const { values, positionals } = parsed(args);
  if (values.help || args.length === 0) return HELP;
  if (values.version) return `${version}\n`;
  const [verb, ...inputs] = positionals;
  if (verb !== "bake") throw new UsageError(`"${verb ?? ""}" is no command. See rigless --help.`);
  const [first, second] = inputs;
  if (first === undefined) throw new UsageError("bake needs a project, or a model and a motion. See rigless --help.");
  if (inputs.some((input) => PROJECTS.includes(extension(input))) && second !== undefined)
    throw new UsageError(`bake takes one project; "${second}" is too much.`);
  if (MODELS.includes(extension(first)) && second === undefined)
    throw new UsageError(`bake needs a motion too: rigless bake ${first} motion.bvh --out dance.glb`);
  if (values.out === undefined && values.track === undefined) throw new UsageError("bake needs --out, --track or both.");
  const every = Number(values.every ?? 1);
  if (!Number.isInteger(every) || every < 1) throw new UsageError(`--every should be a whole number from 1, but it is "${values.every}".`);
  return {
    inputs,
    out: values.out ?? null,
    track: values.track ?? null,
    every,
    anyway: values.anyway ?? false,
    quiet: values.quiet ?? false,
  };
}

function parsed(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        out: { type: "string", short: "o" },
        track: { type: "string" },
        every: { type: "string" },
        anyway: { type: "boolean" },
        quiet: { type: "boolean", short: "q" },
        help: { type: "boolean", short: "h" },
        version: { type: "boolean", short: "v" },
      },
    });
  } catch (error) {
    throw new UsageError(error instanceof Error ? error.message : String(error));
  }
}

interface Opened {
  document: ProjectDocument;
  model: Model;
  motion: MotionInput;
}

async function openProject(path: string, progress: Progress): Promise<Opened> {
  const { document, modelFiles, motion } = await loadProject(path);
  if (document.points.length === 0) throw new FileError(`${basename(path)}: points is empty; at least one is needed to dance.`);
  progress.step("Reading the model");
  const model = await readModel(modelFiles);
  const vertices = model.positions.length / 3;
  if (document.points.length > vertices) {
    throw new FileError(
      `${basename(path)} has ${count(document.points.length, "point")}, but ${model.name} only ${count(vertices, "vertex", "vertices")}.`,
    );
  }
  return { document, model, motion };
}

/** A model and a motion without a project: what a project would say is guessed. */
async function guessed(paths: readonly string[], engine: Engine, progress: Progress, signal: AbortSignal): Promise<Opened> {
  const { modelFiles, motion } = await loadModelAndMotion(paths);
  progress.step("Reading the model");
  const model = await readModel(modelFiles);
  progress.step("ShapeAnalysis the model");
  const { joints } = await engine.setMotion(motion.input, { signal });
  const said = await engine.analyseShape({ positions: model.positions, faces: model.faces }, { signal });
  const document = guessProject(model.name.replace(/\.[^.]*$/, ""), model.name, motion.files, model, said, joints);
  const { up, facing } = document.mesh;
  progress.note(
    `${model.name} is taken to stand with ${up} up and to look along ${facing}; ` +
      `${said.symmetry ? "its sides are alike" : "its sides are not alike"}.`,
  );
  progress.note(
    `guessed ${count(document.points.length, "point")}: ` +
      `${document.points.map(({ name, joint }) => `${name} follows ${joint ?? "the whole pose"}`).join(", ")}.`,
  );
  return { document, model, motion: motion.input };
}

async function runBake(command: BakeCommand, signal: AbortSignal): Promise<void> {
  const progress = new Progress(command.quiet);
  const outputs = await OutputFiles.prepare([command.out, command.track]);
  const engine = await createNodeEngine();
  try {
    const { document, model, motion } =
      command.inputs.length === 1
        ? await openProject(command.inputs[0], progress)
        : await guessed(command.inputs, engine, progress, signal);
    const baked = await bake(engine, document, model, motion, {
      signal,
      onProgress: (step, done) => progress.step(step, done),
      onMotion: (read) => checkPairing(document, read, command.anyway),
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
      progress.done(
        `${command.out}: ${count(targets, "morph target")}, ` +
          `${count(model.drawn.toVertex.length, "vertex", "vertices")}, ${(glb.length / 1e6).toFixed(1)} MB`,
      );
      if (targets > MOST_TARGETS) {
        progress.note(
          `Some viewers draw at most ${MOST_TARGETS} morph targets: ` +
            `--every ${Math.ceil(baked.frames.length / (MOST_TARGETS - 1))} stays below.`,
        );
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
