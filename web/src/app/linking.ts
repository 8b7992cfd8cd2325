// A link that holds the project itself: for one of our characters, whose own project everybody has.

import { MOST_CHARACTERS, writeLink } from "../io/project-link";
import { figure } from "../util/words";
import type { Builtins } from "./builtins";
import type { Cast } from "./cast";
import type { Context } from "./context";
import { errorText } from "./error-words";
import type { Motions } from "./motions";
import { PoseJoints } from "./pose-joints";

export type LinkState =
  | { readonly kind: "making" }
  | { readonly kind: "made"; readonly address: string }
  /** Why there is none: the project file is what can be sent. */
  | { readonly kind: "none"; readonly why: string };

export interface LinkHelpers {
  readonly builtins: Builtins;
  readonly cast: Cast;
  readonly motions: Motions;
}

export class Linking {
  state: LinkState = { kind: "making" };
  private newest = {};

  constructor(
    private readonly context: Context,
    private readonly helpers: LinkHelpers,
  ) {}

  /** `page`: the address that the link continues. */
  async make(page: string): Promise<void> {
    const mine = (this.newest = {});
    this.tell({ kind: "making" });
    const state = await this.link(page).catch((error: unknown): LinkState => ({ kind: "none", why: errorText(error) }));
    if (this.newest === mine) this.tell(state);
  }

  private tell(state: LinkState): void {
    this.state = state;
    this.context.signals.tell("export");
  }

  private async link(page: string): Promise<LinkState> {
    const { document, workspace } = this.context;
    const { builtins, cast, motions } = this.helpers;
    const character = cast.present?.character;
    if (document.companion) return none("A link holds one dancer, and here are two.");
    if (!character) return none("A link holds what differs from one of our characters, and this model is your own.");
    if (!motions.list.some((entry) => entry.builtin && motions.isPlaying(entry)))
      return none("A link holds motions by name, and this one is your own.");
    const joints = new PoseJoints(builtins, workspace.createEngine());
    try {
      const base = (await builtins.load(character)).document;
      const address = `${page}#${await writeLink(character.id, base, document, joints.of)}`;
      if (address.length <= MOST_CHARACTERS) return { kind: "made", address };
      const long = `${figure(address.length)} characters, and some places cut off what is longer than ${figure(MOST_CHARACTERS)}`;
      return none(`There are so many poses in it that the address would have ${long}.`);
    } finally {
      joints.close();
    }
  }
}

const none = (why: string): LinkState => ({ kind: "none", why });
