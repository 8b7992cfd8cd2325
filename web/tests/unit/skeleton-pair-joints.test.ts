import { describe, expect, it, test } from "vitest";
import { describeJoints, jointFinder, jointPartners, roleOf } from "../../src/skeleton/pair-joints";
import type { RoledJoint } from "../../src/skeleton/pair-joints";
import { namedJoints, numberedJoints } from "../support/joints";

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
  "mixamorig:Spine1",
  "mixamorig:Spine2",
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
  "mixamorig:RightUpLeg",
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

const found = (to: string[], from: string[], name: string): string => to[jointFinder(namedJoints(...to))(from)[from.indexOf(name)]] ?? "";

test.each([
  [mixamo, acclaim, "lfemur", "mixamorig:LeftLeg"],
  [mixamo, acclaim, "ltibia", "mixamorig:LeftFoot"],
  [mixamo, acclaim, "rfemur", "mixamorig:RightLeg"],
  [mixamo, acclaim, "lhumerus", "mixamorig:LeftForeArm"],
  [mixamo, acclaim, "root", "mixamorig:Hips"],
  [acclaim, mixamo, "mixamorig:LeftLeg", "lfemur"],
  [acclaim, mixamo, "mixamorig:LeftToeBase", "lfoot"],
  [acclaim, cmu, "LeftAnkle", "ltibia"],
  [cmu, mixamo, "mixamorig:LeftFoot", "LeftAnkle"],
  [cmu, mixamo, "mixamorig:LeftForeArm", "LeftElbow"],
  [mixamo, cmu, "LeftHip", "mixamorig:LeftUpLeg"],
  [mixamo, ["thigh.L"], "thigh.L", "mixamorig:LeftUpLeg"],
  [cmu, ["tentacle"], "tentacle", ""],
  [mixamo, ["rhand"], "rhand", ""],
])("finds a joint on another skeleton by its part of the body", (to, from, name, expected) => {
  expect(found(to, from, name)).toBe(expected);
});

describe("a joint's own name", () => {
  it("is believed where it stands, as long as it means the same", () => {
    expect(found(acclaim, ["lfoot"], "lfoot")).toBe("lfoot"); // alone it would be an ankle
    expect(found(["b", "tentacle"], ["tentacle"], "tentacle")).toBe("tentacle");
    // In one skeleton the ankle is called so, and the foot is the ball; in the other the foot is the ankle.
    const kinect = ["HipLeft", "KneeLeft", "AnkleLeft", "FootLeft"];
    expect(found(["HipLeft", "KneeLeft", "FootLeft", "ToesLeft"], kinect, "FootLeft")).toBe("ToesLeft");
  });

  it("that says nothing means what is recorded, and what it says in the file where nothing is", () => {
    const here = numberedJoints("joint_", "hips", "left foot", "", "head");
    const find = jointFinder(here);
    const roles = { joint_1: "head", joint_3: "head", bone: "left foot", other: "left toe" };
    expect([...find(["joint_1", "joint_3", "joint_0", "joint_2", "bone", "other", "joint_9"], roles)]).toEqual([3, 3, 0, 2, 1, -1, -1]);
  });

  it("is read in words where it has no role", () => {
    const here = namedJoints("Hips", "Tail1", "Tail2");
    expect([...jointFinder(here)(["rig:Hips", "rig:tail_1", "rig:tail_2"])]).toEqual([0, 1, 2]);
  });
});

it("partners are on the other side, oneself in the middle, nobody where that cannot be told", () => {
  const names = ["Hips", "LeftHand", "RightHand", "LeftFoot", "x"];
  expect([...jointPartners(namedJoints(...names))]).toEqual([0, 2, 1, -1, -1]);
  expect([...jointPartners(numberedJoints("b", "head", "right toe", "left toe", ""))]).toEqual([0, 2, 1, -1]);
});

it("joints are called by what the engine knows where their names say nothing", () => {
  expect(describeJoints(numberedJoints("joint_", "hips", "left lower arm", "")).map(({ label }) => label)).toEqual([
    "Hips",
    "Left elbow",
    "Joint 2",
  ]);
  expect(describeJoints(namedJoints(...acclaim)).map(({ label }) => label)).toContain("Left elbow");
  expect(describeJoints(numberedJoints("joint_", "hips", "left lower arm", ""))[1]).toMatchObject({ side: "left", part: "lower_arm" });
});

it("roles are words", () => {
  expect(roleOf({ side: "left", part: "lower_arm" })).toBe("left lower arm");
  expect(roleOf({ side: null, part: "hips" })).toBe("hips");
  expect(roleOf({ side: "left", part: "finger" })).toBeNull();
});

test("of the joints of one part the one that moves points has the plain name", () => {
  const joint = (name: string, part: RoledJoint["part"] = null): RoledJoint => ({ name, side: part ? "left" : null, part });
  const arm = [joint("lfemur", "lower_leg"), joint("ltibia", "foot"), joint("lradius"), joint("lwrist"), joint("lhand", "hand")];
  expect(describeJoints(arm).map(({ label }) => label)).toEqual(["Left knee", "Left foot", "Left hand 3", "Left hand 2", "Left hand"]);
});
