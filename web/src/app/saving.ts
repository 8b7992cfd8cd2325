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
    await (await import("./project-saving")).saveProject(this.context, this.helpers, this.ports.files);
  }

  /** Shows what an animated model would be like, and makes it. */
  async openExport(): Promise<void> {
    const { Exporting } = await import("./exporting");
    this.exporting ??= new Exporting(this.context, this.helpers, this.ports);
    this.exporting.show();
  }
}
