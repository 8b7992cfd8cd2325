import { expect, test } from "vitest";
import { jointFinder } from "../../src/skeleton/match-joints";

const acclaim = [
  "root",
  "lhipjoint",
  "lfemur",
  "ltibia",
  "lfoot",
  "ltoes",
  "rfemur",
  "lowerback",
  "thorax",
  "lowerneck",
  "head",
  "lclavicle",
  "lhumerus",
  "lradius",
  "lwrist",
  "lhand",
];
const mixamo = [
  "mixamorig:Hips",
  "mixamorig:Spine",
  "mixamorig:Neck",
  "mixamorig:Head",
  "mixamorig:LeftShoulder",
  "mixamorig:LeftArm",
  "mixamorig:LeftForeArm",
  "mixamorig:LeftHand",
  "mixamorig:LeftUpLeg",
  "mixamorig:LeftLeg",
  "mixamorig:LeftFoot",
  "mixamorig:LeftToeBase",
  "mixamorig:RightLeg",
];
const cmu = [
  "Hips",
  "Chest",
  "LeftCollar",
  "LeftShoulder",
  "LeftElbow",
  "LeftWrist",
  "LeftHip",
  "LeftKnee",
  "LeftAnkle",
  "LeftToe",
  "Head",
];

const found = (to: string[], from: string[], name: string) => to[jointFinder(to)(name, from)] ?? "";

test.each([
  [mixamo, acclaim, "lfemur", "mixamorig:LeftLeg"],
  [mixamo, acclaim, "ltibia", "mixamorig:LeftFoot"],
  [mixamo, acclaim, "rfemur", "mixamorig:RightLeg"],
  [mixamo, acclaim, "lhumerus", "mixamorig:LeftForeArm"],
  [mixamo, acclaim, "lhand", "mixamorig:LeftHand"],
  [mixamo, acclaim, "root", "mixamorig:Hips"],
  [mixamo, acclaim, "thorax", "mixamorig:Spine"],
  [acclaim, mixamo, "mixamorig:LeftLeg", "lfemur"],
  [acclaim, mixamo, "mixamorig:LeftToeBase", "lfoot"],
  [acclaim, cmu, "LeftAnkle", "ltibia"],
  [acclaim, cmu, "LeftWrist", "lwrist"],
  [cmu, mixamo, "mixamorig:LeftFoot", "LeftAnkle"],
  [cmu, mixamo, "mixamorig:LeftForeArm", "LeftElbow"],
  [mixamo, cmu, "LeftHip", "mixamorig:LeftUpLeg"],
  [mixamo, ["Bip01 L Calf"], "Bip01 L Calf", "mixamorig:LeftLeg"],
  [mixamo, ["thigh.L"], "thigh.L", "mixamorig:LeftUpLeg"],
  [cmu, ["tentacle"], "tentacle", ""],
  [mixamo, acclaim, "rhand", ""],
])("finds a joint on another skeleton by its part of the body", (to, from, name, expected) => {
  expect(found(to, from, name)).toBe(expected);
});
