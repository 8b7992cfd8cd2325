import type { Session } from "./session";

/** From the document to files: the project and the animated model. */
export class Saving {
  constructor(private readonly session: Session) {}

  async save(): Promise<void> {
    this.session.markSaved();
  }

  async exportModel(): Promise<void> {
    await Promise.resolve();
  }
}
