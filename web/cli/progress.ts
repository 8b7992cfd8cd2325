/** Says on stderr what is being done; on a terminal in one line that changes, else one line per step. */
export class Progress {
  private shown = "";
  private step_ = "";
  /** What was noted so far. */
  readonly notes: string[] = [];

  constructor(private readonly quiet: boolean) {}

  /** `done` is 0..1. */
  step(step: string, done?: number): void {
    if (this.quiet) return;
    if (process.stderr.isTTY) this.show(done === undefined ? step : `${step}, ${Math.round(100 * done)} %`);
    else if (step !== this.step_) process.stderr.write(`${step}\n`);
    this.step_ = step;
  }

  note(text: string): void {
    this.notes.push(text);
    this.line(`note: ${text}`);
  }

  done(text: string): void {
    this.line(text);
  }

  private line(text: string): void {
    if (this.quiet) return;
    this.show("");
    process.stderr.write(`${text}\n`);
  }

  private show(text: string): void {
    if (!process.stderr.isTTY || text === this.shown) return;
    process.stderr.write(`\r${text.padEnd(this.shown.length)}\r${text}`);
    this.shown = text;
  }
}
