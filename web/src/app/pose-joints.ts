// The joints of poses that were made on motions of ours: they are told again by the motion's name and the frame.

import { startOf } from "../document/clips";
import type { ProjectDocument } from "../document/types";
import type { Engine, Motion } from "../engine/types";
import type { JointsOf } from "../io/project-link";
import { Binding } from "../sync/binding";
import { sayPose } from "../sync/pairing";
import type { Builtins } from "./builtins";

/** Reads motions on an engine of its own, which `close` ends. */
export class PoseJoints {
  private readonly binding: Binding;
  private readonly motions = new Map<string, Promise<Motion | null>>();
  /** One motion at a time. */
  private turn: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly builtins: Builtins,
    engine: Engine,
  ) {
    this.binding = new Binding(engine);
  }

  readonly of: JointsOf = async (document, { motion: file, frame }) => {
    const danced = { ...document, motion: { files: [file] } };
    const motion = await this.motion(danced, file);
    const at = frame - startOf(danced);
    if (!motion || at < 0 || at >= motion.frames) return null;
    const size = 3 * motion.joints.length;
    return sayPose(document, motion, motion.local.subarray(at * size, (at + 1) * size)).joints;
  };

  close(): void {
    this.binding.engine.close();
  }

  private motion(danced: ProjectDocument, file: string): Promise<Motion | null> {
    const known = this.motions.get(file);
    if (known) return known;
    const read = async (): Promise<Motion | null> => {
      if (!this.builtins.motions.some((motion) => motion.file === file)) return null;
      return this.binding.takeMotion(danced, { name: file, text: await this.builtins.motionText(file) });
    };
    const motion = this.turn.then(read);
    this.turn = motion.catch(() => undefined);
    this.motions.set(file, motion);
    return motion;
  }
}
