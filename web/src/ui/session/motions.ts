import { stem } from "../words";
import type { Session } from "./session";

export interface MotionEntry {
  files: readonly string[];
  builtin: boolean;
}

/** The motions that can be played: built-in ones and those that were opened. */
export class Motions {
  constructor(private readonly session: Session) {}

  get list(): readonly MotionEntry[] {
    const { builtins, workspace } = this.session;
    const builtin = builtins.motions.map((file) => ({ files: [file], builtin: true }));
    const known = new Set(builtin.map((entry) => entry.files.join("\n")));
    const opened = workspace.library.motionFiles.filter((files) => !known.has(files.join("\n")));
    return [...builtin, ...opened.map((files) => ({ files, builtin: false }))];
  }

  isPlaying(entry: MotionEntry): boolean {
    return entry.files.join("\n") === this.session.document.motion.files.join("\n");
  }

  /** The built-in one that does not play now. */
  get other(): MotionEntry | undefined {
    return this.list.find((entry) => entry.builtin && !this.isPlaying(entry));
  }

  /** "Try a walk" */
  get invitation(): string {
    return `Try a ${stem(this.other?.files.at(-1) ?? "")}`;
  }
}
