import type { MotionInput } from "../engine/types";
import type { Model } from "../io/model";
import type { NamedFile } from "../io/named-file";
import { type Library, motionTexts } from "../sync/library";
import type { SolverModel } from "../sync/placement";

/** A model as it was opened. */
export interface Source {
  readonly model: Model;
  /** What it was read from, its own file first. */
  readonly files: readonly NamedFile[];
}

/** What models and motions were read from, so that they can be drawn and a project can be saved with them. */
export class Sources {
  private readonly sources = new WeakMap<SolverModel, Source>();

  constructor(private readonly library: Library) {}

  /**
   * Adds a model to the library under a name of its own, its own file first among `files`; answers the name. The same files
   * opened again are the same model.
   */
  addModel(file: string, model: Model, files: readonly NamedFile[]): string {
    const [own, ...beside] = files;
    const known = this.library.model(file);
    if (known && own && sameFiles(this.of(known)?.files ?? [], [{ ...own, name: file }, ...beside])) return file;
    const name = this.library.addModel(file, model);
    this.sources.set(model, { model, files: own ? [{ ...own, name }, ...beside] : beside });
    return name;
  }

  /** By its name in the library, as it was read first. */
  model(file: string): Model | null {
    const known = this.library.model(file);
    return (known && this.of(known)?.model) ?? null;
  }

  addMotion(files: readonly string[], input: MotionInput): readonly string[] {
    return this.library.addMotion(files, input);
  }

  /** Those of the motions that came so far. */
  get skeletons(): NamedFile[] {
    return this.library.motionFiles.flatMap(([name, motion]) => {
      const text = motion === undefined ? undefined : this.library.motion([name, motion])?.skeleton?.text;
      return text === undefined ? [] : [{ name, bytes: new TextEncoder().encode(text) }];
    });
  }

  of(model: SolverModel): Source | undefined {
    return this.sources.get(model);
  }

  /** What a project is saved with: its model, then motions, each name once. */
  filesOf(model: SolverModel, motions: readonly (readonly string[])[]): NamedFile[] {
    const files = new Map((this.of(model)?.files ?? []).map((file) => [file.name, file]));
    for (const names of motions) {
      const motion = this.library.motion(names);
      const texts = motion ? motionTexts(motion) : [];
      for (const [k, text] of texts.entries()) {
        const name = names[k] ?? "";
        if (!files.has(name)) files.set(name, { name, bytes: new TextEncoder().encode(text) });
      }
    }
    return [...files.values()];
  }
}

function sameFiles(a: readonly NamedFile[], b: readonly NamedFile[]): boolean {
  return a.length === b.length && a.every((file, k) => sameFile(file, b[k]));
}

function sameFile(a: NamedFile, b: NamedFile | undefined): boolean {
  return b !== undefined && a.name === b.name && a.bytes.length === b.bytes.length && a.bytes.every((byte, k) => byte === b.bytes[k]);
}
