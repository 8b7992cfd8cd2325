// Nothing is lost: the browser keeps the project after each step, with everything that was done in it, and a page that is opened
// again goes on where it was.

import { companionDocument } from "../document/duet";
import { parseProject, serializeProject, VERSION } from "../document/project";
import type { ProjectDocument } from "../document/types";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Cast } from "./cast";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { JobHandle, Jobs } from "./jobs";
import type { KeptProject, KeptSong, KeptWork, Ports, ShelfPort } from "./ports";
import type { Song } from "./song";
import type { Sources } from "./sources";
import type { Thumbnails } from "./thumbnails";

/** A step is finished when nothing has followed it for so long. */
const PAUSE_MS = 250;
/** Of more steps than these the oldest are let go. */
const MOST_STEPS = 200;

export interface Keepers {
  readonly builtins: Builtins;
  readonly cast: Cast;
  readonly jobs: Jobs;
  readonly sources: Sources;
  readonly thumbnails: Thumbnails;
  readonly song: Song | null;
  music(): Promise<Song>;
  readonly opening: { first(): Promise<boolean> };
  readonly saving: { save(): Promise<void> };
}

export class Keeping {
  /** What is kept, newest first; as of the last `refresh`. */
  list: readonly KeptProject[] = [];
  private id: string | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private writing: Promise<void> = Promise.resolve();
  private refused = false;
  private keptSong: KeptSong | null = null;
  private readonly shelf: Promise<ShelfPort>;

  constructor(
    private readonly context: Context,
    private readonly keepers: Keepers,
    private readonly ports: Pick<Ports, "memory" | "openShelf" | "readModel">,
  ) {
    this.shelf = ports.openShelf();
    this.shelf.catch(() => undefined); // whoever needs it hears of it
    context.signals.on("document", () => this.later());
  }

  /** The project on the stage; null before anything of it is kept. */
  get present(): string | null {
    return this.id;
  }

  /** Opens what this page worked on, or else the newest that no other page has. False if there is none that can be opened. */
  async resume(): Promise<boolean> {
    const { memory } = this.ports;
    try {
      await this.refresh();
    } catch {
      return false; // nothing can be read: the first thing to keep will say so
    }
    const wanted = this.list.find(({ id }) => id === memory.project) ?? this.list[0];
    if (!wanted) return false;
    if (memory.opening === wanted.id) {
      memory.opening = null;
      this.say(`${wanted.name} did not open last time.`, "It is still kept.", { label: "Open it", run: () => void this.open(wanted.id) });
      return false;
    }
    return this.open(wanted.id);
  }

  /** Opens what is kept; what another page has open is opened as a copy. False, and said, if it cannot be. */
  async open(id: string): Promise<boolean> {
    const { memory } = this.ports;
    await this.flush();
    memory.opening = id;
    try {
      const shelf = await this.shelf;
      const work = await shelf.load(id);
      if (!work) throw new Error("It is not kept any more.");
      await this.keepers.jobs.run(`Opening ${work.name}`, ["Read"], (job) => this.restore(work, job));
      const own = await shelf.claim(id);
      this.become(own ? id : null);
      this.context.selection.endIntro();
      const fresh = { label: "Start fresh", run: () => void this.startFresh() };
      if (own) this.say(`${work.name} is as you left it.`, "", fresh);
      else this.say(`This is a copy of ${work.name}.`, "Another tab has the project itself open.", fresh);
      return true;
    } catch (error) {
      if (isAbort(error)) return false;
      const why = errorText(error);
      this.context.notices.say({ bad: true, title: "A kept project could not be opened.", text: why });
      return false;
    } finally {
      memory.opening = null;
    }
  }

  /** As on the first visit; what was there stays on the shelf. */
  async startFresh(): Promise<void> {
    const { history, notices } = this.context;
    await this.flush();
    const { name } = history.document;
    const before = this.id;
    if (!(await this.keepers.opening.first())) return;
    history.touched = false;
    this.keepers.cast.restore([]);
    await this.restoreSong(null);
    (await this.shelf).release();
    this.become(null);
    if (before)
      notices.say({ title: `${name} is kept.`, icon: "save", actions: [{ label: "Go back", run: () => void this.open(before) }] });
  }

  /** Lets go of what is kept and not on the stage. */
  async remove(id: string): Promise<void> {
    const shelf = await this.shelf;
    const work = await shelf.load(id);
    await shelf.remove(id);
    await this.refresh();
    if (!work) return;
    const back = async (): Promise<void> => {
      await shelf.put(work);
      await this.refresh();
    };
    this.context.notices.say({ title: `${work.name} is no longer kept.`, actions: [{ label: "Undo", run: () => void back() }] });
  }

