// Which limb of a body a joint belongs to, by its name: those of animals too, which no human has.

import type { BodyPart, Side } from "./body-parts";
import { readJointNames } from "./joint-names";
import { isNumber, nameWords, plain } from "./name-words";

export interface LimbName {
  /** `helper`: it steers others, and stands anywhere. */
  kind: "head" | "arm" | "leg" | "wing" | "tail" | "helper" | null;
  side: Side;
  part: BodyPart | null;
  /** Which of several on a side: "front", "mid back"; "" where it is not said. */
  which: string;
}

const set = (text: string): ReadonlySet<string> => new Set(text.split(" "));

const HELPERS = set(
  "ik fk pole target control ctrl pt slot handslot socket weapon anchor scale roll gun prop kneeik elbowik handik heelik",
);
const WINGS = set("wing wings fin fins flipper flippers");
const FEET = set("foot feet paw paws hoof hooves ankle");
const LEGS = new Set([...FEET, ...set("leg legs knee thigh shin")]);
const OF_HEADS = set("mouth jaw muzzle snout beak");
const ON_HEADS = set("ear ears hair bang bun hat cap helmet horn horns antler antlers antenna tongue");
const WHICH = new Map<string, string>(
  Object.entries({ front: "front fore", mid: "mid middle", back: "back rear hind", top: "top", bottom: "bottom" }).flatMap(
    ([which, words]) => words.split(" ").map((word) => [word, which] as const),
  ),
);
const OF_LEGS: ReadonlySet<BodyPart | null> = new Set<BodyPart>(["upper_leg", "lower_leg", "foot", "toe", "tip"]);
const OF_ARMS: ReadonlySet<BodyPart | null> = new Set<BodyPart>(["upper_arm", "lower_arm", "hand", "finger"]);

/** `names`: of one skeleton. */
export function readLimbNames(names: readonly string[]): LimbName[] {
  const read = readJointNames(names);
  const limbs = names.map((name, j) => limbOf(nameWords(name).map(plain), read[j]));
  // "MidLeg" alone is the middle of a leg, with others of its kind it is a leg.
  const many = (limb: LimbName): boolean =>
    limb.which === "" ||
    limbs.filter(({ kind, side, which }) => kind === limb.kind && side === limb.side && which === limb.which).length > 1;
  return limbs.map((limb) => (limb.kind === "leg" && !many(limb) ? { ...limb, kind: null } : limb));
}

function limbOf(words: readonly string[], { side, part }: { side: Side; part: BodyPart | null }): LimbName {
  const has = (some: ReadonlySet<string>): boolean => words.some((word) => some.has(word));
  const which = [...new Set(words.flatMap((word) => WHICH.get(word) ?? []))].join(" ");
  const of = (kind: LimbName["kind"], own = ""): LimbName => ({ kind, side, part, which: own });
  if (has(HELPERS)) return of("helper");
  if (words.includes("tail")) return of("tail");
  if (side !== null && has(WINGS)) return of("wing", which === "front" || which === "back" ? which : "");
  if (side !== null && which !== "" && (has(LEGS) || OF_LEGS.has(part) || OF_ARMS.has(part))) {
    if (!has(LEGS) && part === "finger") return of("arm");
    return { ...of("leg", which), part: has(FEET) ? "foot" : part === "finger" ? null : part };
  }
  if (side !== null && (OF_LEGS.has(part) || OF_ARMS.has(part))) return of(OF_LEGS.has(part) ? "leg" : "arm");
  return of((part === "head" || (part === null && side === null && has(OF_HEADS))) && !has(ON_HEADS) ? "head" : null);
}

/** Whether what hangs on a head is no part of it. */
export function standsOut(name: string): boolean {
  return nameWords(name).some((word) => !isNumber(word) && ON_HEADS.has(plain(word)));
}
