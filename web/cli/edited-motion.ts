// What the command line says of motions, over what a project says.

import { saidOf } from "../src/document/clips";
import { editMotion, type MotionEdits } from "../src/document/edit-clip";
import type { ProjectDocument } from "../src/document/types";
import { FPS, type MotionInput } from "../src/engine/types";
import { bestLoop } from "../src/sync/best-loop";
import type { Binding } from "../src/sync/binding";
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

/** Errors (UsageError): no number, or none that can be. */
export function motionEditsOf({ from, to, speed, mirror, loop }: Values): MotionEdits {
  const cut = [frameOf("--from", from, 0), frameOf("--to", to, END)] as const;
  if (cut[0] >= cut[1]) throw new UsageError(`--to should be later than --from, but they are ${to} and ${from ?? 0}.`);
  if (speed !== undefined && !(Number(speed) >= 0.25 && Number(speed) <= 4))
    throw new UsageError(`--speed should be a number from 0.25 to 4, but it is "${speed}".`);
  return {
    ...((from !== undefined || to !== undefined) && { cut }),
    ...(speed !== undefined && { speed: Number(speed) }),
    ...(mirror && { mirror }),
    ...(loop && { loop }),
  };
}

function frameOf(option: string, said: string | undefined, otherwise: number): number {
  if (said === undefined) return otherwise;
  const frame = Math.round(Number(said) * FPS);
  if (said.trim() !== "" && frame >= 0 && frame < END) return frame;
  throw new UsageError(`${option} should be a number of seconds, but it is "${said}".`);
}

/**
 * The document with the motion cut and turned as the command line has it. What shall loop and is not cut is cut where it loops
 * best, and that is said. Errors (FileError): it would begin after the motion's end; EngineError.
 */
export async function editedMotion(
  document: ProjectDocument,
  input: MotionInput,
  { edits, progress }: { readonly edits: MotionEdits; readonly progress: Progress },
  binding: Binding,
  signal: AbortSignal,
): Promise<ProjectDocument> {
  const edited = editMotion(edits)(document);
  const { cut } = saidOf(edited);
  const wanted = edits.loop === true && cut === undefined;
  if (!wanted && edits.cut === undefined) return edited;
  const whole = await binding.takeMotion(editMotion({ cut: undefined, loop: undefined })(edited), input, () => ({ signal }));
  if (cut && cut[0] >= whole.frames - 1)
    throw new FileError(`${input.name} lasts ${seconds(whole.frames - 1)}, so its dance cannot begin at ${seconds(cut[0])}.`);
  const best = wanted ? bestLoop(whole) : null;
  if (!best) return edited;
  progress.note(`${input.name} loops best from ${seconds(best.cut[0])} to ${seconds(best.cut[1])}, and is cut there.`);
  return editMotion({ cut: best.cut })(edited);
}

const seconds = (frames: number): string => `${(frames / FPS).toFixed(2)} s`;
