// rigless bake: a project, or a model and motions, to an animated GLB and the dance as numbers.

import { basename } from "node:path";

import { saidOf } from "../../src/document/clips";
import { companionDocument } from "../../src/document/duet";
import type { ProjectDocument } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import { buildMorphsInNode, buildSkinInNode } from "../../src/engine/skin-node";
import { FPS, type Motion } from "../../src/engine/types";
import { count } from "../../src/io/count";
import { everyFor, exportDance, keptOf, lengthsOf, sayLikeness, sayReplaced, sizeFault } from "../../src/io/export-dance";
import { type DanceBeside, exportDuet } from "../../src/io/export-duet";
import { formatNamed, listed } from "../../src/io/formats";
import { PACES, paced } from "../../src/io/pace";
import type { Likeness, Profile } from "../../src/io/profile";
import { PROFILES } from "../../src/io/profiles";
import type { FoundMotion } from "../../src/io/read-motion-files";
import { type Clip, keptClips } from "../../src/io/write-glb";
import { serializeTrack, trackOf } from "../../src/io/write-track";
import { type Bake, bake } from "../../src/sync/bake";
import { Binding } from "../../src/sync/binding";
import { missedPins } from "../../src/sync/missed-pins";
import { pairingFault, pairingNotes } from "../../src/sync/pairing";
import { type Asked, type BakeInputs, openInputs } from "../bake-inputs";
import { type AskedEdits, editedMotion, motionEditsOf } from "../edited-motion";
import { FileError } from "../files";
import { OutputFiles, print, STDOUT } from "../output-files";
import { readArguments, UsageError } from "../verb";

export const help = `  rigless bake <project> [<motion> ...] --out dance.glb [--track track.json] [...]
  rigless bake <model> <motion> ... --out dance.glb [...]
  rigless bake <model that moves> --out dance.glb [...]

<project> is a project.json beside the files that it names, or a saved .rigless file.
<model>: ${listed("model", "or")}. <motion>: ${listed("motion", "or")}, files in any order. How the
model stands, where it is held and which joints move it is then guessed from its shape, and said.
Several motions become clips of one file, named after them, on one skeleton.

  --out FILE     an animated GLB; - is standard output
  --clip NAME    the motion to take of a file that holds several
  --all          all motions: of files that hold several, or those that lie beside a project's own
  --profile P    how it holds the dance: ${PROFILES.map(({ id, words }) => `${id} (${words})`).join(", ")}
  --in-place     the model stays on its spot
  --fps N        ${PACES.join(", ")} frames per second in the GLB (default ${FPS})
  --from S       the second of each motion with which its dance begins
  --to S         the second with which it ends
  --speed N      so many times as fast: 0.25 to 4
  --mirror       as a mirror shows it
  --loop         it ends as it begins, and is cut where it does so best unless it is cut otherwise
  --track FILE   the dance as numbers: points, root, contacts
  --every K      keep every K-th frame in the GLB (default 1)
  --anyway       bake even if the motion has none of the joints that the points follow
  --json         what was made as JSON on standard output`;

const OPTIONS = {
  out: { type: "string", short: "o" },
  clip: { type: "string" },
  all: { type: "boolean" },
  profile: { type: "string" },
  "in-place": { type: "boolean" },
  fps: { type: "string" },
  from: { type: "string" },
  to: { type: "string" },
  speed: { type: "string" },
  mirror: { type: "boolean" },
  loop: { type: "boolean" },
  track: { type: "string" },
  every: { type: "string" },
  anyway: { type: "boolean" },
  json: { type: "boolean" },
} as const;

