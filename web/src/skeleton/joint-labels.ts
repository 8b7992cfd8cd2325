// What people read: "Left elbow", "Spine 2", "Left forearm roll". The twin of include/rigless/motion/detail/joint_labels.h.

import type { BodyPart, JointName, Side } from "./body-parts";
import type { NameParts } from "./name-parts";

const LABELS: Readonly<Partial<Record<BodyPart, string>>> = {
  hips: "hips",
  spine: "spine",
  chest: "chest",
  neck: "neck",
  head: "head",
  shoulder: "collar",
  upper_arm: "shoulder",
  lower_arm: "elbow",
  hand: "hand",
  upper_leg: "hip",
  lower_leg: "knee",
  foot: "foot",
  toe: "toes",
  tip: "toe tip",
};

/** "Left elbow"; null for a part of which there are many. */
export function partLabel(side: Side, part: BodyPart | null): string | null {
  const words = part && LABELS[part];
  return words ? sentence(side, words) : null;
}

function ownWords({ words }: NameParts): string {
  return words.reduce((text, word) => `${text}${text === "" || (word === "arm" && text.endsWith("fore")) ? "" : " "}${word}`, "");
}

function sentence(side: Side, words: string): string {
  return (side ? `${side} ${words}` : words).replace(/^[a-z]/, (letter) => letter.toUpperCase());
}

/** `result`: side and part of each of `names`. */
export function labelJoints(names: readonly NameParts[], result: readonly Omit<JointName, "label">[]): JointName[] {
  const taken = new Map<string, number>();
  return result.map(({ side, part }, j) => {
    const text = partLabel(side, part) ?? sentence(side, ownWords(names[j]));
    let unique = text;
    let last = taken.get(text) ?? 0;
    if (last++ > 0) {
      for (unique = `${text} ${last}`; taken.has(unique); ) unique = `${text} ${++last}`;
      taken.set(unique, 1);
    }
    taken.set(text, last);
    return { side, part, label: unique };
  });
}
