// A motion is called otherwise where another one has its name already: what a dancer says of it by its name goes along.

import type { Companion } from "./types";

/** `names`: of files without folders, what they are called now. */
export function withMotionNames<T extends Pick<Companion, "clips" | "examples">>(dancer: T, names: ReadonlyMap<string, string>): T {
  const { clips, examples } = dancer;
  const now = (name: string): string => names.get(name) ?? name;
  return {
    ...dancer,
    examples: examples.map((one) => ({ ...one, source: { ...one.source, motion: now(one.source.motion) } })),
    ...(clips && { clips: Object.fromEntries(Object.entries(clips).map(([name, said]) => [now(name), said])) }),
  };
}
