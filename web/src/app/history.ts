import { DocumentStore } from "../document/store";
import type { Command, Gesture, Steps } from "../document/store";
import type { ProjectDocument } from "../document/types";
import type { NoticeAction, Notices } from "./notices";
import type { Signals } from "./signals";

/** The document, what came before it and what is saved of it. */
export class History {
  /** The person has changed something since the page opened. */
  touched = false;
  private readonly store: DocumentStore;
  private savedDocument: ProjectDocument | null = null;
  private keptDocument: ProjectDocument | null = null;

  constructor(
    document: ProjectDocument,
    private readonly notices: Notices,
    private readonly signals: Signals,
  ) {
    this.store = new DocumentStore(document);
    this.store.subscribe((present, previous) => {
      notices.outdate(present);
      signals.emit("document", previous);
      signals.tell("saved");
    });
  }

  get document(): ProjectDocument {
    return this.store.document;
  }
  get canUndo(): boolean {
    return this.store.canUndo;
  }
  get canRedo(): boolean {
    return this.store.canRedo;
  }
  get saved(): boolean {
    return this.document === this.savedDocument;
  }
  /** Something would be lost with the page. */
  get unsaved(): boolean {
    return this.touched && !this.saved && this.unkept;
  }
  /** The browser does not keep what is there now. */
  get unkept(): boolean {
    return this.document !== this.keptDocument;
  }
  get steps(): Steps {
    return this.store.steps;
  }

  apply(command: Command, gesture?: Gesture): void {
    this.touched = true;
    this.store.apply(command, gesture);
  }

  /** Another project: nothing of the old one can be undone. */
  replace(document: ProjectDocument): void {
    this.store.replace(document);
  }

  /** A project that was kept, with everything that was done in it. */
  restore(steps: Steps): void {
    this.touched = true;
    this.keptDocument = steps.present;
    this.store.restore(steps);
  }

  undo(): void {
    this.signals.tell("travel");
    this.notices.retract(this.document);
    this.store.undo();
  }

  redo(): void {
    this.signals.tell("travel");
    this.store.redo();
  }

  markSaved(): void {
    this.savedDocument = this.document;
    this.signals.tell("saved");
  }

  /** The browser keeps this document. */
  markKept(document: ProjectDocument): void {
    this.keptDocument = document;
    this.signals.tell("saved");
  }

  /** Undoes what a notice speaks of. The notice keeps it only as long as nothing else has been done. */
  undoAction(): NoticeAction {
    return { label: "Undo", run: () => this.undo(), of: this.document };
  }
}
