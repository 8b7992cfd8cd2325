// The present document and every earlier one. Documents share what they have in common, so keeping them costs little.

import type { ProjectDocument } from "./types";

/** From a document to the next; the same document means that nothing happened. */
export type Command = (document: ProjectDocument) => ProjectDocument;

/** A drag or a slider's travel: everything that is applied with the same gesture is one step. */
export type Gesture = symbol;

/** Every document that undo and redo can reach; the last of each list is the next. They share what they have in common. */
export interface Steps {
  readonly past: readonly ProjectDocument[];
  readonly present: ProjectDocument;
  readonly future: readonly ProjectDocument[];
}

export type Listener = (document: ProjectDocument, previous: ProjectDocument) => void;

export class DocumentStore {
  private present: ProjectDocument;
  private past: ProjectDocument[] = [];
  private future: ProjectDocument[] = [];
  /** The gesture that the last step belongs to, and what could be redone before it. */
  private open: { gesture: Gesture; future: ProjectDocument[] } | null = null;
  private readonly listeners = new Set<Listener>();

  constructor(document: ProjectDocument) {
    this.present = document;
  }

  get document(): ProjectDocument {
    return this.present;
  }

  get steps(): Steps {
    return { past: [...this.past], present: this.present, future: [...this.future] };
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** One step, or the continuation of one if the last step had the same gesture. */
  apply(command: Command, gesture?: Gesture): void {
    const next = command(this.present);
    if (next === this.present) return;
    if (gesture === undefined || gesture !== this.open?.gesture) {
      this.open = gesture === undefined ? null : { gesture, future: this.future };
      this.past.push(this.present);
      this.future = [];
    }
    this.show(next);
  }

  /** Takes back what a gesture did so far, as if it had never begun. */
  cancel(gesture: Gesture): void {
    if (this.open?.gesture !== gesture) return;
    const before = this.past.pop();
    this.future = this.open.future;
    this.open = null;
    if (before) this.show(before);
  }

  undo(): void {
    const before = this.past.pop();
    if (!before) return;
    this.open = null;
    this.future.push(this.present);
    this.show(before);
  }

  redo(): void {
    const after = this.future.pop();
    if (!after) return;
    this.open = null;
    this.past.push(this.present);
    this.show(after);
  }

  /** Another project: nothing of the old one can be undone. */
  replace(document: ProjectDocument): void {
    this.restore({ past: [], present: document, future: [] });
  }

  /** Another project, with everything that was done in it. */
  restore({ past, present, future }: Steps): void {
    this.past = [...past];
    this.future = [...future];
    this.open = null;
    this.show(present);
  }

  /** Calls after each change; the answer ends it. */
  subscribe(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private show(document: ProjectDocument): void {
    const previous = this.present;
    this.present = document;
    for (const listener of [...this.listeners]) listener(document, previous);
  }
}
