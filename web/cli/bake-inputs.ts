// What there is to bake: a project, or a model and what is guessed of it, with one motion or several.

import { basename } from "node:path";

import type { ProjectDocument } from "../src/document/types";
import type { MotionInput, ShapeAnalysis } from "../src/engine/types";
import type { FoundClip } from "../src/io/clips/found-clip";
import { count } from "../src/io/count";
import { formatNamed } from "../src/io/formats";
import type { Model } from "../src/io/model";
import { ownDance } from "../src/io/own-dance";
import type { FoundMotion } from "../src/io/read-motion-files";
import type { Binding } from "../src/sync/binding";
import { guessPoints, guessProject } from "../src/sync/guess";
import { shapeInput } from "../src/sync/shape-input";
import { FileError, loadModelAndMotions, loadMotions, loadProject, type MotionFiles, motionsOfProject } from "./files";
import { readClipsInThread, readModelInThread, type ThreadOptions } from "./parse-in-thread";
import type { Progress } from "./progress";
import { UsageError } from "./verb";

export interface BakeInputs {
  readonly document: ProjectDocument;
  readonly model: Model;
  /** One at least. */
  readonly motions: readonly FoundMotion[];
  /** Who dances beside; the motion only where it has one of its own. */
  readonly beside: { readonly model: Model; readonly motion: MotionInput | null } | null;
}

export interface Asked {
  /** A project and perhaps motions, or a model and the files of motions. */
  readonly inputs: readonly string[];
  readonly clip: string | null;
  /** All motions that there are. */
  readonly all: boolean;
  readonly progress: Progress;
}

/** Whether the first input is a project. */
export const isProject = ([first]: readonly string[]): boolean => ["project", "archive"].includes(formatNamed(first)?.kind ?? "");

/** Errors: FileError, UsageError, ModelError, EngineError. */
export function openInputs(asked: Asked, binding: Binding, signal: AbortSignal): Promise<BakeInputs> {
  const [first, ...more] = asked.inputs;
  return isProject(asked.inputs) || (more.length === 0 && !formatNamed(first)?.clips)
    ? openProject(asked, signal)
    : guessed(asked, binding, signal);
}

async function openProject(asked: Asked, signal: AbortSignal): Promise<BakeInputs> {
  const [path, ...more] = asked.inputs;
  const { document, modelFiles, motion, beside } = await loadProject(path);
  if (document.points.length === 0) throw new FileError(`${basename(path)}: points is empty; at least one is needed to dance.`);
  if (document.companion?.points.length === 0)
    throw new FileError(`${basename(path)}: performers[1].points is empty; at least one is needed to dance.`);
  const own = { files: document.motion.files, input: motion };
  const motions =
    more.length > 0 ? await motionsOf(asked, await loadMotions(more), signal) : asked.all ? await motionsOfProject(path, own) : [own];
  const model = await readModelInThread(modelFiles, reading(asked, signal));
  checkPoints(basename(path), document, model);
  const { companion } = document;
  if (!companion || !beside) return { document, model, motions, beside: null };
  const other = await readModelInThread(beside.modelFiles, reading(asked, signal));
  checkPoints(basename(path), companion, other);
  return { document, model, motions, beside: { model: other, motion: beside.motion } };
}

/** Errors (FileError): it has fewer vertices. */
function checkPoints(project: string, { points }: Pick<ProjectDocument, "points">, { name, positions }: Model): void {
  const vertices = positions.length / 3;
  if (points.length <= vertices) return;
  throw new FileError(`${project} has ${count(points.length, "point")}, but ${name} only ${count(vertices, "vertex", "vertices")}.`);
}

/** A model and motions without a project: what a project would say is guessed. */
async function guessed(asked: Asked, binding: Binding, signal: AbortSignal): Promise<BakeInputs> {
  const { progress } = asked;
  const { modelFiles, ...files } = await loadModelAndMotions(asked.inputs);
  const motions = await motionsOf(asked, files, signal);
  const model = await readModelInThread(modelFiles, reading(asked, signal));
  progress.step("Looking at the model");
  const { joints } = await binding.takeMotion({ motion: { files: motions[0].files } }, motions[0].input, () => ({ signal }));
  const said = await binding.engine.analyseShape(shapeInput(model), { signal });
  const guess = guessProject(model.name.replace(/\.[^.]*$/, ""), model.name, motions[0].files, model, said, joints);
  const own = files.clipFiles.some(([file]) => file === modelFiles[0]);
  const document = own ? await withOwnDances(guess, { model, said, motions, progress }, binding, signal) : guess;
  const { up, facing } = document.mesh;
  progress.note(
    `${model.name} is taken to stand with ${up} up and to look along ${facing}; ` +
      `${said.symmetry ? "its sides are alike" : "its sides are not alike"}.`,
  );
  progress.note(
    `guessed ${count(document.points.length, "point")}: ` +
      `${document.points.map(({ name, joint }) => `${name} follows ${joint ?? "the whole pose"}`).join(", ")}.`,
  );
  return { document, model, motions, beside: null };
}

/** The clips of the model's own file as they were made. */
async function withOwnDances(
  guess: ProjectDocument,
  { model, said, motions, progress }: Pick<BakeInputs, "model" | "motions"> & { said: ShapeAnalysis; progress: Progress },
  binding: Binding,
  signal: AbortSignal,
): Promise<ProjectDocument> {
  let document = guess;
  for (const motion of motions) {
    const read = await binding.takeMotion({ motion: { files: motion.files } }, motion.input, () => ({ signal }));
    const { more } = guessPoints(model, said, read.joints);
    document = ownDance(model, document, more, read, motion)?.(document) ?? document;
  }
  const poses = document.examples.length;
  if (poses > 0)
    progress.note(
      `${model.name} dances as its own joints move it: ${count(poses, "pose")} of its own ${poses > 1 ? "are" : "is"} its examples.`,
    );
  return document;
}

function reading({ progress }: Asked, signal: AbortSignal, step = "Reading the model"): ThreadOptions {
  progress.step(step);
  return { signal, onProgress: (done) => progress.step(step, done) };
}

/** Errors (UsageError): a clip is asked for where there is none; chosenClips'. */
async function motionsOf(asked: Asked, { motions, clipFiles }: MotionFiles, signal: AbortSignal): Promise<FoundMotion[]> {
  if (asked.clip !== null && clipFiles.length === 0)
    throw new UsageError(`--clip chooses a motion of an FBX or a GLB, but ${motions[0].input.name} is one motion.`);
  const found = [...motions];
  for (const files of clipFiles) {
    const clips = await readClipsInThread(files, reading(asked, signal, "Reading the motion"));
    found.push(...chosenClips(files[0].name, clips, asked).map(({ motion }) => motion));
  }
  return found;
}

/** Errors (UsageError): the file holds several and none is asked for, or none of this name; says which it holds. */
function chosenClips(file: string, clips: readonly FoundClip[], { clip: wanted, all }: Asked): readonly FoundClip[] {
  if (all || (wanted === null && clips.length === 1)) return clips;
  const chosen = clips.find(({ name }) => name.toLowerCase() === wanted?.toLowerCase());
  if (chosen) return [chosen];
  const list = clips.map(({ name, seconds }) => `\n  ${name} (${seconds.toFixed(1)} s)`).join("");
  throw new UsageError(
    wanted === null
      ? `${file} holds ${count(clips.length, "motion")}; choose one with --clip NAME, or --all:${list}`
      : `${file} holds no motion "${wanted}", but:${list}`,
  );
}
