import * as commands from "../document/commands";
import type { ProjectDocument } from "../document/types";
import type { Performer } from "./cast";
import type { ClipFiles } from "./clip-files";
import type { Context } from "./context";
import type { FileOpening } from "./file-opening";
import type { JobHandle } from "./jobs";
import type { MotionEntry } from "./motions";
import type { Character, FileKind, PickedFile, Ports } from "./ports";
import { type Openers, OpeningSteps } from "./opening-steps";

/** Who is on the stage and what they dance to. What cannot be opened leaves everything as it was and says so. */
export class Opening {
  /** The file of the performer or motion that was chosen and is not there yet. */
  coming: string | null = null;
  /** Once files came. */
  private fromFiles: FileOpening | null = null;
  private readonly steps: OpeningSteps;

  constructor(
    private readonly context: Context,
    private readonly openers: Openers,
    private readonly ports: Pick<Ports, "readModel" | "readClips" | "files">,
  ) {
    this.steps = new OpeningSteps(context, openers.cast);
  }

  /** The cactus and its dance, to begin with; false if that failed. */
  async first(): Promise<boolean> {
    const { history } = this.context;
    const { builtins, sources } = this.openers;
    const [character] = builtins.characters;
    return this.steps.guarded(character.name, async () => {
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
      await this.steps.change(
        ({ motion, companion, settings: { inPlace } }) => ({ ...own, motion, companion, settings: { ...own.settings, inPlace } }),
        job,
      );
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
      await this.steps.change(commands.setMotion({ files }), job);
    });
  }

  /** The project of a character of ours, its model kept. */
  async character(character: Character): Promise<ProjectDocument> {
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
    await this.steps.guarded(file, () => this.openers.jobs.run(name, ["Load", "Bind"], (job) => work(job, isNewest)));
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
    await this.steps.guarded(files.map((file) => file.name).join(", "), async () => {
      const { FileOpening } = await import("./file-opening");
      this.fromFiles ??= new FileOpening(this.context, this.openers, this.ports, this.steps);
      await this.fromFiles.open(files, kind);
    });
  }

  /** Once a file came that may hold several motions. */
  get clipFiles(): ClipFiles | null {
    return this.fromFiles?.clipFiles ?? null;
  }
}
