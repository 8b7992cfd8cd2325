// Skeletons as files bring them, in several people's words.

import type { NamedJoint } from "../../src/sync/named-body";

type Place = [number, number, number];
/** [word, parent, place]: the left side only; "L" stands for the side. */
type Bone = readonly [word: string, parent: string | null, place: Place];

/** Of the hostile person whose arms hang. */
export const PERSON: readonly Bone[] = [
  ["hips", null, [0, 0.96, 0]],
  ["spine", "hips", [0, 1.1, 0]],
  ["chest", "spine", [0, 1.26, 0]],
  ["neck", "chest", [0, 1.42, 0]],
  ["head", "neck", [0, 1.52, 0.01]],
  ["collar L", "chest", [0.05, 1.36, 0]],
  ["upper arm L", "collar L", [0.22, 1.37, 0]],
  ["lower arm L", "upper arm L", [0.269, 1.094, -0.01]],
  ["hand L", "lower arm L", [0.312, 0.848, 0]],
  ["upper leg L", "hips", [0.105, 0.92, 0]],
  ["lower leg L", "upper leg L", [0.105, 0.5, 0.01]],
  ["foot L", "lower leg L", [0.105, 0.09, -0.02]],
  ["toes L", "foot L", [0.105, 0.045, 0.13]],
];

export const HOUND: readonly Bone[] = [
  ["root", null, [0, 0, 0]],
  ["body", "root", [0, 0.6, 0]],
  ["neck", "body", [0, 0.7, 0.4]],
  ["head", "neck", [0, 0.9, 0.55]],
  ["ear L", "head", [0.06, 1, 0.5]],
  ["front shoulder L", "body", [0.1, 0.6, 0.35]],
  ["front upper leg L", "front shoulder L", [0.12, 0.45, 0.35]],
  ["front lower leg L", "front upper leg L", [0.12, 0.2, 0.36]],
  ["back upper leg L", "body", [0.12, 0.5, -0.35]],
  ["back lower leg L", "back upper leg L", [0.12, 0.22, -0.4]],
  ["back foot L", "root", [0.12, 0.02, -0.36]],
  ["pole target L", "root", [0.12, 0.4, 1.5]],
  ["tail 1", "body", [0, 0.6, -0.45]],
  ["tail 2", "tail 1", [0, 0.7, -0.6]],
];

/** How people call the bones of a person. */
export const VOCABULARIES: Readonly<Record<string, (word: string, side: "L" | "R") => string>> = {
  plain: (word, side) => word.replace(/L$/, side),
  blender: (word, side) =>
    word
      .replace(/\b[a-z]/g, (letter) => letter.toUpperCase())
      .replace(/ L$/, `.${side}`)
      .replace(" ", ""),
  mixamo: (word, side) => {
    const words: Record<string, string> = {
      ...{ hips: "Hips", spine: "Spine", chest: "Spine2", neck: "Neck", head: "Head", "collar L": "Shoulder", "upper arm L": "Arm" },
      ...{
        "lower arm L": "ForeArm",
        "hand L": "Hand",
        "upper leg L": "UpLeg",
        "lower leg L": "Leg",
        "foot L": "Foot",
        "toes L": "ToeBase",
      },
    };
    return `mixamorig:${word.endsWith("L") ? (side === "L" ? "Left" : "Right") : ""}${words[word]}`;
  },
  unreal: (word, side) => {
    const words: Record<string, string> = {
      ...{
        hips: "pelvis",
        spine: "spine_01",
        chest: "spine_03",
        neck: "neck_01",
        head: "head",
        "collar L": "clavicle",
        "upper arm L": "upperarm",
      },
      ...{ "lower arm L": "lowerarm", "hand L": "hand", "upper leg L": "thigh", "lower leg L": "calf", "foot L": "foot", "toes L": "ball" },
    };
    return `${words[word]}${word.endsWith("L") ? `_${side.toLowerCase()}` : ""}`;
  },
  japanese: (word, side) => {
    const words: Record<string, string> = {
      ...{ hips: "センター", spine: "上半身", chest: "上半身2", neck: "首", head: "頭", "collar L": "肩", "upper arm L": "腕" },
      ...{ "lower arm L": "ひじ", "hand L": "手首", "upper leg L": "足", "lower leg L": "ひざ", "foot L": "足首", "toes L": "つま先" },
    };
    return `${word.endsWith("L") ? (side === "L" ? "左" : "右") : ""}${words[word]}`;
  },
};

/** Both sides of a skeleton; `turn` as a file may hold it. */
export function skeleton(
  bones: readonly Bone[],
  name: (word: string, side: "L" | "R") => string = VOCABULARIES.plain,
  turn: (place: Place) => Place = (place) => place,
): NamedJoint[] {
  const all = bones.flatMap(([word, parent, place]): { key: string; name: string; parent: string | null; place: Place }[] => {
    if (!word.endsWith("L")) return [{ key: word, name: name(word, "L"), parent, place }];
    return (["L", "R"] as const).map((side) => ({
      key: word.replace(/L$/, side),
      name: name(word, side),
      parent: parent && parent.replace(/ L$/, ` ${side}`),
      place: side === "L" ? place : [-place[0], place[1], place[2]],
    }));
  });
  return all.map((one) => {
    const parent = all.findIndex(({ key }) => key === one.parent);
    return { name: one.name, parent: parent < 0 ? null : parent, position: turn(one.place) };
  });
}

/** A quarter turn that takes up and front to these axes. */
export function turnTo(up: Place, front: Place): (place: Place) => Place {
  const left: Place = [up[1] * front[2] - up[2] * front[1], up[2] * front[0] - up[0] * front[2], up[0] * front[1] - up[1] * front[0]];
  return ([x, y, z]) => [0, 1, 2].map((k) => x * left[k] + y * up[k] + z * front[k]) as Place;
}
