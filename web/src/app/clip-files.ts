// Files that hold several motions, once there is one: not part of the first load.

import type { FoundClip } from "../io/clips/found-clip";
import { baseName, type NamedFile } from "../io/named-file";
import type { JobHandle, Jobs } from "./jobs";
import type { Ports } from "./ports";
import type { Signals } from "./signals";

export type { FoundClip } from "../io/clips/found-clip";

/** Reads the clips of files, and asks which of them come in. */
export class ClipFiles {
  /** What is asked now. */
  asked: { readonly file: string; readonly clips: readonly FoundClip[] } | null = null;
  private answered: (chosen: readonly FoundClip[]) => void = () => {};

  constructor(
    private readonly signals: Signals,
    private readonly jobs: Jobs,
    private readonly readClips: Ports["readClips"],
  ) {}

  /** The clips of the first of `files` that come in; the only one without a question. Errors: as readClips. */
  async of(files: readonly NamedFile[]): Promise<readonly FoundClip[]> {
    const name = baseName(files[0].name);
    const read = ({ signal, progress }: JobHandle): Promise<FoundClip[]> => this.readClips(files, { signal, onProgress: progress });
    const clips = await this.jobs.run(`Opening ${name}`, ["Read"], read);
    return clips.length > 1 ? this.ask(name, clips) : clips;
  }

  /** The chosen ones, in the file's order; none if the person thinks better of it. */
  answer(chosen: readonly FoundClip[]): void {
    this.answered(chosen);
    this.answered = () => {};
    if (this.asked) this.set(null);
  }

  /** A question that nobody has answered gives way. */
  private ask(file: string, clips: readonly FoundClip[]): Promise<readonly FoundClip[]> {
    this.answer([]);
    return new Promise((resolve) => {
      this.answered = resolve;
      this.set({ file, clips });
    });
  }

  private set(asked: ClipFiles["asked"]): void {
    this.asked = asked;
    this.signals.tell("clips");
  }
}
