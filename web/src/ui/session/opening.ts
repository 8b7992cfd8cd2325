import * as commands from "../../document/commands";
import type { ProjectDocument } from "../../document/types";
import { EngineError } from "../../engine/types";
import type { MotionInput } from "../../engine/types";
import type { Model } from "../../io/model";
import { readModel } from "../../io/read-model";
import { figure } from "../words";
import type { JobHandle } from "./jobs";
import type { MotionEntry, Session } from "./session";

/** From files to the document. What cannot be opened leaves everything as it was and says so. */
export class Opening {
  constructor(private readonly session: Session) {}

  /** The cactus and its dance, as one step. */
  builtin({ first }: { first: boolean }): Promise<void> {
    return this.guarded("The cactus", async () => {
      const { builtins } = this.session;
      const motionFile = builtins.motions[0] ?? "";
      const [document, bytes, text] = await Promise.all([builtins.project(), builtins.modelBytes(), builtins.motionText(motionFile)]);
      const model = await readModel([{ name: builtins.model.file, bytes }]);
      this.keepMotion(document.motion.files, { format: "bvh", name: motionFile, text });
      const next = await this.withModel(document, model);
      if (first) this.session.store.replace(next);
      else this.session.apply(() => next);
      this.session.markSaved();
    });
  }

  async useMotion(entry: MotionEntry): Promise<void> {
    await this.guarded(entry.files.at(-1) ?? "This motion", async () => {
      const { session } = this;
      const file = entry.files.at(-1) ?? "";
      if (entry.builtin && !session.workspace.library.motion(entry.files)) {
        this.keepMotion(entry.files, { format: "bvh", name: file, text: await session.builtins.motionText(file) });
      }
      await this.change(commands.setMotion({ files: entry.files })(session.document));
    });
  }

  async files(files: readonly File[]): Promise<void> {
    console.log(files.length);
  }

  private keepMotion(files: readonly string[], input: MotionInput): readonly string[] {
    return this.session.workspace.library.addMotion(files, input);
  }

  /** Keeps a model and names it in the document. */
  private async withModel(document: ProjectDocument, model: Model): Promise<ProjectDocument> {
    const { session } = this;
    const { texture } = model.drawn;
    if (texture && !session.textures.has(model)) {
      const blob = new Blob([texture.bytes.slice()], { type: texture.mime });
      session.textures.set(model, await createImageBitmap(blob, { premultiplyAlpha: "none", colorSpaceConversion: "none" }));
    }
    const file = session.workspace.library.addModel(document.mesh.file, model);
    return { ...document, mesh: { ...document.mesh, file } };
  }

  /** One step to another document, if the engine can take it. */
  private async change(next: ProjectDocument, job?: JobHandle): Promise<void> {
    const { session } = this;
    await session.workspace.tryOn(next, job?.signal, (done) => job?.progress(done));
    session.apply(() => next);
  }

  /** Says what went wrong in the words of whoever found it. */
  private async guarded(what: string, work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      if (error instanceof EngineError && error.code === "cancelled") return;
      const message = error instanceof Error ? error.message : String(error);
      this.session.notices.say({ bad: true, title: message.includes(what) ? message : `${what}: ${message}`, text: this.untouched() });
    }
  }

  private untouched(): string {
    return this.session.document.mesh.file === "" ? "Nothing is shown yet." : `Your ${this.session.modelName.toLowerCase()} is untouched.`;
  }
}
void figure;
