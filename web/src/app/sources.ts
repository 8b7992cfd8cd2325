import type { MotionInput } from "../engine/types";
import type { Model } from "../io/model";
import { motionFormat } from "../io/read-motion-files";
import { extension } from "../io/named-file";
import type { NamedFile } from "../io/named-file";
import type { Library } from "../sync/library";
import type { SolverModel } from "../sync/prepare";

/** What models and motions were read from, so that a project can be saved with them; and their decoded pictures. */
export class Sources {
  private readonly files = new WeakMap<SolverModel, readonly NamedFile[]>();
  private readonly textures = new WeakMap<SolverModel, ImageBitmap>();

  constructor(private readonly library: Library) {}

  /**
   * Keeps a model under a name of its own, its own file first among `files`; answers the name. The same files opened again
   * are the same model.
   */
  async keepModel(file: string, model: Model, files: readonly NamedFile[]): Promise<string> {
    const [own, ...others] = files;
    const beside = others.filter((other) => motionFormat(other) === null && extension(other.name) !== "json");
    const known = this.library.model(file);
    if (known && own && sameFiles(this.files.get(known) ?? [], [{ ...own, name: file }, ...beside])) return file;
    const { texture } = model.drawn;
    if (texture) {
      const blob = new Blob([texture.bytes.slice()], { type: texture.mime });
      this.textures.set(model, await createImageBitmap(blob, { premultiplyAlpha: "none", colorSpaceConversion: "none" }));
    }
    const name = this.library.addModel(file, model);
    this.files.set(model, own ? [{ ...own, name }, ...beside] : beside);
    return name;
  }

  keepMotion(files: readonly string[], input: MotionInput): readonly string[] {
    return this.library.addMotion(files, input);
  }

  texture(model: SolverModel): ImageBitmap | null {
    return this.textures.get(model) ?? null;
  }

  /** Everything that a project names. */
  of(model: SolverModel, motionFiles: readonly string[]): NamedFile[] {
    const motion = this.library.motion(motionFiles);
    const encode = (text: string): Uint8Array => new TextEncoder().encode(text);
    const texts = !motion ? [] : motion.format === "bvh" ? [motion.text] : [motion.skeleton, motion.text];
    const motions = texts.map((text, k) => ({ name: motionFiles[k] ?? "", bytes: encode(text) }));
    return [...(this.files.get(model) ?? []), ...motions];
  }
}

function sameFiles(a: readonly NamedFile[], b: readonly NamedFile[]): boolean {
  return a.length === b.length && a.every((file, k) => sameFile(file, b[k]));
}

function sameFile(a: NamedFile, b: NamedFile | undefined): boolean {
  return b !== undefined && a.name === b.name && a.bytes.length === b.bytes.length && a.bytes.every((byte, k) => byte === b.bytes[k]);
}
