import { clipName } from "../document/clips";
import * as commands from "../document/commands";
import { withMotionNames } from "../document/renamed-motions";
import type { Gesture } from "../document/store";
import type { Companion, MeshRef, MotionRef } from "../document/types";
import { EngineError, type MotionInput } from "../engine/types";
import type { FormatKind } from "../io/format";
import { formatOf } from "../io/formats";
import type { Model } from "../io/model";
import { baseName } from "../io/named-file";
import type { NamedFile } from "../io/named-file";
import { type OpenedProject, openProject } from "../io/project-file";
import type { FoundMotion } from "../io/read-motion-files";
import { type SortedFiles, sortFiles } from "../io/sort-files";
import { pairingNotes } from "../sync/pairing";
import { isAbort } from "./aborts";
import { ClipFiles } from "./clip-files";
import type { Context } from "./context";
import { guessText, modelText, motionText, pairingText } from "./file-words";
import type { JobHandle } from "./jobs";
import type { Openers, OpeningSteps } from "./opening-steps";
import type { FileKind, PickedFile, Ports } from "./ports";

const STEPS = ["Read", "Understand", "Bind"];

/** From files to the document: loaded with the first of them. */
export class FileOpening {
  /** Once a file came that may hold several motions. */
  clipFiles: ClipFiles | null = null;

  constructor(
    private readonly context: Context,
    private readonly openers: Openers,
    private readonly ports: Pick<Ports, "readModel" | "readClips">,
    private readonly steps: OpeningSteps,
  ) {}

  async open(files: readonly PickedFile[], kind: FileKind): Promise<void> {
    const title = files.length === 1 ? `Opening ${files[0].name}` : `Opening ${files.length} files`;
    const sorted = await this.openers.jobs.run(title, STEPS, async (job) => {
      const named = await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
      job.signal.throwIfAborted();
      job.step(1);
      const { skeletons } = this.openers.sources;
      const sorted = await sortFiles(named, { skeletons, motionsOnly: kind === "motion" });
      const gesture = Symbol("open");
      if (sorted.project) await this.project(named, sorted.motions, job, gesture);
      else {
        const opened = await this.model(sorted, job, gesture);
        await this.motions(sorted.motions, job, gesture);
        if (opened) await this.guess(opened.model, opened.file, job);
        if (opened && sorted.moves) this.offerMotions(opened.model);
      }
      const [song] = sorted.songs;
      if (song) await (await this.openers.music()).take({ ...song, name: baseName(song.name) });
      const nothing = !sorted.project && [sorted.models, sorted.motions, sorted.clips, sorted.songs].every(({ length }) => length === 0);
      for (const problem of sorted.problems) this.steps.refuse(problem, nothing);
      return sorted;
    });
    for (const file of sorted.project ? [] : sorted.clips) await this.clips([file, ...sorted.files]);
  }

  /** Motions of the first of `files`, which may be a model too: `own`, which then dances them as they were made. */
  private async clips(files: readonly NamedFile[], own: Model | null = null): Promise<void> {
    const { context, openers, ports } = this;
    this.clipFiles ??= new ClipFiles(context.signals, openers.jobs, ports.readClips);
    const { clipFiles } = this;
    await this.steps.guarded(baseName(files[0].name), async () => {
      const motions = (await clipFiles.of(files)).map(({ motion }) => motion);
      if (motions.length === 0) return;
      await openers.jobs.run(motions[0].input.name, STEPS, async (job) => {
        const gesture = Symbol("open");
        await this.motions(motions, job, gesture);
        if (own) await this.ownDance(own, motions[0], job, gesture);
      });
    });
  }

  private async ownDance(model: Model, clip: FoundMotion, job: JobHandle, gesture: Gesture): Promise<void> {
    const { history, workspace } = this.context;
    const { document } = history;
    const guess = await this.openers.guesses.of(model);
    if (this.context.model !== model || !workspace.motion || !guess) return;
    const { ownDance } = await import("../io/own-dance");
    const command = ownDance(model, document, guess.more, workspace.motion, clip);
    if (!command) return;
    await this.steps.change(command, job, gesture);
    this.steps.say({
      title: `${model.name} dances as its own joints move it.`,
      text: "Poses of its own are its examples: change them as you like.",
      icon: "poses",
      actions: [history.undoAction()],
    });
  }

  /** `motions`: all that came with it, its own among them. */
  private async project(dropped: readonly NamedFile[], motions: readonly FoundMotion[], job: JobHandle, gesture: Gesture): Promise<void> {
    const opened = await openProject(dropped);
    const { sources } = this.openers;
    const model = await this.ports.readModel(opened.modelFiles, reading(job));
    job.step(2);
    const names = new Map<string, string>();
    const add = (was: readonly string[], input: MotionInput): MotionRef => {
      const files = sources.addMotion(was, input);
      names.set(clipName({ motion: { files: was } }), clipName({ motion: { files } }));
      return { files };
    };
    const motion = add(opened.document.motion.files, opened.motion);
    const file = sources.addModel(opened.document.mesh.file, model, modelFiles(opened.modelFiles));
    const beside = await this.companion(opened, job, add);
    const namesOf = (files: readonly string[]): string => files.map(baseName).join();
    for (const other of motions)
      if (![opened.document.motion, opened.document.companion?.motion].some((own) => own && namesOf(other.files) === namesOf(own.files)))
        add(other.files, other.input);
    const hand = withMotionNames({ ...opened.document, mesh: { ...opened.document.mesh, file }, motion }, names);
    const document = { ...hand, ...(beside && { companion: withMotionNames(beside, names) }) };
    const taken = await this.steps.change(() => document, job, gesture);
    const { history, selection } = this.context;
    history.markSaved();
    selection.endIntro();
    selection.setPanel(null);
    const pairing = taken.motion ? pairingText(pairingNotes(history.document, taken.motion), taken.motion) : [];
    this.steps.say({
      title: `${opened.document.name} is open.`,
      text: [...model.notes, ...pairing].join(" "),
      actions: [history.undoAction()],
    });
  }

