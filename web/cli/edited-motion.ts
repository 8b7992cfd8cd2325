// What the command line says of motions, over what a project says.

import { saidOf } from "../src/document/clips";
import { editMotion, type MotionEdits } from "../src/document/edit-clip";
import type { ProjectDocument } from "../src/document/types";
import { FPS, type MotionInput } from "../src/engine/types";
import { bestLoop } from "../src/sync/best-loop";
import type { Binding } from "../src/sync/binding";
import { SHORTEST_LOOP } from "../src/util/constants";
import { FileError } from "./files";
import type { Progress } from "./progress";
import { UsageError } from "./verb";

interface Values {
  readonly from?: string | undefined;
  readonly to?: string | undefined;
  readonly speed?: string | undefined;
  readonly mirror?: boolean | undefined;
  readonly loop?: boolean | undefined;
}

/** Later than any motion ends. */
const END = 1e9;

/** What the command line says of every motion; an end of the cut that it does not name is the project's. */
export interface AskedEdits extends MotionEdits {
  readonly from?: number;
  readonly to?: number;
}

/** Errors (UsageError): no number, or none that can be. */
export function motionEditsOf({ from, to, speed, mirror, loop }: Values): AskedEdits {
  if (speed !== undefined && !(Number(speed) >= 0.25 && Number(speed) <= 4))
    throw new UsageError(`--speed should be a number from 0.25 to 4, but it is "${speed}".`);
  const edits = {
    ...(from !== undefined && { from: frameOf("--from", from) }),
    ...(to !== undefined && { to: frameOf("--to", to) }),
    ...(speed !== undefined && { speed: Number(speed) }),
    ...(mirror && { mirror }),
    ...(loop && { loop }),
  };
  if (edits.to !== undefined && (edits.from ?? 0) >= edits.to)
    throw new UsageError(`--to should be later than --from by a frame, 0.034 seconds, but they are ${to} and ${from ?? 0}.`);
  return edits;
}

function frameOf(option: string, said: string): number {
  const frame = Math.round(Number(said) * FPS);
  if (said.trim() !== "" && frame >= 0 && frame < END) return frame;
  throw new UsageError(`${option} should be a number of seconds that a motion may last, but it is "${said}".`);
}

/**
 * The document with the motion cut and turned as the command line has it. What shall loop and is not cut is cut where it loops
 * best, and that is said. Errors (FileError): it would begin after the motion's end or its own, or is too short for a loop;
 * EngineError.
 */
export async function editedMotion(
  document: ProjectDocument,
  input: MotionInput,
  { edits: { from, to, ...edits }, progress }: { readonly edits: AskedEdits; readonly progress: Progress },
  binding: Binding,
  signal: AbortSignal,
): Promise<ProjectDocument> {
  const [first, last] = saidOf(document).cut ?? [0, END];
  const asked = from !== undefined || to !== undefined;
  const edited = editMotion(asked ? { ...edits, cut: [from ?? first, to ?? last] } : edits)(document);
  const { cut, loop, file } = saidOf(edited);
  if (!cut && !loop && !file?.joints) return edited;
  if (cut && cut[0] >= cut[1])
    throw new FileError(`${input.name} is cut to end at ${seconds(cut[1])}, but its dance begins at ${seconds(cut[0])}.`);
  const searched = edits.loop === true && !cut;
  const motion = await binding.takeMotion(searched ? editMotion({ loop: undefined })(edited) : edited, input, () => ({ signal }));
  const end = motion.takeFrames - 1;
  if (cut && cut[0] > 0 && cut[0] >= end)
    throw new FileError(`${input.name} lasts ${seconds(end)}, so its dance cannot begin at ${seconds(cut[0])}.`);
  if (loop && motion.frames < SHORTEST_LOOP)
    throw new FileError(
      `${input.name} has ${motion.frames} frames to loop, but ${SHORTEST_LOOP} are needed: cut it to ${seconds(SHORTEST_LOOP)} or more.`,
    );
  for (const [role, name] of Object.entries(file?.joints ?? {}))
    if (!motion.joints.some((joint) => joint.name === name)) progress.note(`${input.name} has no joint "${name}": its ${role} is guessed.`);
  const best = searched ? bestLoop(motion) : null;
  if (!best) return edited;
  progress.note(`${input.name} loops best from ${seconds(best.cut[0])} to ${seconds(best.cut[1])}, and is cut there.`);
  return editMotion({ cut: best.cut })(edited);
}

const seconds = (frames: number): string => `${(frames / FPS).toFixed(2)} s`;
