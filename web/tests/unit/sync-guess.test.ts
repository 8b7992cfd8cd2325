import { describe, expect, it } from "vitest";

import type { BodyPoint, ShapeAnalysis } from "../../src/engine/types";
import { guessPoints, guessProject } from "../../src/sync/guess";
import { namedJoints, numberedJoints } from "../support/joints";

const MODEL = {
  positions: Float32Array.from({ length: 24 }, (_, i) => [0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0, 1][i % 12]),
  faces: Uint32Array.of(0, 1, 2, 0, 2, 3),
};

const point = (role: BodyPoint["role"], side: BodyPoint["side"], partner: number, wanted = true): BodyPoint => ({
  vertex: 1,
  role,
  side,
  partner,
  radius: 0.4,
  wanted,
});

const SAID: ShapeAnalysis = {
  up: "+y",
  facing: "-x",
  sure: 1,
  symmetry: { point: [0, 0, 0], normal: [0, 0, 1], misfit: 0.01 },
  points: [
    point("foot", "left", 1),
    point("foot", "right", 0),
    point("foreleg", "left", -1),
    point("head", null, 3),
    point("chest", null, 4),
    point("tip", "left", 6, false),
    point("tip", "right", 5, false),
    point("tip", "left", -1, false),
  ],
};

describe("guessing points", () => {
  it("pairs by role, whatever the skeleton calls its joints; a foreleg is a hand, or goes with the foot across", () => {
    const pairs = (...names: string[]) => guessPoints(MODEL, SAID, namedJoints(...names)).points.map((p) => p.joint);
    expect(pairs("Hips", "LeftFoot", "RightFoot", "Head")).toEqual(["Head", "RightFoot", "LeftFoot", "RightFoot", null]);
    expect(pairs("LeftHand", "RightHand", "LeftFoot", "RightFoot")).toEqual([null, "LeftHand", "LeftFoot", "RightFoot", null]);
    expect(pairs("root", "lfemur", "ltibia", "lfoot", "rtibia", "rfoot", "head")).toEqual(["head", "rtibia", "ltibia", "rtibia", null]);
    expect(pairs("mixamorig:LeftFoot", "mixamorig:RightFoot")).toEqual([
      null,
      "mixamorig:RightFoot",
      "mixamorig:LeftFoot",
      "mixamorig:RightFoot",
      null,
    ]);
    expect(pairs("a", "b")).toEqual([null, null, null, null, null]);
  });

  it("names points by what they are, knows partners by id, and keeps what a body does not need apart", () => {
    const { mesh, points, more } = guessPoints(MODEL, SAID, []);
    expect(mesh).toEqual({ up: "+y", facing: "-x" });
    expect(points.map((p) => p.name)).toEqual(["Head", "Left foreleg", "Left foot", "Right foot", "Chest"]);
    expect(points).toMatchObject([
      { mirror: "head" },
      { id: "left-foreleg" },
      { mirror: "right-foot" },
      { mirror: "left-foot" },
      { mirror: "chest" },
    ]);
    expect(points[1]).not.toHaveProperty("mirror");
    expect(more[1]).not.toHaveProperty("mirror");
    expect(more).toMatchObject([{ id: "left-tip", mirror: "right-tip" }, { id: "left-tip-2" }, { id: "right-tip", mirror: "left-tip" }]);
    expect(points[2]).toMatchObject({ position: [2, 0, 0], radius: 0.1 }); // 0.4 of 4 units
  });

  it("makes a whole project", () => {
    expect(guessProject("Cow", "cow.obj", ["a.bvh"], MODEL, SAID, numberedJoints("joint_", "hips", "head"))).toMatchObject({
      name: "Cow",
      mesh: { file: "cow.obj", up: "+y", facing: "-x" },
      motion: { files: ["a.bvh"] },
      points: { length: 5, 0: { name: "Head", joint: "joint_1" } },
      examples: [],
      joints: { joint_1: "head" },
    });
  });
});
