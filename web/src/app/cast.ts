import type { ProjectDocument } from "../document/types";
import { baseName } from "../io/named-file";
import { stem } from "../util/words";
import type { Builtins } from "./builtins";
import type { Context } from "./context";
import type { Character } from "./ports";

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

  constructor(
    private readonly context: Context,
    private readonly builtins: Builtins,
  ) {
    context.signals.on("document", (previous) => {
      const { file } = previous.mesh;
      if (file !== "" && file !== context.document.mesh.file) this.left.set(file, previous);
    });
  }

  get list(): readonly Performer[] {
    const { builtins } = this;
    const ours = builtins.characters.map((character) => ({ file: builtins.modelFile(character), name: character.name, character }));
    const known = new Set(["", ...ours.map(({ file }) => file)]);
    const opened = [...new Set([...this.left.keys(), this.context.document.mesh.file])].filter((file) => !known.has(file));
    return [...ours, ...opened.map((file) => ({ file, name: stem(baseName(file)), character: null }))];
  }

  isOnStage({ file }: Performer): boolean {
    return file === this.context.document.mesh.file;
  }

  get present(): Performer | undefined {
    return this.list.find((performer) => this.isOnStage(performer));
  }

  /** "Cactus"; nothing while nobody is there. */
  get presentName(): string {
    const name = this.present?.name ?? "";
    return name.charAt(0).toUpperCase() + name.slice(1);
  }

  /** The character of ours after the one on the stage, around the end. */
  get next(): Performer | undefined {
    const ours = this.list.filter(({ character }) => character !== null);
    const now = ours.findIndex((performer) => this.isOnStage(performer));
    const next = ours[(now + 1) % ours.length];
    return next && this.isOnStage(next) ? undefined : next;
  }

  /** The projects of those who left the stage. */
  get away(): readonly ProjectDocument[] {
    return [...this.left.values()];
  }

  /** Who is away comes back as they left. */
  restore(away: readonly ProjectDocument[]): void {
    this.left.clear();
    for (const document of away) this.left.set(document.mesh.file, document);
  }

  /** What a performer's project was when they left the stage. */
  remembered(file: string): ProjectDocument | undefined {
    return this.left.get(file);
  }
}