interface BakeCommand extends Asked {
  readonly out: string | null;
  readonly profile: Profile;
  readonly fps: number;
  /** Of every motion, whatever the project says. */
  readonly edits: AskedEdits;
  /** Whatever the project says. */
  readonly inPlace: boolean;
  readonly track: string | null;
  readonly every: number;
  readonly anyway: boolean;
  readonly json: boolean;
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
  const other = inputs.find((_, n) => n > 0 && (kinds[n] === "project" || kinds[n] === "archive"));
  if (other !== undefined) throw new UsageError(`bake takes one project; "${other}" is too much.`);
  if (kinds[0] === "model" && second === undefined && !formatNamed(first)?.clips)
    throw new UsageError(`bake needs a motion too: rigless bake ${first} motion.bvh --out dance.glb`);
  if (values.out === undefined && values.track === undefined) throw new UsageError("bake needs --out, --track or both.");
  if (values.json && [values.out, values.track].includes(STDOUT))
    throw new UsageError("--json writes to standard output, so no file can go there too.");
  const every = Number(values.every ?? 1);
  if (!Number.isInteger(every) || every < 1) throw new UsageError(`--every should be a whole number from 1, but it is "${values.every}".`);
  const profile = PROFILES.find(({ id }) => id === (values.profile ?? PROFILES[0].id));
  if (!profile)
    throw new UsageError(
      `--profile should be ${PROFILES.map(({ id }) => id)
        .join(", ")
        .replace(/, (?=[^,]*$)/, " or ")}, but it is "${values.profile}".`,
    );
  const fps = PACES.find((pace) => `${pace}` === (values.fps ?? `${FPS}`));
  if (fps === undefined) throw new UsageError(`--fps should be ${PACES.join(" or ")}, but it is "${values.fps}".`);
  const [out, clip, track] = [values.out ?? null, values.clip ?? null, values.track ?? null];
  const [all = false, inPlace = false, anyway = false, json = false] = [values.all, values["in-place"], values.anyway, values.json];
  const edits = motionEditsOf(values);
  return { inputs, out, clip, all, profile, inPlace, fps, edits, track, every, anyway, json, progress };
}

/** Errors (FileError): the GLB would be too large. */
function checkSize({ out, every, profile }: BakeCommand, { model }: BakeInputs, clips: readonly Clip[], next: number): void {
  const frames = [...lengthsOf(clips), next];
  const fault = out === null ? null : sizeFault(model, frames, every, profile);
  if (!fault) return;
  const all = frames.reduce((sum, n) => sum + n, 0).toLocaleString("en-US");
  throw new FileError(`${out} ${fault.text}: --every ${fault.every} keeps fewer of its ${all} frames.`);
}

/** Errors (FileError): nothing of the model would move as the human does. With --anyway the notes say so. */
function checkPairing(document: ProjectDocument, motion: Motion, anyway: boolean): void {
  const fault = anyway ? null : pairingFault(document, motion);
  if (fault !== null) throw new FileError(`${fault} --anyway bakes it all the same.`);
}

const stem = (name: string): string => name.replace(/\.[^.]*$/, "");

interface Danced {
  readonly document: ProjectDocument;
  readonly baked: Bake;
  /** Whoever dances beside. */
  readonly beside: DanceBeside | null;
}

/** One motion after the other, each told when it is done. */
async function danceAll(
  command: BakeCommand,
  inputs: BakeInputs,
  binding: Binding,
  signal: AbortSignal,
): Promise<{ clips: Clip[]; last: Danced }> {
  const { progress, inPlace } = command;
  const { model, motions } = inputs;
  const settings = inPlace ? { ...inputs.document.settings, inPlace } : inputs.document.settings;
  const clips: Clip[] = [];
  let last: Danced | null = null;
  for (const [n, { files, input }] of motions.entries()) {
    const several = motions.length > 1 ? `${stem(input.name)} (${n + 1} of ${motions.length}): ` : "";
    const asked = { ...inputs.document, settings, motion: { files } };
    const document = await editedMotion(asked, input, command, binding, signal);
    const { speed = 1 } = saidOf(document);
    const baked = await bake(
      binding,
      document,
      { model, motion: input },
      {
        signal,
        onProgress: (step, done) => progress.step(several + step, done),
        onMotion: (read) => checkPairing(document, read, command.anyway),
        onSolved: (frames) => checkSize(command, inputs, clips, Math.round((frames * command.fps) / (FPS * speed))),
      },
    );
    const pinNotes = (missedPins(document, baked.performance) ?? []).map(({ words }) => words);
    for (const note of [...(n === 0 ? model.notes : []), ...baked.motion.notes, ...pairingNotes(document, baked.motion), ...pinNotes])
      progress.note(note);
    clips.push({ name: nameOf(inputs, motions, input.name), frames: paced(baked.frames, command.fps, speed) });
    last = { document, baked, beside: null };
  }
  if (!last) throw new UsageError("There is no motion to bake.");
  return { clips, last };
}

/** Whoever dances beside, to one motion only; null: nobody does. */
async function danceBeside(
  { progress, inPlace }: BakeCommand,
  { beside, motions }: BakeInputs,
  { document: hand }: Danced,
  binding: Binding,
  signal: AbortSignal,
): Promise<DanceBeside | null> {
  const [document, companion] = [companionDocument(hand), hand.companion];
  if (!beside || !document || !companion) return null;
  const name = stem(basename(document.mesh.file));
  if (motions.length > 1) {
    progress.note(`${name} dances beside to one motion, so it is left out.`);
    return null;
  }
  const own = inPlace ? { ...document, settings: { ...document.settings, inPlace } } : document;
  const baked = await bake(
    binding,
    own,
    { model: beside.model, motion: beside.motion ?? motions[0].input },
    { signal, onProgress: (step, done) => progress.step(`${name}: ${step}`, done) },
  );
  const pinNotes = (missedPins(own, baked.performance) ?? []).map(({ words }) => words);
  for (const note of [...pairingNotes(own, baked.motion), ...pinNotes]) progress.note(`${name}: ${note}`);
  return { document: own, offset: companion.offset, model: beside.model, name, frames: baked.frames };
}

