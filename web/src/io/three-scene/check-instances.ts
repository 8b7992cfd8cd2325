import { ModelError } from "../named-file";

/** Copies of one thing in another, each holding others, that a file may come to. */
const MOST = 20_000;

/** What holds what, by name. Errors (ModelError): something holds itself; all together come to more than can be drawn. */
export function checkInstances(name: string, holds: ReadonlyMap<string, readonly string[]>): void {
  /** Of each, how many things it comes to; -1 while it is counted. */
  const sizes = new Map<string, number>();
  const size = (id: string): number => {
    const known = sizes.get(id);
    if (known === -1) throw new ModelError(`${name} is broken: "${id.slice(0, 40)}" holds itself.`);
    if (known !== undefined) return known;
    sizes.set(id, -1);
    let sum = 1;
    for (const inner of holds.get(id) ?? []) {
      sum += size(inner);
      if (sum > MOST)
        throw new ModelError(`${name} holds more than ${MOST.toLocaleString("en-US")} copies of its parts, too many to be drawn.`);
    }
    sizes.set(id, sum);
    return sum;
  };
  for (const id of holds.keys()) size(id);
}
