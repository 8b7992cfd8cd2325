import * as commands from "../document/commands";
import type { Gesture } from "../document/store";
import type { MeshRef, ProjectDocument } from "../document/types";
import { EngineError } from "../engine/types";
import type { Model } from "../io/model";
import { baseName } from "../io/named-file";
import type { NamedFile } from "../io/named-file";
import { readModelInWorker } from "../io/read-model-in-worker";
import type { FoundMotion } from "../io/read-motion-files";
import type { SortedFiles } from "../io/sort-files";
import { pairingNotes } from "../sync/pairing";
import type { Taken } from "../sync/workspace";
import type { Character } from "./builtins";
import type { Performer } from "./cast";
import { guessText, modelText, motionText, pairingText } from "./file-words";
import type { JobHandle } from "./jobs";
import type { NoticeInput } from "./notices";
import type { MotionEntry } from "./motions";
import type { Session } from "./session";
import type { Sources } from "./sources";

/** From files to the document. What cannot be opened leaves everything as it was and says so. */
export class Opening {
  /** The file of the performer or motion that was chosen and is not there yet. */
  coming: string | null = null;

  constructor(
    private readonly session: Session,
    private readonly sources: Sources,
  ) {}

  /** The cactus and its dance, to begin with; false if that failed. */
  async first(): Promise<boolean> {
    const { session } = this;
    const [character] = session.builtins.characters;
    return this.guarded(character.name, async () => {
      const file = session.builtins.motions[0]?.file ?? "";
      const [document, text] = await Promise.all([this.character(character), session.builtins.motionText(file)]);
      const files = this.sources.keepMotion([file], { format: "bvh", name: file, text });
      session.store.replace({ ...document, motion: { files } });
      session.markSaved();
    });
  }

  /** Someone else takes over the dance, with the points and poses they came with or left with. One step. */
  async usePerformer(performer: Performer): Promise<void> {
    const { session } = this;
    const { file, name, character } = performer;
    if (session.cast.isOnStage(performer)) return this.stay();
    await this.inTurn(file, name, async (job, isNewest) => {
      const { cast } = session;
      const own = cast.remembered(file) ?? (character && (await this.character(character)));
      if (!own || !isNewest()) return;
      job.step(1);
      const { saved } = session;
      const {
        motion,
        settings: { inPlace },
      } = session.document;
      await this.change({ ...own, motion, settings: { ...own.settings, inPlace } }, job);
      if (saved) session.markSaved();
    });
  }

  async useMotion(entry: MotionEntry): Promise<void> {
    const { session } = this;
    const { files, builtin, name } = entry;
    if (session.motions.isPlaying(entry)) return this.stay();
    const file = files.at(-1) ?? "";
    await this.inTurn(file, name, async (job, isNewest) => {
      if (builtin && !session.workspace.library.motion(files)) {
        this.sources.keepMotion(files, { format: "bvh", name: file, text: await session.builtins.motionText(file) });
      }
      if (!isNewest()) return;
      job.step(1);
      await this.change(commands.setMotion({ files })(session.document), job);
    });
  }

  /** The project of a character of ours, its model kept. */
  private async character(character: Character): Promise<ProjectDocument> {
    const { document, bytes } = await this.session.builtins.load(character);
    const files = [{ name: document.mesh.file, bytes }];
    const file = await this.sources.keepModel(document.mesh.file, await readModelInWorker(files), files);
    return { ...document, mesh: { ...document.mesh, file } };
  }

  /** Of several choices the newest wins, whichever is ready first. */
  private async inTurn(file: string, name: string, work: (job: JobHandle, isNewest: () => boolean) => Promise<void>): Promise<void> {
    const { session } = this;
    this.coming = file;
    const isNewest = (): boolean => this.coming === file;
    session.emit("coming", undefined);
    await this.guarded(file, () => session.jobs.run(name, ["Load", "Bind"], (job) => work(job, isNewest)));
    if (isNewest()) this.stay();
  }

  /** Nobody else is to come. */
  private stay(): void {
    this.coming = null;
    this.session.emit("coming", undefined);
  }

  /** Whatever was dropped or chosen: a project, or a model, or motions, or both. */
  async files(files: readonly File[]): Promise<void> {
    const names = files.map((file) => file.name);
    const title = names.length === 1 ? `Opening ${names[0]}` : `Opening ${names.length} files`;
    await this.guarded(names.join(", "), () =>
      this.session.jobs.run(title, ["Read", "Understand", "Bind"], async (job) => {
        const named = await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
        job.signal.throwIfAborted();
        job.step(1);
        const { sortFiles } = await import("../io/sort-files");
        const sorted = sortFiles(named);
        const gesture = Symbol("open");
        if (sorted.project) await this.project(named, job, gesture);
        else {
          const opened = await this.model(sorted, job, gesture);
          await this.motions(sorted.motions, job, gesture);
          if (opened) await this.guess(opened, job);
        }
        const nothing = !sorted.project && sorted.models.length === 0 && sorted.motions.length === 0;
        for (const problem of sorted.problems) this.refuse(problem, nothing);
      }),
    );
  }

