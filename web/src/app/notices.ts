import type { ProjectDocument } from "../document/types";
import { Emitter } from "../util/emitter";

export type NoticeIcon = "file" | "model" | "motion" | "points" | "poses" | "save" | "scale" | "warning";

export interface NoticeAction {
  label: string;
  run: () => void;
  /** The document that it makes sense for; left out: always. */
  of?: ProjectDocument;
}

export interface Notice {
  id: number;
  /** Only if the thing asked for did not happen. */
  bad: boolean;
  icon: NoticeIcon;
  /** What happened. */
  title: string;
  /** What we did. */
  text: string;
  /** What you can do. */
  actions: NoticeAction[];
}

export type NoticeInput = Partial<Omit<Notice, "id">> & { title: string };

/** What was said and not yet dismissed, newest first. */
export class Notices extends Emitter<{ change: void }> {
  private list: Notice[] = [];
  private next = 1;

  get all(): readonly Notice[] {
    return this.list;
  }

  /** Says it; the same words said again take the place of the older ones. */
  say(input: NoticeInput): number {
    const bad = input.bad ?? false;
    const notice: Notice = { text: "", actions: [], icon: bad ? "warning" : "file", ...input, bad, id: this.next++ };
    this.list = [notice, ...this.list.filter((other) => other.title !== notice.title)];
    this.emit("change", undefined);
    return notice.id;
  }

  dismiss(id: number): void {
    this.list = this.list.filter((notice) => notice.id !== id);
    this.emit("change", undefined);
  }

  /** A document is taken back: so is what was said of it. */
  retract(document: ProjectDocument): void {
    this.list = this.list.filter((notice) => notice.actions.every((action) => action.of !== document));
    this.emit("change", undefined);
  }

  /** Something else was done: what was said stays, what could be done about it goes. */
  outdate(present: ProjectDocument): void {
    const holds = (action: NoticeAction): boolean => action.of === undefined || action.of === present;
    if (this.list.every((notice) => notice.actions.every(holds))) return;
    this.list = this.list.map((notice) => ({ ...notice, actions: notice.actions.filter(holds) }));
    this.emit("change", undefined);
  }

  /** Takes back what has become untrue. */
  dismissTitle(title: string): void {
    const found = this.list.find((notice) => notice.title === title);
    if (found) this.dismiss(found.id);
  }
}