  /** A project that is kept, with its model and motions at hand; it is not opened. Errors: it is not kept any more, or cannot be read. */
  async borrow(id: string, { signal, progress }: JobHandle): Promise<{ document: ProjectDocument; files: readonly string[] }> {
    const { sources } = this.keepers;
    const work = await (await this.shelf).load(id);
    if (!work) throw new Error("It is not kept any more.");
    const document = this.read(work.steps.present, work.name);
    const named = new Map(work.motions.map(({ files, input }) => [files.join("\n"), sources.addMotion(files, input)]));
    const files = work.models.find(([own]) => own?.name === document.mesh.file);
    if (!files) throw new Error("Its model is gone.");
    const model = await this.ports.readModel(files, { signal, onProgress: progress });
    const own = { ...document, mesh: { ...document.mesh, file: sources.addModel(document.mesh.file, model, files) } };
    const { motion } = document;
    return { document: own, files: named.get(motion.files.join("\n")) ?? motion.files };
  }

  async refresh(): Promise<void> {
    this.list = await (await this.shelf).list();
    this.context.signals.tell("kept");
  }

  /** Keeps what is there, at once. */
  flush(): Promise<void> {
    clearTimeout(this.timer);
    const { history } = this.context;
    const unkept = (history.touched && history.unkept) || this.song !== this.keptSong;
    if (unkept) this.writing = this.writing.then(() => this.write());
    return this.writing;
  }

  /** Keeps what is there, once the hand rests. */
  later(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.flush(), PAUSE_MS);
  }

  private async write(): Promise<void> {
    try {
      const shelf = await this.shelf;
      if (this.id === null) this.become(await shelf.begin());
      const work = this.work(this.id ?? "");
      await shelf.put(work);
      this.keptSong = work.song ?? null;
      this.context.history.markKept(work.steps.present);
      this.ports.memory.kept = true;
      this.refused = false;
      await this.refresh();
    } catch (error) {
      if (!this.refused) this.refuse(error);
      this.refused = true; // once is enough
    }
  }

  private work(id: string): KeptWork {
    const { builtins, cast, sources, thumbnails } = this.keepers;
    const { library } = this.context.workspace;
    const { past, present, future } = this.context.history.steps;
    const steps = { past: past.slice(-MOST_STEPS), present, future: future.slice(-MOST_STEPS) };
    const away = cast.away;
    const documents = [...steps.past, present, ...steps.future, ...away];
    const dancers = documents.flatMap((document) => [document, companionDocument(document) ?? []].flat());
    const models = [...new Set(dancers.map(({ mesh }) => mesh.file))].flatMap((file) => {
      const model = library.model(file);
      const source = model && sources.of(model);
      return source ? [source.files] : [];
    });
    const ours = new Set(builtins.motions.map(({ file }) => file));
    const played = new Set(dancers.map(({ motion }) => motion.files.join("\n")));
    const motions = library.motionFiles.flatMap((files) => {
      const input = library.motion(files);
      const needed = played.has(files.join("\n")) || !ours.has(files.at(-1) ?? "");
      return input && needed ? [{ files, input }] : [];
    });
    const picture = thumbnails.rest ?? "";
    return { id, name: present.name, changed: Date.now(), picture, version: VERSION, steps, away, models, motions, song: this.song };
  }

  private get song(): KeptSong | null {
    return this.keepers.song?.kept ?? null;
  }

  private async restoreSong(song: KeptSong | null): Promise<void> {
    this.keptSong = song;
    if (song || this.song) await (await this.keepers.music()).put(song);
  }

  private async restore(work: KeptWork, { signal, progress }: JobHandle): Promise<void> {
    const { cast, sources } = this.keepers;
    for (const { files, input } of work.motions) sources.addMotion(files, input);
    for (const files of work.models) {
      const [own] = files;
      if (own) sources.addModel(own.name, await this.ports.readModel(files, { signal, onProgress: progress }), files);
    }
    const current = work.version <= VERSION; // documents of version 1 are documents of this one
    const present = this.read(work.steps.present, work.name);
    this.context.history.restore(current ? { ...work.steps, present } : { past: [], present, future: [] });
    cast.restore(current ? work.away : work.away.map((document) => this.read(document, work.name)));
    await this.restoreSong(work.song ?? null);
  }

  private read(document: ProjectDocument, name: string): ProjectDocument {
    return parseProject(serializeProject(document), name).document;
  }

  private become(id: string | null): void {
    this.id = id;
    this.ports.memory.project = id;
  }

  private say(title: string, text: string, action: { label: string; run: () => void }): void {
    this.context.notices.say({ title, text, icon: "save", actions: [action] });
  }

  private refuse(error: unknown): void {
    const why = error instanceof Error && error.name === "QuotaExceededError" ? "Its storage is full" : "Its storage is turned off";
    this.context.notices.say({
      bad: true,
      title: "This browser cannot keep your work.",
      text: `${why}, so a reload would lose it. A saved file would not.`,
      actions: [{ label: "Save", run: () => void this.keepers.saving.save() }],
    });
  }
}
