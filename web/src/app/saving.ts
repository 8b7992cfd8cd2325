import { bytes, figure } from "../util/words";
import { isAbort } from "./aborts";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { Jobs } from "./jobs";
import type { Ports } from "./ports";
import type { Sources } from "./sources";

/** From the document to files: the project and the animated model. */
export class Saving {
  constructor(
    private readonly context: Context,
    private readonly jobs: Jobs,
    private readonly sources: Sources,
    private readonly ports: Pick<Ports, "files" | "buildSkin">,
  ) {}

  async save(): Promise<void> {
    const { document, model, history } = this.context;
    if (!model) return;
    try {
      const { projectFileName, saveProject } = await import("../io/project-file");
      const zip = saveProject(document, this.sources.filesOf(model, document.motion.files));
      this.ports.files.download(projectFileName(document), zip.slice(), "application/zip");
      history.markSaved();
    } catch (error) {
      this.refuse("The project could not be saved.", error);
    }
  }

  /** An animated GLB of the whole dance. */
  async exportModel(): Promise<void> {
    const { model: present, performance, document, notices } = this.context;
    const model = present && this.sources.of(present)?.model;
    if (!model || !performance) return;
    const { name, mesh, points } = document;
    const steps = [`Play through ${figure(performance.frames)} frames`, "Write the file"];
    try {
      await this.jobs.run(`Exporting ${name}`, steps, async (job) => {
        const frames = await this.context.workspace.vertexFrames({ signal: job.signal, onProgress: job.progress });
        job.step(1);
        const { everyFor, exportDance, sayLikeness } = await import("../io/export-dance");
        const tools = { buildSkin: this.ports.buildSkin, signal: job.signal, onProgress: job.progress };
        const dance = { name, model, mesh, points, clips: [{ name, frames }] };
        const { bytes: glb, likeness } = await exportDance(dance, everyFor([frames.length]), tools);
        job.signal.throwIfAborted();
        this.ports.files.download(`${name}.glb`, glb.slice(), "model/gltf-binary");
        notices.say({
          title: `${name}.glb is ${bytes(glb.length)}.`,
          text: `It opens in Blender, Unity, Godot and on the web.${likeness ? ` ${sayLikeness(likeness)}.` : ""}`,
          icon: "save",
        });
      });
    } catch (error) {
      if (!isAbort(error)) this.refuse(`${name} could not be exported.`, error);
    }
  }

  private refuse(title: string, error: unknown): void {
    this.context.notices.say({ bad: true, title, text: errorText(error) });
  }
}
