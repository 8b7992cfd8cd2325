// rigless bake: a project, or a model and a motion, to an animated GLB and the dance as numbers.

import { basename } from "node:path";

import type { ProjectDocument } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import { buildSkinInNode } from "../../src/engine/skin-node";
import type { Motion, MotionInput } from "../../src/engine/types";
import type { FoundClip } from "../../src/io/clips/found-clip";
import { everyFor, exportDance, sayLikeness, sizeFault } from "../../src/io/export-dance";
import { formatNamed, listed } from "../../src/io/formats";
import { count } from "../../src/io/count";
import type { Model } from "../../src/io/model";
import type { Profile } from "../../src/io/profile";
import { PROFILES } from "../../src/io/profiles";
import type { FoundMotion } from "../../src/io/read-motion-files";
import { keptFrames } from "../../src/io/write-glb";
import { serializeTrack, trackOf } from "../../src/io/write-track";
import { bake } from "../../src/sync/bake";
import { Binding } from "../../src/sync/binding";
import { guessProject } from "../../src/sync/guess";
import { pairingFault, pairingNotes } from "../../src/sync/pairing";
import { shapeInput } from "../../src/sync/shape-input";
import { FileError, loadModelAndMotion, loadProject, OutputFiles } from "../files";
import type { Progress } from "../progress";
import { readClipsInThread, readModelInThread, type ThreadOptions } from "../parse-in-thread";
import { readArguments, UsageError } from "../verb";

export const help = `  rigless bake <project> --out dance.glb [--track track.json] [--every K] [--anyway]
  rigless bake <model> <motion> --out dance.glb [...]
  rigless bake <model that moves> --out dance.glb [...]

<project> is a project.json beside the files that it names, or a saved .rigless file.
<model>: ${listed("model", "or")}. <motion>: ${listed("motion", "or")}, files in any order. How the
model stands, where it is held and which joints move it is then guessed from its shape, and said.

  --out FILE     an animated GLB
  --clip NAME    the motion to take of a file that holds several
  --profile P    how it holds the dance: ${PROFILES.map(({ id, words }) => `${id} (${words})`).join(", ")}
  --track FILE   the dance as numbers: points, root, contacts
  --every K      keep every K-th frame in the GLB (default 1)
  --anyway       bake even if the motion has none of the joints that the points follow`;

const OPTIONS = {
  out: { type: "string", short: "o" },
  clip: { type: "string" },
  profile: { type: "string" },
  track: { type: "string" },
  every: { type: "string" },
  anyway: { type: "boolean" },
} as const;

interface BakeCommand {
  /** One project, or a model and the files of a motion. */
  inputs: string[];
  out: string | null;
  clip: string | null;
  profile: Profile;
  track: string | null;
  every: number;
  anyway: boolean;
  progress: Progress;
}

export async function run(args: readonly string[], signal: AbortSignal): Promise<void> {
  await runBake(commandOf(args), signal);
}

/** Errors (UsageError): something is missing, too much or no number. */
function commandOf(args: readonly string[]): BakeCommand {
  const { values, inputs, progress } = readArguments(args, OPTIONS);
  const [first, second] = inputs;
  if (first === undefined) throw new UsageError("bake needs a project, or a model and a motion. See rigless --help.");
  const kinds = inputs.map((input) => formatNamed(input)?.kind);
  if (kinds.some((kind) => kind === "project" || kind === "archive") && second !== undefined)
    throw new UsageError(`bake takes one project; "${second}" is too much.`);
  if (kinds[0] === "model" && second === undefined && !formatNamed(first)?.clips)
    throw new UsageError(`bake needs a motion too: rigless bake ${first} motion.bvh --out dance.glb`);
  if (values.out === undefined && values.track === undefined) throw new UsageError("bake needs --out, --track or both.");
  const every = Number(values.every ?? 1);
  if (!Number.isInteger(every) || every < 1) throw new UsageError(`--every should be a whole number from 1, but it is "${values.every}".`);
  const profile = PROFILES.find(({ id }) => id === (values.profile ?? PROFILES[0].id));
  if (!profile) throw new UsageError(`--profile should be ${PROFILES.map(({ id }) => id).join(" or ")}, but it is "${values.profile}".`);
  const [out, clip, track] = [values.out ?? null, values.clip ?? null, values.track ?? null];
  return { inputs, out, clip, profile, track, every, anyway: values.anyway ?? false, progress };
}

/** Errors (FileError): the GLB would be too large. */
function checkSize({ out, every, profile }: BakeCommand, model: Model, frames: number): void {
  const fault = out === null ? null : sizeFault(model, [frames], every, profile);
  if (!fault) return;
  throw new FileError(`${out} ${fault.text}: --every ${fault.every} keeps fewer of its ${frames.toLocaleString("en-US")} frames.`);
}

