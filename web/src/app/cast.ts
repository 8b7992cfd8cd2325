import type { ProjectDocument } from "../document/types";
import { baseName } from "../io/named-file";
import { stem } from "../util/words";
import type { Character } from "./builtins";
import type { Session } from "./session";

/** Someone who can dance: a character of ours, or a model that was opened. */
export interface Performer {
  /** As documents call its model. */
  file: string;
  name: string;
  character: Character | null;
}

/** Who can dance. Whoever leaves the stage keeps points and poses until they come back. */
export class Cast {
  private readonly left = new Map<string, ProjectDocument>();

  constructor(private readonly session: Session) {}

  get list(): readonly Performer[] {
    const { builtins, document } = this.session;
    const ours = builtins.characters.map((character) => ({ file: builtins.modelFile(character), name: character.name, character }));
    const known = new Set(["", ...ours.map(({ file }) => file)]);
    const opened = [...new Set([...this.left.keys(), document.mesh.file])].filter((file) => !known.has(file));
    return [...ours, ...opened.map((file) => ({ file, name: stem(baseName(file)), character: null }))];
  }

  isOnStage({ file }: Performer): boolean {
    return file === this.session.document.mesh.file;
  }

  get present(): Performer | undefined {
    return this.list.find((performer) => this.isOnStage(performer));
  }

  /** The character of ours after the one on the stage, around the end. */
  get next(): Performer | undefined {
    const ours = this.list.filter(({ character }) => character !== null);
    const now = ours.findIndex((performer) => this.isOnStage(performer));
    const next = ours[(now + 1) % ours.length];
    return next && this.isOnStage(next) ? undefined : next;
  }

  /** What a performer's project was when they left the stage. */
  remembered(file: string): ProjectDocument | undefined {
    return this.left.get(file);
  }

  /** Called with every document that another one replaced. */
  remember(previous: ProjectDocument, present: ProjectDocument): void {
    if (previous.mesh.file !== "" && previous.mesh.file !== present.mesh.file) this.left.set(previous.mesh.file, previous);
  }
}
