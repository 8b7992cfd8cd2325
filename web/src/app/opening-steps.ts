import type { Command, Gesture } from "../document/store";
import { baseName } from "../io/named-file";
import type { Taken } from "../sync/workspace";
import { isAbort } from "./aborts";
import type { Builtins } from "./builtins";
import type { Cast } from "./cast";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { Guesses } from "./guesses";
import type { JobHandle, Jobs } from "./jobs";
import type { Motions } from "./motions";
import type { NoticeInput } from "./notices";
import type { Song } from "./song";
import type { Sources } from "./sources";

/** Who helps to open something. */
export interface Openers {
  readonly jobs: Jobs;
  readonly builtins: Builtins;
  readonly cast: Cast;
  readonly motions: Motions;
  readonly guesses: Guesses;
  readonly sources: Sources;
  music(): Promise<Song>;
}

/** From one document to the next, if the engine takes it; and what is said if not. */
export class OpeningSteps {
  constructor(
    private readonly context: Context,
    private readonly cast: Cast,
  ) {}

  /** One step to another document, if the engine can take it. What is done meanwhile stays done. */
  async change(command: Command, job?: JobHandle, gesture?: Gesture): Promise<Taken> {
    const { workspace, history } = this.context;
    const taken = await workspace.tryOn(command(history.document), job?.signal, (done) => job?.progress(done));
    history.apply(command, gesture);
    return taken;
  }

  /** Says what went wrong in the words of whoever found it; answers whether nothing did. */
  async guarded(what: string, work: () => Promise<void>): Promise<boolean> {
    try {
      await work();
      return true;
    } catch (error) {
      if (isAbort(error)) return false;
      const message = errorText(error);
      const named = what.split(", ").some((name) => message.includes(baseName(name)));
      this.refuse(named ? message : `${what}: ${message}`, true);
      return false;
    }
  }

  /** The first sentence says what is wrong, the others what it may be. */
  refuse(message: string, untouched: boolean): void {
    const [, title, rest] = /^(.*?[.:]) ([A-Z].*)$/s.exec(message) ?? [null, message, ""];
    this.say({ bad: untouched, title: title ?? message, text: [rest, untouched ? this.untouched() : ""].filter(Boolean).join(" ") });
  }

  say(notice: NoticeInput): void {
    this.context.notices.say(notice);
  }

  private untouched(): string {
    const { cast } = this;
    return cast.present ? `Your ${cast.presentName.toLowerCase()} is untouched.` : "Nothing is shown yet.";
  }
}
