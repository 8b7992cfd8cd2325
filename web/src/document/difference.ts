// What of a project is not as in another one, as JSON, and the project again from that: exactly the same.
//   object: [what changed, by key; the keys that are gone, if any are]
//   list of things with ids: per thing its place in the old list, or [its place, what changed of it], or the new thing
//   all else: the new value

type Table = Readonly<Record<string, unknown>>;
type Things = readonly (Table & { readonly id: unknown })[];

const isTable = (value: unknown): value is Table => typeof value === "object" && value !== null && !Array.isArray(value);
const hasIds = (value: unknown): value is Things => Array.isArray(value) && value.length > 0 && value.every((v) => isTable(v) && "id" in v);

/** Undefined where nothing differs. */
export function difference(from: unknown, to: unknown): unknown {
  if (isTable(from) && isTable(to)) return tableDifference(from, to);
  if (hasIds(from) && Array.isArray(to)) return listDifference(from, to);
  return same(from, to) ? undefined : to;
}

/** The same again. Errors (RangeError): it is no difference from this. */
export function applied(from: unknown, change: unknown): unknown {
  if (change === undefined) return from;
  if (change === null) return null;
  if (isTable(from)) {
    const [changed, gone = []] = list(change);
    if (!isTable(changed)) throw new RangeError("no difference");
    const kept = Object.entries(from).filter(([key]) => !list(gone).includes(key));
    const now = Object.fromEntries(kept);
    return { ...now, ...Object.fromEntries(Object.entries(changed).map(([key, part]) => [key, applied(own(from, key), part)])) };
  }
  if (!hasIds(from)) return change;
  return list(change).map((item) => {
    if (isTable(item)) return item;
    const [place, part] = typeof item === "number" ? [item] : list(item);
    if (typeof place !== "number" || !(place in from)) throw new RangeError("no difference");
    return applied(from[place], part);
  });
}

function tableDifference(from: Table, to: Table): unknown {
  const gone = Object.keys(from).filter((key) => !Object.hasOwn(to, key));
  const changed = Object.entries(to).flatMap(([key, value]) => {
    const part = difference(own(from, key), value);
    return part === undefined ? [] : [[key, part] as const];
  });
  if (changed.length === 0 && gone.length === 0) return undefined;
  return gone.length > 0 ? [Object.fromEntries(changed), gone] : [Object.fromEntries(changed)];
}

function listDifference(from: Things, to: readonly unknown[]): unknown {
  const items = to.map((thing) => {
    const place = from.findIndex(({ id }) => isTable(thing) && thing["id"] === id);
    if (place < 0) return thing;
    const part = difference(from[place], thing);
    return part === undefined ? place : [place, part];
  });
  return items.length === from.length && items.every((item, k) => item === k) ? undefined : items;
}

function own(table: Table, key: string): unknown {
  return Object.hasOwn(table, key) ? table[key] : undefined;
}

function list(value: unknown): readonly unknown[] {
  if (!Array.isArray(value)) throw new RangeError("no difference");
  return value;
}

function same(a: unknown, b: unknown): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