/** One motion alone is called as its model is. */
function nameOf({ document }: BakeInputs, motions: readonly FoundMotion[], motion: string): string {
  return motions.length > 1 ? stem(motion) : document.name || stem(motion);
}

interface Report {
  bytes: number | null;
  joints: number | null;
  targets: number | null;
  rms: number | null;
  worst: number | null;
}

async function writeGlb(
  command: BakeCommand & { out: string },
  { document, model }: BakeInputs,
  clips: readonly Clip[],
  { baked, beside }: Danced,
  outputs: OutputFiles,
  signal: AbortSignal,
): Promise<Report> {
  const { progress, profile, every, out, fps } = command;
  progress.step("Writing");
  const name = document.name || clips[0].name;
  const tools = {
    buildSkin: buildSkinInNode,
    buildMorphs: buildMorphsInNode,
    signal,
    onProgress: (done: number) => progress.step("Writing", done),
  };
  const dance = { name, model, mesh: document.mesh, points: document.points, clips, fps };
  const { bytes: glb, likeness } = beside
    ? await exportDuet(dance, baked.frames, beside, every, tools, profile)
    : await exportDance(dance, every, tools, profile);
  await outputs.add(out, glb);
  const kept = keptOf(lengthsOf(clips), every);
  progress.done(
    `${out === STDOUT ? "standard output" : out}: ${clips.length > 1 ? `${count(clips.length, "clip")}, ` : ""}${count(kept, "frame")}, ` +
      `${count(model.drawn.toVertex.length, "vertex", "vertices")}, ${(glb.length / 1e6).toFixed(1)} MB`,
  );
  if (likeness) progress.done(`note: ${sayLikeness(likeness)}.`);
  const replaced = sayReplaced(model);
  if (replaced) progress.note(replaced);
  if (profile.mostKept !== null && kept > profile.mostKept) {
    const enough = everyFor(lengthsOf(clips), profile);
    progress.note(`Some viewers take at most ${profile.mostKept} kept frames: --every ${enough} stays below.`);
  }
  return { bytes: glb.length, ...figures(likeness) };
}

const figures = (likeness: Likeness | null): Omit<Report, "bytes"> => ({
  joints: likeness?.joints ?? null,
  targets: likeness?.targets ?? null,
  rms: likeness?.rms ?? null,
  worst: likeness?.worst ?? null,
});

async function runBake(command: BakeCommand, signal: AbortSignal): Promise<void> {
  const began = performance.now();
  const { progress, out, track, every, fps } = command;
  const outputs = await OutputFiles.prepare([out, track]);
  const engine = await createNodeEngine();
  const binding = new Binding(engine);
  try {
    const inputs = await openInputs(command, binding, signal);
    outputs.keepInputs();
    if (track !== null && inputs.motions.length > 1) throw new UsageError("--track holds one motion, but there are several.");
    const { clips, last } = await danceAll(command, inputs, binding, signal);
    let report: Report = { bytes: null, ...figures(null) };
    if (out !== null)
      report = await writeGlb(
        { ...command, out },
        inputs,
        clips,
        { ...last, beside: await danceBeside(command, inputs, last, binding, signal) },
        outputs,
        signal,
      );
    if (track !== null) {
      const { document, baked } = last;
      await outputs.add(track, new TextEncoder().encode(serializeTrack(trackOf(document, inputs.model, baked))));
      progress.done(`${track}: ${count(document.points.length, "point")}, ${count(baked.frames.length, "frame")}`);
    }
    signal.throwIfAborted();
    await outputs.commit();
    if (!command.json) return;
    const seconds = (performance.now() - began) / 1000;
    const told = keptClips(clips, every).map(({ name, kept }) => ({ name, frames: kept.length, seconds: kept[kept.length - 1] / fps }));
    const json = { file: out, track, ...report, profile: command.profile.id, clips: told, seconds, warnings: progress.notes };
    await print(`${JSON.stringify(json, null, 2)}\n`);
  } finally {
    engine.close();
    await outputs.discard();
  }
}
