import * as commands from "../document/commands";
import type { Gesture } from "../document/store";
import type { MeshRef, ProjectDocument } from "../document/types";
import { EngineError } from "../engine/types";
import type { Model } from "../io/model";
import { baseName } from "../io/named-file";
import type { NamedFile } from "../io/named-file";
import type { FoundMotion } from "../io/read-motion-files";
import type { SortedFiles } from "../io/sort-files";
import { pairingNotes } from "../sync/pairing";
import type { Taken } from "../sync/workspace";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Cast, Performer } from "./cast";
import type { ClipFiles } from "./clip-files";
import type { Context } from "./context";
import { guessText, modelText, motionText, pairingText } from "./file-words";
import type { Guesses } from "./guesses";
import type { JobHandle, Jobs } from "./jobs";
import type { MotionEntry, Motions } from "./motions";
import type { NoticeInput } from "./notices";
import type { Character, FileKind, PickedFile, Ports } from "./ports";
import type { Sources } from "./sources";

const STEPS = ["Read", "Understand", "Bind"];

/** Who helps to open something. */
export interface Openers {
  readonly jobs: Jobs;
  readonly builtins: Builtins;
  readonly cast: Cast;
  readonly motions: Motions;
  readonly guesses: Guesses;
  readonly sources: Sources;
}

/** From files to the document. What cannot be opened leaves everything as it was and says so. */
export class Opening {
  /** The file of the performer or motion that was chosen and is not there yet. */
  coming: string | null = null;
  /** Once a file came that may hold several motions. */
  clipFiles: ClipFiles | null = null;

  constructor(
    private readonly context: Context,
    private readonly openers: Openers,
    private readonly ports: Pick<Ports, "readModel" | "readClips" | "files">,
  ) {}

  /** The cactus and its dance, to begin with; false if that failed. */
  async first(): Promise<boolean> {
    const { history } = this.context;
    const { builtins, sources } = this.openers;
    const [character] = builtins.characters;
    return this.guarded(character.name, async () => {
      const file = builtins.motions[0]?.file ?? "";
      const [document, text] = await Promise.all([this.character(character), builtins.motionText(file)]);
      const files = sources.addMotion([file], { name: file, text });
      history.replace({ ...document, motion: { files } });
      history.markSaved();
    });
  }

  /** Someone else takes over the dance, with the points and poses they came with or left with. One step. */
  async usePerformer(performer: Performer): Promise<void> {
    const { history } = this.context;
    const { cast } = this.openers;
    const { file, name, character } = performer;
    if (cast.isOnStage(performer)) return this.stay();
    await this.inTurn(file, name, async (job, isNewest) => {
      const own = cast.remembered(file) ?? (character && (await this.character(character)));
      if (!own || !isNewest()) return;
      job.step(1);
      const { saved } = history;
      const {
        motion,
        settings: { inPlace },
      } = history.document;
      await this.change({ ...own, motion, settings: { ...own.settings, inPlace } }, job);
      if (saved) history.markSaved();
    });
  }

  async useMotion(entry: MotionEntry): Promise<void> {
    const { workspace } = this.context;
    const { motions, builtins, sources } = this.openers;
    const { files, builtin, name } = entry;
    if (motions.isPlaying(entry)) return this.stay();
    const file = files.at(-1) ?? "";
    await this.inTurn(file, name, async (job, isNewest) => {
      if (builtin && !workspace.library.motion(files)) {
        sources.addMotion(files, { name: file, text: await builtins.motionText(file) });
      }
      if (!isNewest()) return;
      job.step(1);
      await this.change(commands.setMotion({ files })(this.context.document), job);
    });
  }

  /** The project of a character of ours, its model kept. */
  private async character(character: Character): Promise<ProjectDocument> {
    const { builtins, sources } = this.openers;
    const { document, bytes } = await builtins.load(character);
    const files = [{ name: document.mesh.file, bytes }];
    const file = sources.addModel(document.mesh.file, await this.ports.readModel(files), files);
    return { ...document, mesh: { ...document.mesh, file } };
  }

