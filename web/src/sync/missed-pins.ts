// Which pins a dance does not keep, in words.

import { clipOf } from "../document/clips";
import type { Pin, ProjectDocument } from "../document/types";
import type { Performance } from "../engine/types";
import { pinsWithin } from "./details";

/** Less is not worth a word: metres on the stage. */
const MISSED = 0.005;

export interface MissedPin {
  readonly pin: Pin;
  /** By how much, and what stands against it. */
  readonly words: string;
}

/** The worst first; null where the dance is another document's. */
export function missedPins(document: ProjectDocument, { frames, missed }: Pick<Performance, "frames" | "missed">): MissedPin[] | null {
  const pins = pinsWithin(clipOf(document), frames);
  const { worst, against } = missed;
  if (worst.length !== pins.length) return null;
  const order = pins.map((_, n) => n).filter((n) => worst[n] >= MISSED);
  return order
    .sort((a, b) => worst[b] - worst[a])
    .map((n) => {
      const other = pins[against[n]];
      const centimetres = Math.max(1, Math.round(100 * worst[n]));
      const why = other
        ? `${called(document, other)} stands against it; they met half way.`
        : "The ground stands against it: the point stands or would sink there.";
      return { pin: pins[n], words: `${called(document, pins[n])} is missed by ${centimetres} cm. ${why}` };
    });
}

/** "The pin of Left arm at frame 40" */
function called({ points }: ProjectDocument, { point, frame }: Pin): string {
  return `The pin of ${points.find(({ id }) => id === point)?.name ?? "a point"} at frame ${frame}`;
}
