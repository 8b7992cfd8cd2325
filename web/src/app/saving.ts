import { errorText } from "./error-words";
import type { Context } from "./context";
import type { Exporting, ExportHelpers } from "./exporting";
import type { Ports } from "./ports";

/** From the document to files: the project, and what is taken along. */
export class Saving {
  /** Once something was to be exported. */
  exporting: Exporting | null = null;

  constructor(
    private readonly context: Context,
    private readonly helpers: ExportHelpers,
    private readonly ports: Pick<Ports, "files" | "buildSkin" | "buildMorphs">,
  ) {}

  async save(): Promise<void> {
    const { document, model, history, notices } = this.context;
    if (!model) return;
    try {
      const { projectFileName, saveProject } = await import("../io/project-file");
      const zip = saveProject(document, this.helpers.sources.filesOf(model, document.motion.files));
      this.ports.files.download(projectFileName(document), zip.slice(), "application/zip");
      history.markSaved();
    } catch (error) {
      notices.say({ bad: true, title: "The project could not be saved.", text: errorText(error) });
    }
  }

  /** Shows what an animated model would be like, and makes it. */
  async openExport(): Promise<void> {
    const { Exporting } = await import("./exporting");
    this.exporting ??= new Exporting(this.context, this.helpers, this.ports);
    this.exporting.show();
  }
}