/** Errors (FileError): nothing of the model would move as the human does. With --anyway the notes say so. */
function checkPairing(document: ProjectDocument, motion: Motion, anyway: boolean): void {
  const fault = anyway ? null : pairingFault(document, motion);
  if (fault !== null) throw new FileError(`${fault} --anyway bakes it all the same.`);
}

interface Opened {
  document: ProjectDocument;
  model: Model;
  motion: MotionInput;
}

async function openProject(path: string, progress: Progress, signal: AbortSignal): Promise<Opened> {
  const { document, modelFiles, motion } = await loadProject(path);
  if (document.points.length === 0) throw new FileError(`${basename(path)}: points is empty; at least one is needed to dance.`);
  const model = await readModelInThread(modelFiles, reading(progress, signal));
  const vertices = model.positions.length / 3;
  if (document.points.length > vertices) {
    throw new FileError(
      `${basename(path)} has ${count(document.points.length, "point")}, but ${model.name} only ${count(vertices, "vertex", "vertices")}.`,
    );
  }
  return { document, model, motion };
}

function reading(progress: Progress, signal: AbortSignal, step = "Reading the model"): ThreadOptions {
  progress.step(step);
  return { signal, onProgress: (done) => progress.step(step, done) };
}

/** Errors (UsageError): the file holds several and none is asked for, or none of this name; says which it holds. */
function chosenClip(file: string, clips: readonly FoundClip[], wanted: string | null): FoundMotion {
  const same = ({ name }: FoundClip): boolean => name.toLowerCase() === wanted?.toLowerCase();
  const chosen = wanted === null && clips.length === 1 ? clips[0] : clips.find(same);
  if (chosen) return chosen.motion;
  const list = clips.map(({ name, seconds }) => `\n  ${name} (${seconds.toFixed(1)} s)`).join("");
  throw new UsageError(
    wanted === null
      ? `${file} holds ${count(clips.length, "motion")}; choose one with --clip NAME:${list}`
      : `${file} holds no motion "${wanted}", but:${list}`,
  );
}

/** A model and a motion without a project: what a project would say is guessed. */
async function guessed({ inputs, clip, progress }: BakeCommand, binding: Binding, signal: AbortSignal): Promise<Opened> {
  const { modelFiles, motion: read, clipFiles } = await loadModelAndMotion(inputs);
  if (read && clip !== null) throw new UsageError(`--clip chooses a motion of an FBX or a GLB, but ${read.input.name} is one motion.`);
  const motion =
    read ?? chosenClip(clipFiles[0].name, await readClipsInThread(clipFiles, reading(progress, signal, "Reading the motion")), clip);
  const model = await readModelInThread(modelFiles, reading(progress, signal));
  progress.step("Looking at the model");
  const { joints } = await binding.takeMotion(motion.input, () => ({ signal }));
  const said = await binding.engine.analyseShape(shapeInput(model), { signal });
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
  const { progress, profile, every } = command;
  const outputs = await OutputFiles.prepare([command.out, command.track]);
  const engine = await createNodeEngine();
  const binding = new Binding(engine);
  try {
    const { document, model, motion } =
      command.inputs.length === 1 && !formatNamed(command.inputs[0])?.clips
        ? await openProject(command.inputs[0], progress, signal)
        : await guessed(command, binding, signal);
    const baked = await bake(
      binding,
      document,
      { model, motion },
      {
        signal,
        onProgress: (step, done) => progress.step(step, done),
        onMotion: (read) => checkPairing(document, read, command.anyway),
        onSolved: (frames) => checkSize(command, model, frames),
      },
    );
    for (const note of [...model.notes, ...baked.motion.notes, ...pairingNotes(document, baked.motion)]) progress.note(note);
    if (command.out !== null) {
      progress.step("Writing");
      const name = document.name || motion.name.replace(/\.[^.]*$/, "");
      const tools = { buildSkin: buildSkinInNode, signal, onProgress: (done: number) => progress.step("Writing", done) };
      const dance = { name, model, mesh: document.mesh, points: document.points, clips: [{ name, frames: baked.frames }] };
      const { bytes: glb, likeness } = await exportDance(dance, every, tools, profile);
      await outputs.add(command.out, glb);
      const kept = keptFrames(baked.frames.length, every).length;
      progress.done(
        `${command.out}: ${count(kept, "frame")}, ` +
          `${count(model.drawn.toVertex.length, "vertex", "vertices")}, ${(glb.length / 1e6).toFixed(1)} MB`,
      );
      if (likeness) progress.note(`${sayLikeness(likeness)}.`);
      if (profile.mostKept !== null && kept > profile.mostKept) {
        const enough = everyFor([baked.frames.length], profile);
        progress.note(`Some viewers take at most ${profile.mostKept} kept frames: --every ${enough} stays below.`);
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
