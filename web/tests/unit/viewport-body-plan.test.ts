import { describe, expect, test } from "vitest";
import { buildBodyPlan, highestLeaf, type BodyPlan } from "../../src/viewport/body-plan";
import { describeJoints } from "../../src/skeleton/pair-joints";
import type { DrawnHuman } from "../../src/stage/port";
import { namedJoints } from "../support/joints";

type Named = DrawnHuman & { names: string[] };

/** "parent>child>grandchild" chains; a joint is named once before others hang from it. Roles are those that the names tell. */
function skeleton(...chains: string[]): Named {
  const names: string[] = [];
  const parents: number[] = [];
  for (const chain of chains) {
    let parent = -1;
    for (const name of chain.split(">")) {
      let joint = names.indexOf(name);
      if (joint < 0) {
        joint = names.push(name) - 1;
        parents.push(parent);
      }
      parent = joint;
    }
  }
  return { names, joints: describeJoints(namedJoints(...names)), parents: Int32Array.from(parents) };
}

const acclaim = skeleton(
  "root>lhipjoint>lfemur>ltibia>lfoot>ltoes",
  "root>rhipjoint>rfemur>rtibia>rfoot>rtoes",
  "root>lowerback>upperback>thorax>lowerneck>upperneck>head",
  "thorax>lclavicle>lhumerus>lradius>lwrist>lhand>lfingers",
  "lwrist>lthumb",
  "thorax>rclavicle>rhumerus>rradius>rwrist>rhand>rfingers",
  "rwrist>rthumb",
);

const cmuBvh = skeleton(
  "Hips>LHipJoint>LeftHip>LeftKnee>LeftAnkle>LeftToe>LeftToe_End",
  "Hips>RHipJoint>RightHip>RightKnee>RightAnkle>RightToe>RightToe_End",
  "Hips>lowerback>Chest>Chest2>lowerneck>Neck>Head>Head_End",
  "Chest2>LeftCollar>LeftShoulder>LeftElbow>LeftWrist>lhand>LFingers>LFingers_End",
  "LeftWrist>LThumb>LThumb_End",
  "Chest2>RightCollar>RightShoulder>RightElbow>RightWrist>rhand>RFingers>RFingers_End",
  "RightWrist>RThumb>RThumb_End",
);

const m = (chain: string): string =>
  chain
    .split(">")
    .map((name) => `mixamorig:${name}`)
    .join(">");
const mixamo = skeleton(
  m("Hips>Spine>Spine1>Spine2>Neck>Head>HeadTop_End"),
  m("Spine2>LeftShoulder>LeftArm>LeftForeArm>LeftHand>LeftHandThumb1>LeftHandThumb2"),
  m("LeftHand>LeftHandMiddle1>LeftHandMiddle2>LeftHandMiddle3"),
  m("LeftHand>LeftHandIndex1>LeftHandIndex2"),
  m("Spine2>RightShoulder>RightArm>RightForeArm>RightHand>RightHandMiddle1"),
  m("RightHand>RightHandRing1"),
  m("Hips>LeftUpLeg>LeftLeg>LeftFoot>LeftToeBase>LeftToe_End"),
  m("Hips>RightUpLeg>RightLeg>RightFoot>RightToeBase>RightToe_End"),
);

function named(human: Named, plan: BodyPlan): Record<string, string | undefined> {
  return Object.fromEntries(Object.entries(plan.torso ?? {}).map(([part, joint]) => [part, human.names[joint as number]]));
}

describe("the mannequin's bones", () => {
  test.each([
    [
      "Acclaim",
      acclaim,
      { leftHip: "lhipjoint", rightHip: "rhipjoint", leftShoulder: "lclavicle", rightShoulder: "rclavicle", middle: "upperback" },
    ],
    [
      "CMU's BVH",
      cmuBvh,
      { leftHip: "LeftHip", rightHip: "RightHip", leftShoulder: "LeftShoulder", rightShoulder: "RightShoulder", middle: "Chest" },
    ],
    [
      "Mixamo",
      mixamo,
      {
        leftHip: "mixamorig:LeftUpLeg",
        rightHip: "mixamorig:RightUpLeg",
        leftShoulder: "mixamorig:LeftArm",
        rightShoulder: "mixamorig:RightArm",
        middle: "mixamorig:Spine1",
      },
    ],
  ])("%s: hips and shoulders are where limbs begin, not collars", (_, human, torso) => {
    expect(named(human, buildBodyPlan(human))).toEqual(torso);
  });

  test("the head is the joint of that name; its end, if there is one, is kept apart", () => {
    expect(acclaim.names[buildBodyPlan(acclaim).head]).toBe("head");
    expect(buildBodyPlan(acclaim).headTop).toBe(-1);
    const plan = buildBodyPlan(mixamo);
    expect(mixamo.names[plan.head]).toBe("mixamorig:Head");
    expect(mixamo.names[plan.headTop]).toBe("mixamorig:HeadTop_End");
    expect(plan.bones.some((bone) => bone.to === plan.headTop)).toBe(false);
  });

  test("thumbs, fingers beyond the palm and ends are neither drawn nor picked, toes are", () => {
    for (const human of [acclaim, cmuBvh, mixamo]) {
      const seen = buildBodyPlan(human).joints.map((j) => human.names[j]!);
      expect(seen.filter((name) => /thumb|index|ring\d|middle[23]|fingers_end|head_end/i.test(name))).toEqual([]);
      expect(seen.some((name) => /toe/i.test(name))).toBe(true);
      expect(seen.some((name) => /hand/i.test(name))).toBe(true);
      expect(seen.filter((name) => /middle1|fingers$/i.test(name))).toHaveLength(2); // one for each palm
    }
  });

  test("every drawn bone joins a joint with its own parent", () => {
    for (const human of [acclaim, cmuBvh, mixamo]) {
      const { bones, joints } = buildBodyPlan(human);
      expect(bones.length).toBe(joints.length - 1);
      for (const bone of bones) expect(human.parents[bone.to]).toBe(bone.from);
    }
  });

  test("a tree of unknown names is all capsules, and its head is its highest leaf", () => {
    const dragon = skeleton("a>b>c>d", "b>e>f", "a>g");
    const plan = buildBodyPlan(dragon);
    expect(plan).toMatchObject({ head: -1, headTop: -1, torso: null });
    expect(plan.bones.length).toBe(6);
    const pose = new Float32Array(21);
    pose[3 * dragon.names.indexOf("b") + 1] = 9; // high, but not a leaf
    pose[3 * dragon.names.indexOf("f") + 1] = 2;
    pose[3 * dragon.names.indexOf("d") + 1] = 1;
    expect(dragon.names[highestLeaf(dragon, plan.joints, pose)]).toBe("f");
  });

  test("a single joint has no bones", () => {
    expect(buildBodyPlan(skeleton("root")).bones).toEqual([]);
  });
});
