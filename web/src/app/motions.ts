import { stem } from "../util/words";
import type { Builtins } from "./builtins";
import type { Context } from "./context";

export interface MotionEntry {
  files: readonly string[];
  builtin: boolean;
  name: string;
}

/** The motions that can be played: built-in ones and those that were opened. */
export class Motions {
  constructor(
    private readonly context: Context,
    private readonly builtins: Builtins,
  ) {}

  get list(): readonly MotionEntry[] {
    const builtin = this.builtins.motions.map(({ file, name }) => ({ files: [file], builtin: true, name }));
    const known = new Set(builtin.map((entry) => entry.files.join("\n")));
    const opened = this.context.workspace.library.motionFiles.filter((files) => !known.has(files.join("\n")));
    return [...builtin, ...opened.map((files) => ({ files, builtin: false, name: stem(files.at(-1) ?? "") }))];
  }

  isPlaying(entry: MotionEntry): boolean {
    return entry.files.join("\n") === this.context.document.motion.files.join("\n");
  }

  /** The built-in one after the one that plays now, around the end. */
  get next(): MotionEntry | undefined {
    const builtin = this.list.filter((entry) => entry.builtin);
    const now = builtin.findIndex((entry) => this.isPlaying(entry));
    const next = builtin[(now + 1) % builtin.length];
    return next && this.isPlaying(next) ? undefined : next;
  }
}
