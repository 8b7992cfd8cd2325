import type { ProjectDocument } from "../document/types";
import type { Shape } from "../stage/port";
import { Emitter } from "../util/emitter";

/** What has changed. Parts of the app and elements of the page listen to the topics they need. */
export interface Topics {
  /** The document is another one; the one before. */
  document: ProjectDocument;
  /** The document is about to go back or on. */
  travel: void;
  /** Saved, or not any more. */
  saved: void;
  /** What the browser keeps has changed. */
  kept: void;
  /** The frame to show. */
  frame: void;
  play: void;
  /** Mesh, motion or dance changed, or solving began or ended. */
  solve: void;
  selection: void;
  panel: void;
  layout: void;
  intro: void;
  help: void;
  notices: void;
  jobs: void;
  /** A character or a motion was chosen, or has arrived. */
  coming: void;
  thumbnails: void;
  /** How fast we solve. */
  meter: void;
  /** The hand took, moved or let go of a dot. */
  drag: void;
  /** The shape at this frame stays until the new dance has one of its own; then playing goes on, or not. */
  freeze: { frame: number; playOn: boolean };
  pairing: void;
  /** Points are suggested, or not any more. */
  suggestions: void;
  pins: void;
  /** A pose is asked for, or not any more. */
  coverage: void;
  /** A file's motions are to be chosen from, or not any more. */
  clips: void;
  /** The file that is to be taken along, or how far it is. */
  export: void;
  /** Who is to dance beside was chosen, or has come. */
  duet: void;
  /** Another song plays with the dance, or none, or it is muted or not. */
  song: void;
  /** The stage was built. */
  stage: void;
  /** The model was put on the stage anew: V x 3, at rest. */
  staged: Shape;
}

export class Signals extends Emitter<Topics> {
  /** Says that a topic without details changed. */
  tell(topic: { [K in keyof Topics]: Topics[K] extends void ? K : never }[keyof Topics]): void {
    (this as Emitter<Record<typeof topic, void>>).emit(topic, undefined);
  }
}