  /** Of several choices the newest wins, whichever is ready first. */
  private async inTurn(file: string, name: string, work: (job: JobHandle, isNewest: () => boolean) => Promise<void>): Promise<void> {
    this.coming = file;
    const isNewest = (): boolean => this.coming === file;
    this.context.signals.tell("coming");
    await this.guarded(file, () => this.openers.jobs.run(name, ["Load", "Bind"], (job) => work(job, isNewest)));
    if (isNewest()) this.stay();
  }

  /** Nobody else is to come. */
  private stay(): void {
    this.coming = null;
    this.context.signals.tell("coming");
  }

  /** Asks for files and opens them. */
  async pick(kind: FileKind = "any"): Promise<void> {
    const files = await this.ports.files.pick(kind);
    if (files.length > 0) await this.files(files, kind);
  }

  /** Whatever was dropped or chosen: a project, or a model, or motions, or both. */
  async files(files: readonly PickedFile[], kind: FileKind = "any"): Promise<void> {
    const names = files.map((file) => file.name);
    const title = names.length === 1 ? `Opening ${names[0]}` : `Opening ${names.length} files`;
    await this.guarded(names.join(", "), async () => {
      const sorted = await this.openers.jobs.run(title, STEPS, async (job) => {
        const named = await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
        job.signal.throwIfAborted();
        job.step(1);
        const { sortFiles } = await import("../io/sort-files");
        const { skeletons } = this.openers.sources;
        const sorted = await sortFiles(named, { skeletons, motionsOnly: kind === "motion" });
        const gesture = Symbol("open");
        if (sorted.project) await this.project(named, job, gesture);
        else {
          const opened = await this.model(sorted, job, gesture);
          await this.motions(sorted.motions, job, gesture);
          if (opened) await this.guess(opened, job);
        }
        const nothing = !sorted.project && [sorted.models, sorted.motions, sorted.clips].every(({ length }) => length === 0);
        for (const problem of sorted.problems) this.refuse(problem, nothing);
        return sorted;
      });
      for (const file of sorted.project ? [] : sorted.clips) await this.clips([file, ...sorted.files]);
    });
  }

  /** Motions of the first of `files`, which may be a model too. */
  private async clips(files: readonly NamedFile[]): Promise<void> {
    const { context, openers, ports } = this;
    const { ClipFiles } = await import("./clip-files");
    this.clipFiles ??= new ClipFiles(context.signals, openers.jobs, ports.readClips);
    const { clipFiles } = this;
    await this.guarded(baseName(files[0].name), async () => {
      const motions = (await clipFiles.of(files)).map(({ motion }) => motion);
      if (motions.length > 0) await openers.jobs.run(motions[0].input.name, STEPS, (job) => this.motions(motions, job, Symbol("open")));
    });
  }

  private async project(dropped: readonly NamedFile[], job: JobHandle, gesture: Gesture): Promise<void> {
    const { openProject } = await import("../io/project-file");
    const opened = await openProject(dropped);
    const { sources } = this.openers;
    const model = await this.ports.readModel(opened.modelFiles, reading(job));
    job.step(2);
    const files = sources.addMotion(opened.document.motion.files, opened.motion);
    const file = sources.addModel(opened.document.mesh.file, model, opened.modelFiles);
    const taken = await this.change({ ...opened.document, mesh: { ...opened.document.mesh, file }, motion: { files } }, job, gesture);
    const { history, selection } = this.context;
    history.markSaved();
    selection.endIntro();
    selection.setPanel(null);
    const pairing = taken.motion ? pairingText(pairingNotes(history.document, taken.motion), taken.motion) : [];
    this.say({ title: `${opened.document.name} is open.`, text: [...model.notes, ...pairing].join(" "), actions: [history.undoAction()] });
  }

