// What joint names say: side, role, and words for people. Covers CMU's ASF and BVH files, Mixamo and their relatives.

export type Side = "left" | "right" | null;

export interface JointName {
  side: Side;
  /** Lower case letters and digits, without prefix and side. */
  base: string;
}

/** An Acclaim bone's joint is its far end, so "femur" is the knee. */
const ACCLAIM: Readonly<Record<string, string>> = {
  hipjoint: "hip",
  femur: "knee",
  tibia: "ankle",
  foot: "ball",
  toes: "toes",
  clavicle: "shoulder",
  humerus: "elbow",
  radius: "wrist",
  wrist: "palm",
  hand: "hand",
  fingers: "fingers",
  thumb: "thumb",
};

const WORDS: Readonly<Record<string, string>> = {
  upleg: "hip",
  leg: "knee",
  uparm: "shoulder",
  upperarm: "shoulder",
  arm: "shoulder",
  forearm: "elbow",
  lowerarm: "elbow",
  lowerback: "lower back",
  upperback: "upper back",
  thorax: "chest",
  lowerneck: "lower neck",
  upperneck: "upper neck",
  toebase: "toes",
  toe: "toes",
  ball: "ball",
  collar: "collar",
  headtopend: "top of the head",
};

export function readJointName(name: string): JointName {
  const plain = name.replace(/^.*[:|]/, "").replace(/^(mixamorig\d*|bip\d*)[_ ]?/i, "");
  const spelled = plain.match(/^(left|right)(.*)$/i) ?? plain.match(/^([lr])[_. -](.*)$/i) ?? plain.match(/^([LR])([A-Z].*)$/);
  if (spelled) return { side: sideOf(spelled[1]!), base: letters(spelled[2]!) };
  const trailing = plain.match(/^(.*?)[_. -](left|right|l|r)$/i);
  if (trailing) return { side: sideOf(trailing[2]!), base: letters(trailing[1]!) };
  const glued = plain.match(/^([lr])([a-z]+)$/);
  if (glued && glued[2]! in ACCLAIM) return { side: sideOf(glued[1]!), base: glued[2]! };
  return { side: null, base: letters(plain) };
}

/** "mixamorig:LeftForeArm" and "lhumerus" are both "Left elbow". */
export function jointLabel(name: string): string {
  const { side, base } = readJointName(name);
  const acclaim = side !== null && /^[lr][a-z]+$/.test(name) ? ACCLAIM[base] : undefined;
  const words = acclaim ?? WORDS[base] ?? base.replace(/(\d+)$/, " $1");
  const label = side ? `${side} ${words}` : words;
  return label.charAt(0).toUpperCase() + label.slice(1);
}

/** Fingers and the ends of their chains: too many and too small to draw or to pick. */
export function isClutter(name: string): boolean {
  const { base } = readJointName(name);
  return /thumb|index|pinky|little|^ring|handring|middle[2-9]|finger[2-9]|fingers?(end|site)|nub/.test(base);
}

export function isEndSite(name: string): boolean {
  return /end ?(site)?\d*$|site$|top$|nub$/i.test(name);
}

function sideOf(text: string): Side {
  return text.charAt(0).toLowerCase() === "l" ? "left" : "right";
}

function letters(text: string): string {
  return text.toLowerCase().replace(/[^a-z0-9]/g, "");
}
