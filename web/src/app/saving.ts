import { stageFor } from "../sync/prepare";
import type { Model } from "../io/model";
import { toStage } from "../document/stage";
import { bytes, figure } from "../util/words";
import { download } from "../ui/pick-files";
import type { Session } from "./session";
import type { Sources } from "./sources";

/** More targets than this and some viewers show nothing. */
const MAX_TARGETS = 120;

/** From the document to files: the project and the animated model. */
export class Saving {
  constructor(
    private readonly session: Session,
    private readonly sources: Sources,
  ) {}

  async save(): Promise<void> {
    const { session } = this;
    const { document, model } = session;
    if (!model) return;
    try {
      const { projectFileName, saveProject } = await import("../io/project-file");
      const zip = saveProject(document, this.sources.of(model, document.motion.files));
      download(projectFileName(document), zip.slice(), "application/zip");
      session.markSaved();
    } catch (error) {
      session.notices.say({
        bad: true,
        title: "The project could not be saved.",
        text: error instanceof Error ? error.message : String(error),
      });
    }
  }

  /** An animated GLB of the whole dance. */
  async exportModel(): Promise<void> {
    const { session } = this;
    const model = session.model as Model | undefined;
    if (!model || !session.performance) return;
    const { name, mesh } = session.document;
    try {
      await session.jobs.run(
        `Exporting ${name}`,
        [`Play through ${figure(session.performance.frames)} frames`, "Write the file"],
        async (job) => {
          const frames = await this.allFrames(job.signal, job.progress);
          job.step(1);
          const { writeGlb } = await import("../io/write-glb");
          const stage = stageFor(model, mesh);
          const every = Math.ceil(frames.length / MAX_TARGETS);
          const glb = await writeGlb({
            name,
            drawn: model.drawn,
            faces: model.faces,
            rest: toStage(stage, model.positions),
            frames,
            scale: 1 / stage.scale,
            every,
          });
          job.signal.throwIfAborted();
          download(`${name}.glb`, glb.slice(), "model/gltf-binary");
          const kept = every > 1 ? ` Every ${figure(every)} frames are one shape, so that all viewers can take it.` : "";
          session.notices.say({
            title: `${name}.glb is ${bytes(glb.length)}.`,
            text: `It opens in Blender, Unity, Godot and on the web.${kept}`,
            icon: "save",
          });
        },
      );
    } catch (error) {
      if (error instanceof DOMException && error.name === "AbortError") return;
      session.notices.say({
        bad: true,
        title: `${name} could not be exported.`,
        text: error instanceof Error ? error.message : String(error),
      });
    }
  }

  /** Waits until every frame of the present dance is there. */
  private async allFrames(signal: AbortSignal, progress: (done: number) => void): Promise<{ positions: Float32Array }[]> {
    const { workspace } = this.session;
    const stop = workspace.on("frame", () => progress(1 - workspace.cache.staleCount / workspace.cache.length));
    try {
      while (workspace.cache.staleCount > 0) {
        await workspace.sync();
        signal.throwIfAborted();
      }
    } finally {
      stop();
    }
    return Array.from({ length: workspace.cache.length }, (_, f) => workspace.cache.at(f)).filter((frame) => frame !== undefined);
  }
}
