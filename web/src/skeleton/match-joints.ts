// The same joint on another skeleton: by its name, else by its part of the body. Pure.

/** What bones are called in Acclaim files, where a bone's joint is its far END. */
const BONES: Record<string, string[]> = {
  hip: ["hipjoint"],
  knee: ["femur"],
  ankle: ["tibia"],
  toe: ["foot"],
  tip: ["toes"],
  collar: ["clavicle"],
  shoulder: ["clavicle"],
  elbow: ["humerus"],
  hand: ["hand", "wrist", "radius"],
};

/** What joints are called elsewhere, the most telling first. */
const JOINTS: Record<string, string[]> = {
  hip: ["upleg", "upperleg", "thigh", "hip", "hipjoint"],
  knee: ["knee", "lowleg", "lowerleg", "shin", "calf", "leg"],
  ankle: ["ankle", "foot"],
  toe: ["toebase", "toe", "toes", "ball"],
  tip: ["toeend", "toebaseend", "toesend"],
  collar: ["collar", "clavicle", "shoulder"],
  shoulder: ["upperarm", "uparm", "arm", "shoulder"],
  elbow: ["elbow", "forearm", "lowerarm", "lowarm"],
  hand: ["wrist", "hand"],
};

/** On the middle line, in either. */
const TRUNK: Record<string, string[]> = {
  root: ["root", "hips", "pelvis", "hip"],
  spine: ["lowerback", "spine", "abdomen"],
  chest: ["thorax", "chest", "upperchest", "spine", "upperback"],
  neck: ["lowerneck", "neck"],
  head: ["head"],
};

const LIMB_WORDS = new Set([...Object.values(BONES), ...Object.values(JOINTS)].flat());

interface Parts {
  side: "l" | "r" | "";
  /** Lower case, without side, digits and name space. */
  core: string;
}

/**
 * Finds a joint of a skeleton by a name that may be another skeleton's: exactly, else in the plain spelling, where
 * "mixamorig:LeftFoot" is "lfoot" too, else by the part of the body that the name means (`from`: the names it stands among);
 * -1 if there is none.
 */
export function jointFinder(names: readonly string[]): (name: string, from?: readonly string[]) => number {
  const exact = new Map(names.map((name, j) => [name, j]));
  const plain = new Map(names.map((name, j) => [plainName(name), j] as const).reverse());
  return (name, from = [name]) => exact.get(name) ?? plain.get(plainName(name)) ?? byRole(name, from, names);
}

/** Whether two names are the same but for their spelling. */
export const isSameJoint = (a: string, b: string): boolean => plainName(a) === plainName(b);

function byRole(name: string, from: readonly string[], names: readonly string[]): number {
  const { side, core } = partsOf(name);
  const roles = Object.entries(side ? limbs(from) : TRUNK)
    .filter(([, words]) => words.includes(core))
    .map(([role]) => role);
  const there = names.map(partsOf);
  for (const role of roles) {
    for (const word of (side ? limbs(names) : TRUNK)[role] ?? []) {
      const found = there.findIndex((other) => other.side === side && other.core === word);
      if (found >= 0) return found;
    }
  }
  return -1;
}

/** The vocabulary that a skeleton speaks; where it says "ankle", its "foot" is the ball. */
function limbs(names: readonly string[]): Record<string, string[]> {
  const cores = new Set(names.map((name) => partsOf(name).core));
  if (cores.has("tibia") && cores.has("femur")) return BONES;
  if (cores.has("ankle")) return { ...JOINTS, ankle: ["ankle"], toe: [...(JOINTS.toe ?? []), "foot"] };
  return JOINTS;
}

function partsOf(name: string): Parts {
  const words = name
    .slice(Math.max(name.lastIndexOf(":"), name.lastIndexOf("|")) + 1)
    .replace(/([a-z])([A-Z])/g, "$1 $2")
    .replace(/([A-Z])([A-Z][a-z])/g, "$1 $2")
    .toLowerCase()
    .split(/[^a-z]+/)
    .filter((word) => word !== "" && word !== "bip");
  let side: Parts["side"] = "";
  const rest = words.filter((word) => {
    const found = /^(?:(l|left|lt)|(r|right|rt))$/.exec(word);
    if (found) side = found[1] ? "l" : "r";
    return !found;
  });
  const core = rest.join("");
  const grown = /^(left|right|l|r)(.+)$/.exec(core);
  if (!side && grown && LIMB_WORDS.has(grown[2] ?? "")) return { side: grown[1]?.[0] === "l" ? "l" : "r", core: grown[2] ?? "" };
  return { side, core };
}

function plainName(name: string): string {
  const letters = name
    .slice(name.lastIndexOf(":") + 1)
    .toLowerCase()
    .replace(/[^a-z0-9]/g, "");
  return letters.replace(/^left/, "l").replace(/^right/, "r");
}
