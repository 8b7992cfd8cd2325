import type { Session } from "../app/session";

/** A look at what the page holds, for the console and for tests. Reads only. */
export interface DebugPage {
  readonly document: Session["document"];
  readonly performance: Session["performance"];
  /** The frame at the playhead, and how many there are. */
  readonly frame: number;
  readonly frames: number;
  readonly playing: boolean;
  readonly solving: boolean;
  /** Frames that are not yet of the present dance. */
  readonly stale: number;
  /** V x 3 world metres of a frame; a copy. */
  vertices(frame: number): Float32Array | null;
  /** J x 3 world metres of the human at a frame; a copy. */
  human(frame: number): Float32Array | null;
}

declare global {
  var rigless: DebugPage | undefined;
}

export function debugPage(session: Session): DebugPage {
  const { context } = session;
  const { workspace, player } = context;
  return {
    get document() {
      return session.document;
    },
    get performance() {
      return workspace.performance;
    },
    get frame() {
      return player.frame;
    },
    get frames() {
      return player.frames;
    },
    get playing() {
      return player.playing;
    },
    get solving() {
      return context.solving;
    },
    get stale() {
      return workspace.cache.staleCount;
    },
    vertices: (frame) => context.verticesAt(frame),
    human: (frame) => {
      const { motion } = workspace;
      if (!motion) return null;
      const size = 3 * motion.joints.length;
      return motion.positions.slice(frame * size, (frame + 1) * size);
    },
  };
}
