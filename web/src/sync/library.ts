import type { MotionInput } from "../engine/types";
import type { SolverModel } from "./placement";

/** The models and motions that a document can name, by the names it uses. Undo may need any of them again. */
export class Library {
  private readonly models = new Map<string, SolverModel>();
  private readonly motions = new Map<string, { files: readonly string[]; input: MotionInput }>();

  model(file: string): SolverModel | undefined {
    return this.models.get(file);
  }

  motion(files: readonly string[]): MotionInput | undefined {
    return this.motions.get(files.join("\n"))?.input;
  }

  /** All motions in the order in which they came. */
  get motionFiles(): readonly (readonly string[])[] {
    return [...this.motions.values()].map((motion) => motion.files);
  }

  /** Keeps a model; answers the name to use for it, which differs if another model has it already. */
  addModel(file: string, model: SolverModel): string {
    const name = freeName(file, (taken) => this.models.has(taken) && this.models.get(taken) !== model);
    this.models.set(name, model);
    return name;
  }

  /** As addModel; the same text under the same names is the same motion. */
  addMotion(files: readonly string[], input: MotionInput): readonly string[] {
    const last = files.at(-1) ?? input.name;
    const named = (name: string): readonly string[] => [...files.slice(0, -1), name];
    const name = freeName(last, (taken) => {
      const known = this.motion(named(taken));
      return known !== undefined && !sameMotion(known, input);
    });
    const key = named(name);
    if (!this.motion(key)) this.motions.set(key.join("\n"), { files: key, input });
    return key;
  }
}

/** The texts of a motion's files, in the order in which a project names them. */
export function motionTexts(motion: MotionInput): string[] {
  return [...(motion.skeleton ? [motion.skeleton.text] : []), motion.text];
}

function sameMotion(a: MotionInput, b: MotionInput): boolean {
  return a.text === b.text && a.skeleton?.text === b.skeleton?.text;
}

/** "cow.obj" -> "cow 2.obj" if it is taken. */
function freeName(file: string, taken: (name: string) => boolean): string {
  if (!taken(file)) return file;
  const dot = file.lastIndexOf(".");
  const [head, tail] = dot > 0 ? [file.slice(0, dot), file.slice(dot)] : [file, ""];
  for (let n = 2; ; n++) if (!taken(`${head} ${n}${tail}`)) return `${head} ${n}${tail}`;
}