  /** Whoever dances beside in a project, with the names that our library has for its files. */
  private async companion(
    { document: { companion }, beside }: OpenedProject,
    job: JobHandle,
    add: (files: readonly string[], input: MotionInput) => MotionRef,
  ): Promise<Companion | null> {
    const { sources } = this.openers;
    if (!companion || !beside) return null;
    const model = await this.ports.readModel(beside.modelFiles, reading(job));
    const file = sources.addModel(companion.mesh.file, model, modelFiles(beside.modelFiles));
    const motion = companion.motion && beside.motion && add(companion.motion.files, beside.motion);
    return { ...companion, mesh: { ...companion.mesh, file }, ...(motion && { motion }) };
  }

  /** Answers the model and what it is called here if it was opened. */
  private async model(sorted: SortedFiles, job: JobHandle, gesture: Gesture): Promise<{ model: Model; file: string } | null> {
    const [first, ...others] = sorted.models;
    if (!first) return null;
    const { history, selection } = this.context;
    const { sources, guesses } = this.openers;
    let opened: { model: Model; file: string } | null = null;
    await this.steps.guarded(baseName(first.name), async () => {
      const beside = sorted.files.filter((file) => !sorted.models.includes(file) && !sorted.clips.includes(file));
      const model = await this.ports.readModel([first, ...beside], reading(job));
      job.step(2);
      const file = sources.addModel(first.name, model, modelFiles([first, ...beside]));
      const guess = await guesses.of(model);
      const mesh: MeshRef = { file, ...(guess?.mesh ?? { facing: "+z", up: "+y" }), solve: "solid" };
      const named = commands.renameProject(baseName(file).replace(/\.[^.]+$/, ""));
      const { report } = await this.steps.change((document) => named(commands.setMesh(mesh)(document)), job, gesture);
      selection.endIntro();
      opened = { model: sources.model(file) ?? model, file };
      this.steps.say({ ...modelText(model, mesh, report), icon: "scale", actions: [history.undoAction()] });
    });
    for (const other of others) this.steps.say({ title: `${baseName(other.name)} was not opened.`, text: "One model at a time." });
    return opened;
  }

  /** Of a model's own file, once it dances. */
  private offerMotions(model: Model): void {
    const run = (): void => void this.clips(this.openers.sources.of(model)?.files ?? [], model);
    this.steps.say({ title: `${model.name} brings motions of its own.`, icon: "motion", actions: [{ label: "Choose", run }] });
  }

  /** Makes a model that just came dance at once, as a step of its own; where that cannot be, the person makes the points. */
  private async guess(model: Model, file: string, job: JobHandle): Promise<void> {
    const { history, selection } = this.context;
    const guess = await this.openers.guesses.of(model);
    const { mesh } = history.document;
    if (mesh.file !== file) return; // it was undone meanwhile
    try {
      if (!guess || guess.points.length === 0) throw new EngineError("bad_controls", "");
      const add = commands.addPoints(guess.points, guess.roles);
      await this.steps.change((document) => (document.mesh === mesh ? add(document) : document), job);
      if (history.document.mesh !== mesh) return; // it was undone meanwhile
      selection.setPanel(null);
      this.steps.say({ ...guessText(guess.points), icon: "points", actions: [history.undoAction()] });
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (isAbort(error)) return;
      selection.setPanel("points");
      this.steps.say({
        title: "We found no places to hold it by.",
        text: "Click a place on the model, then the joint that moves it.",
        icon: "points",
      });
    }
  }

  private async motions(motions: readonly FoundMotion[], job: JobHandle, gesture: Gesture): Promise<void> {
    const { history, selection } = this.context;
    for (const [k, motion] of motions.entries()) {
      await this.steps.guarded(motion.input.name, async () => {
        job.step(2);
        const files = this.openers.sources.addMotion(motion.files, motion.input);
        if (k > 0) return;
        const taken = await this.steps.change(commands.setMotion({ files }), job, gesture);
        selection.endIntro();
        const notes = taken.motion ? pairingNotes(history.document, taken.motion) : [];
        this.steps.say({ ...motionText(motion.input.name, taken.motion, notes), icon: "motion", actions: [history.undoAction()] });
      });
    }
    if (motions.length > 1)
      this.steps.say({
        title: `${motions.length} motions came in.`,
        text: "The first one plays; the others are in the list.",
        actions: [{ label: "Show", run: () => selection.setPanel("motion") }],
      });
  }
}

/** What lies among a model's files and is none of them. */
const NOT_BESIDE: readonly (FormatKind | undefined)[] = ["motion", "skeleton", "project"];

/** A model's own file, and what lies beside it. */
export function modelFiles([own, ...others]: readonly NamedFile[]): NamedFile[] {
  const beside = others.filter((other) => !NOT_BESIDE.includes(formatOf(other)?.kind));
  return own ? [own, ...beside] : beside;
}

export function reading({ signal, progress }: JobHandle): { signal: AbortSignal; onProgress: (done: number) => void } {
  return { signal, onProgress: progress };
}