  private async project(dropped: readonly NamedFile[], job: JobHandle, gesture: Gesture): Promise<void> {
    const { openProject } = await import("../io/project-file");
    const opened = openProject(dropped);
    const model = await readModelInWorker(opened.modelFiles, { signal: job.signal });
    job.step(2);
    const files = this.sources.keepMotion(opened.document.motion.files, opened.motion);
    const file = await this.sources.keepModel(opened.document.mesh.file, model, opened.modelFiles);
    const taken = await this.change({ ...opened.document, mesh: { ...opened.document.mesh, file }, motion: { files } }, job, gesture);
    const { session } = this;
    session.markSaved();
    session.endIntro();
    session.setPanel(null);
    const pairing = taken.motion ? pairingText(pairingNotes(session.document, taken.motion), taken.motion) : [];
    this.say({ title: `${opened.document.name} is open.`, text: [...model.notes, ...pairing].join(" "), actions: [session.undoAction()] });
  }

  /** Answers the model if it was opened. */
  private async model(sorted: SortedFiles, job: JobHandle, gesture: Gesture): Promise<Model | null> {
    const [first, ...others] = sorted.models;
    if (!first) return null;
    const { session } = this;
    let opened: Model | null = null;
    await this.guarded(baseName(first.name), async () => {
      const beside = sorted.files.filter((file) => !sorted.models.includes(file));
      const model = await readModelInWorker([first, ...beside], { signal: job.signal });
      job.step(2);
      const file = await this.sources.keepModel(first.name, model, [first, ...beside]);
      const guess = await session.guesses.of(model);
      const mesh: MeshRef = { file, ...(guess?.mesh ?? { facing: "+z", up: "+y" }) };
      const named = commands.renameProject(baseName(file).replace(/\.[^.]+$/, ""));
      const { report } = await this.change(named(commands.setMesh(mesh)(session.document)), job, gesture);
      session.endIntro();
      opened = model;
      this.say({ ...modelText(model, mesh, report), icon: "scale", actions: [session.undoAction()] });
    });
    for (const other of others) this.say({ title: `${baseName(other.name)} was not opened.`, text: "One model at a time." });
    return opened;
  }

  /** Makes a model that just came dance at once, as a step of its own; where that cannot be, the person makes the points. */
  private async guess(model: Model, job: JobHandle): Promise<void> {
    const { session } = this;
    const guess = await session.guesses.of(model);
    const { document } = session;
    try {
      if (!guess || guess.points.length === 0) throw new EngineError("bad_controls", "");
      await this.change(commands.addPoints(guess.points, guess.roles)(document), job);
      session.setPanel(null);
      this.say({ ...guessText(guess.points), icon: "points", actions: [session.undoAction()] });
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      if (error.code === "cancelled") return;
      session.setPanel("points");
      this.say({
        title: "We found no places to hold it by.",
        text: "Click a place on the model, then the joint that moves it.",
        icon: "points",
      });
    }
  }

  private async motions(motions: readonly FoundMotion[], job: JobHandle, gesture: Gesture): Promise<void> {
    const { session } = this;
    for (const [k, motion] of motions.entries()) {
      await this.guarded(motion.input.name, async () => {
        job.step(2);
        const files = this.sources.keepMotion(motion.files, motion.input);
        if (k > 0) return;
        const taken = await this.change(commands.setMotion({ files })(session.document), job, gesture);
        session.endIntro();
        const notes = taken.motion ? pairingNotes(session.document, taken.motion) : [];
        this.say({ ...motionText(motion.input.name, taken.motion, notes), icon: "motion", actions: [session.undoAction()] });
      });
    }
    if (motions.length > 1)
      this.say({
        title: `${motions.length} motions came in.`,
        text: "The first one plays; the others are in the list.",
        actions: [{ label: "Show", run: () => session.setPanel("motion") }],
      });
  }

  /** One step to another document, if the engine can take it. */
  private async change(next: ProjectDocument, job?: JobHandle, gesture?: Gesture): Promise<Taken> {
    const { session } = this;
    const taken = await session.workspace.tryOn(next, job?.signal, (done) => job?.progress(done));
    session.apply(() => next, gesture);
    return taken;
  }

  /** Says what went wrong in the words of whoever found it; answers whether nothing did. */
  private async guarded(what: string, work: () => Promise<void>): Promise<boolean> {
    try {
      await work();
      return true;
    } catch (error) {
      if (error instanceof EngineError && error.code === "cancelled") return false;
      if (error instanceof DOMException && error.name === "AbortError") return false;
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
    this.session.notices.say(notice);
  }

  private untouched(): string {
    return this.session.document.mesh.file === "" ? "Nothing is shown yet." : `Your ${this.session.modelName.toLowerCase()} is untouched.`;
  }
}
