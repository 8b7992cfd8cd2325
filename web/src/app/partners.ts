// Who may come to dance beside the one in hand: a character of ours, a project that the browser keeps, or files.

import * as commands from "../document/commands";
import { clipName } from "../document/clips";
import { withMotionNames } from "../document/renamed-motions";
import { BESIDE, companionOf, setCompanionMotion } from "../document/duet";
import { boundsOf } from "../document/stage-transform";
import type { Companion, MeshRef, ProjectDocument } from "../document/types";
import { DocumentError } from "../document/project";
import { openProject } from "../io/project-file";
import { sortFiles } from "../io/sort-files";
import { meshInput } from "../sync/translate";
import { stem } from "../util/words";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Cast, Performer } from "./cast";
import type { Context } from "./context";
import { errorText } from "./error-words";
import { modelFiles, reading } from "./file-opening";
import type { Guesses } from "./guesses";
import type { JobHandle, Jobs } from "./jobs";
import type { Keeping } from "./keeping";
import type { MotionEntry } from "./motions";
import type { Opening } from "./opening";
import type { PickedFile, Ports } from "./ports";
import type { Sources } from "./sources";

/** Metres between two who stand still. */
const GAP = 0.2;

export interface PartnerHelpers {
  readonly cast: Cast;
  readonly guesses: Guesses;
  readonly jobs: Jobs;
  readonly keeping: Keeping | null;
  readonly opening: Pick<Opening, "character">;
  readonly builtins: Builtins;
  readonly sources: Sources;
}

export class Partners {
  /** Who was chosen and is not there yet: a model's file, or a kept project's id. */
  coming: string | null = null;

  constructor(
    private readonly context: Context,
    private readonly helpers: PartnerHelpers,
    private readonly ports: Pick<Ports, "files" | "readModel">,
    /** They dance beside from now on; rejects where no engine takes them. */
    private readonly bring: (companion: Companion, job: JobHandle) => Promise<void>,
  ) {}

  /** A character of ours, or a model that was opened, as they were left; to the motion of the one in hand. */
  async usePerformer({ file, name, character }: Performer): Promise<void> {
    const { cast, opening } = this.helpers;
    await this.come(file, name, async () => {
      const { document } = this.context;
      const left = document.mesh.file === file ? document : cast.remembered(file);
      const own = left ?? (character && (await opening.character(character)));
      if (!own) throw new Error("It is not here any more.");
      return companionOf(own, this.offsetOf(own), null);
    });
  }

  /** A project that the browser keeps, with its own motion. */
  async useKept(id: string, name: string): Promise<void> {
    const { keeping } = this.helpers;
    if (!keeping) return;
    await this.come(id, name, async (job) => {
      const { document, files } = await keeping.borrow(id, job);
      const own = renamed(document, files);
      return companionOf(own, this.offsetOf(own), own.motion);
    });
  }

  /** Asks for files and takes a project with its motion, or a model that is guessed how to hold. */
  async pick(): Promise<void> {
    const files = await this.ports.files.pick("model");
    const [first] = files;
    if (first) await this.come(first.name, first.name, (job) => this.fromFiles(files, job));
  }

  /** What the companion dances to; null: to the motion of the one in hand. */
  async useMotion(entry: MotionEntry | null): Promise<void> {
    const { builtins, sources } = this.helpers;
    const { history, notices, workspace } = this.context;
    try {
      const name = entry?.files.at(-1) ?? "";
      if (entry?.builtin && !workspace.library.motion(entry.files))
        sources.addMotion(entry.files, { name, text: await builtins.motionText(name) });
      history.apply(setCompanionMotion(entry && { files: entry.files }));
    } catch (error) {
      notices.say({ bad: true, title: `${entry?.name} cannot be danced.`, text: errorText(error) });
    }
  }

  /** Where whoever is there stands; else beside the one in hand, and not in its arms. */
  private offsetOf({ mesh }: ProjectDocument): Companion["offset"] {
    const { document, workspace } = this.context;
    const { companion } = document;
    if (companion) return companion.offset;
    const widths = [document.mesh, mesh].map((one) => {
      const model = workspace.library.model(one.file);
      const { min, max } = boundsOf(model ? meshInput(model, one).positions : []);
      return max[0] - min[0];
    });
    const [x, z] = BESIDE.place;
    const apart = Math.max(1, Math.ceil(20 * ((widths[0] + widths[1]) / 2 + GAP)) / 20 / x);
    const centimetres = (metres: number): number => Math.round(100 * metres) / 100;
    return { ...BESIDE, place: [centimetres(apart * x), centimetres(apart * z)] };
  }

  private async fromFiles(picked: readonly PickedFile[], job: JobHandle): Promise<Companion> {
    const { sources, guesses } = this.helpers;
    const named = await Promise.all(picked.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
    const sorted = await sortFiles(named);
    if (sorted.project) {
      const opened = await openProject(named);
      const { document } = opened;
      const model = await this.ports.readModel(opened.modelFiles, reading(job));
      const file = sources.addModel(document.mesh.file, model, modelFiles(opened.modelFiles));
      const files = sources.addMotion(document.motion.files, opened.motion);
      const own = renamed({ ...document, mesh: { ...document.mesh, file } }, files);
      return companionOf(own, this.offsetOf(own), own.motion);
    }
    const [first] = sorted.models;
    if (!first) throw new DocumentError(sorted.problems[0] ?? "It holds neither a model nor a project.");
    const beside = sorted.files.filter((file) => !sorted.models.includes(file) && !sorted.clips.includes(file));
    const model = await this.ports.readModel([first, ...beside], reading(job));
    const file = sources.addModel(first.name, model, modelFiles([first, ...beside]));
    const guess = await guesses.of(model);
    if (!guess || guess.points.length === 0)
      throw new DocumentError("We found no places to hold it by. Open it as the model, make points, and bring the other one here.");
    const mesh: MeshRef = { file, ...guess.mesh, solve: "solid" };
    const bare = commands.newDocument(stem(file), mesh, this.context.document.motion);
    const own: ProjectDocument = commands.addPoints(guess.points, guess.roles)(bare);
    return companionOf(own, this.offsetOf(own), null);
  }

  /** Of several choices the newest wins. What cannot come says so, and everything is as it was. */
  private async come(key: string, name: string, work: (job: JobHandle) => Promise<Companion>): Promise<void> {
    const { helpers, context } = this;
    this.coming = key;
    context.signals.tell("duet");
    try {
      await helpers.jobs.run(name, ["Load", "Bind"], async (job) => {
        const companion = await work(job);
        if (this.coming !== key) return;
        job.step(1);
        await this.bring(companion, job);
      });
    } catch (error) {
      if (!isAbort(error))
        context.notices.say({ bad: true, title: `${name} cannot dance beside.`, text: `${errorText(error)} Nothing has changed.` });
    } finally {
      if (this.coming === key) this.coming = null;
      context.signals.tell("duet");
    }
  }
}

/** Dances to the same motion by the name that it has here. */
function renamed(own: ProjectDocument, files: readonly string[]): ProjectDocument {
  const motion = { files };
  return { ...withMotionNames(own, new Map([[clipName(own), clipName({ motion })]])), motion };
}