  /** Answers the model if it was opened. */
  private async model(sorted: SortedFiles, job: JobHandle, gesture: Gesture): Promise<Model | null> {
    const [first, ...others] = sorted.models;
    if (!first) return null;
    const { history, selection } = this.context;
    const { sources, guesses } = this.openers;
    let opened: Model | null = null;
    await this.guarded(baseName(first.name), async () => {
      const beside = sorted.files.filter((file) => !sorted.models.includes(file) && !sorted.clips.includes(file));
      const model = await this.ports.readModel([first, ...beside], reading(job));
      job.step(2);
      const file = sources.addModel(first.name, model, [first, ...beside]);
      const guess = await guesses.of(model);
      const mesh: MeshRef = { file, ...(guess?.mesh ?? { facing: "+z", up: "+y" }), solve: "solid" };
      const named = commands.renameProject(baseName(file).replace(/\.[^.]+$/, ""));
      const { report } = await this.change(named(commands.setMesh(mesh)(history.document)), job, gesture);
      selection.endIntro();
      opened = model;
      this.say({ ...modelText(model, mesh, report), icon: "scale", actions: [history.undoAction()] });
      if (sorted.moves) {
        const run = (): void => void this.clips([first, ...beside]);
        this.say({ title: `${model.name} brings motions of its own.`, icon: "motion", actions: [{ label: "Choose", run }] });
      }
    });
    for (const other of others) this.say({ title: `${baseName(other.name)} was not opened.`, text: "One model at a time." });
    return opened;
  }

  /** Makes a model that just came dance at once, as a step of its own; where that cannot be, the person makes the points. */
  private async guess(model: Model, job: JobHandle): Promise<void> {
    const { history, selection } = this.context;
    const guess = await this.openers.guesses.of(model);
    const { document } = history;
    try {
      if (!guess || guess.points.length === 0) throw new EngineError("bad_controls", "");
      await this.change(commands.addPoints(guess.points, guess.roles)(document), job);
      selection.setPanel(null);
      this.say({ ...guessText(guess.points), icon: "points", actions: [history.undoAction()] });
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (isAbort(error)) return;
      selection.setPanel("points");
      this.say({
        title: "We found no places to hold it by.",
        text: "Click a place on the model, then the joint that moves it.",
        icon: "points",
      });
    }
  }

  private async motions(motions: readonly FoundMotion[], job: JobHandle, gesture: Gesture): Promise<void> {
    const { history, selection } = this.context;
    for (const [k, motion] of motions.entries()) {
      await this.guarded(motion.input.name, async () => {
        job.step(2);
        const files = this.openers.sources.addMotion(motion.files, motion.input);
        if (k > 0) return;
        const taken = await this.change(commands.setMotion({ files })(history.document), job, gesture);
        selection.endIntro();
        const notes = taken.motion ? pairingNotes(history.document, taken.motion) : [];
        this.say({ ...motionText(motion.input.name, taken.motion, notes), icon: "motion", actions: [history.undoAction()] });
      });
    }
    if (motions.length > 1)
      this.say({
        title: `${motions.length} motions came in.`,
        text: "The first one plays; the others are in the list.",
        actions: [{ label: "Show", run: () => selection.setPanel("motion") }],
      });
  }

  /** One step to another document, if the engine can take it. */
  private async change(next: ProjectDocument, job?: JobHandle, gesture?: Gesture): Promise<Taken> {
    const { workspace, history } = this.context;
    const taken = await workspace.tryOn(next, job?.signal, (done) => job?.progress(done));
    history.apply(() => next, gesture);
    return taken;
  }

  /** Says what went wrong in the words of whoever found it; answers whether nothing did. */
  private async guarded(what: string, work: () => Promise<void>): Promise<boolean> {
    try {
      await work();
      return true;
    } catch (error) {
      if (isAbort(error)) return false;
      const message = error instanceof Error ? error.message : String(error);
      const named = what.split(", ").some((name) => message.includes(baseName(name)));
      this.refuse(named ? message : `${what}: ${message}`, true);
      return false;
    }
  }

  /** The first sentence says what is wrong, the others what it may be. */
  private refuse(message: string, untouched: boolean): void {
    const [, title, rest] = /^(.*?[.:]) ([A-Z].*)$/s.exec(message) ?? [null, message, ""];
    this.say({ bad: untouched, title: title ?? message, text: [rest, untouched ? this.untouched() : ""].filter(Boolean).join(" ") });
  }

  private say(notice: NoticeInput): void {
    this.context.notices.say(notice);
  }

  private untouched(): string {
    const { cast } = this.openers;
    return cast.present ? `Your ${cast.presentName.toLowerCase()} is untouched.` : "Nothing is shown yet.";
  }
}

function reading({ signal, progress }: JobHandle): { signal: AbortSignal; onProgress: (done: number) => void } {
  return { signal, onProgress: progress };
}
