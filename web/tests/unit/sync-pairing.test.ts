import { describe, expect, it } from "vitest";

import { addExample, addPoint, newDocument, pairPoint } from "../../src/document/commands";
import type { Command } from "../../src/document/store";
import type { ProjectDocument, Vec3 } from "../../src/document/types";
import type { Joint } from "../../src/engine/types";
import { exampleJoints, pairingFault, pairingNotes, pointJoints, sayJoint, sayPose } from "../../src/sync/pairing";
import { namedJoints, numberedJoints } from "../support/joints";

const project = (...commands: Command[]): ProjectDocument =>
  commands.reduce((d, command) => command(d), newDocument("t", { file: "t.obj", facing: "+z", up: "+y" }, { files: ["m.asf", "m.amc"] }));

const point = (id: string, joint: string | null): Command => addPoint({ id, name: `the ${id}`, position: [0, 0, 0], joint });
const pose = (id: string, joints: Record<string, Vec3>, roles = {}): Command =>
  addExample({ id, source: { motion: "m", frame: 0 }, joints, points: {} }, roles);

const told = (joints: Joint[]) => ({ joints, told: true });

describe("a document's joints in a motion", () => {
  const body = ["Hips", "LeftUpLeg", "LeftLeg", "LeftFoot"];

  it("points find theirs by role, among the names that an example holds or else all points", () => {
    const document = project(
      point("a", "lfemur"),
      point("b", null),
      point("c", "dorsal"),
      pose("1", { root: [0, 0, 0], lfemur: [1, 2, 3], ltibia: [4, 5, 6] }),
    );
    expect([...pointJoints(document, { joints: namedJoints(...body) })]).toEqual([2, -1, -1]);
  });

  it("examples come in the motion's order, NaN where they do not know a joint, null where they know none", () => {
    const document = project(
      pose("1", { root: [0, 0, 0], lfemur: [1, 2, 3], ltibia: [4, 5, 6] }),
      pose("2", { tentacle: [1, 2, 3] }),
      pose("3", { b0: [9, 9, 9], b1: [8, 8, 8] }, { b1: "left foot", b0: "head" }),
    );
    const [first, second, third] = exampleJoints(document, { joints: namedJoints(...body) });
    expect([...(first ?? [])]).toEqual([0, 0, 0, NaN, NaN, NaN, 1, 2, 3, 4, 5, 6]);
    expect(second).toBeNull();
    expect([...(third ?? [])]).toEqual([NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, 8, 8, 8]);
  });

  it("what finds nothing is told, point by point, or at once if it is all", () => {
    const document = project(point("top", "Head"), point("paw", "LeftFoot"), point("back", null), pose("1", { tentacle: [1, 2, 3] }));
    expect(pairingNotes(document, told(namedJoints(...body)))).toEqual([
      'm.amc has no joint "Head": "the top" follows the whole pose.',
      "Pose 1 was made on another skeleton, and m.amc has none of its joints: it is left out.",
    ]);
    expect(pairingFault(document, told(namedJoints(...body)))).toBeNull();

    const lost = project(point("top", "Head"), point("paw", "LeftFoot"), point("back", null));
    const strange = namedJoints("a", "b");
    expect(pairingNotes(lost, told(strange))).toEqual([
      'm.amc has none of the joints "Head", "LeftFoot": all points follow the whole pose.',
    ]);
    expect(pairingFault(lost, told(strange))).toBe('m.amc has none of the joints "Head", "LeftFoot", which the points follow.');
  });

  it("a motion whose joints cannot be told is told, and a fault unless the points know better", () => {
    const strange = { joints: namedJoints("a", "b"), told: false };
    const sentence =
      "We cannot tell which joints of m.amc are its head, hands and feet, neither by their names nor by how they hang together.";
    expect(pairingNotes(project(point("a", null)), strange)).toEqual([sentence]);
    expect(pairingFault(project(point("a", null)), strange)).toBe(sentence);
    expect(pairingFault(project(point("a", "Head")), strange)).toBe(sentence);
    expect(pairingFault(project(point("a", "b")), strange)).toBeNull();
    expect(pairingFault(project(point("a", "b"), point("c", "Head")), strange)).toBe(sentence);
    expect(pairingFault(project(point("a", null)), { ...strange, told: true })).toBeNull();
  });
});

describe("a motion's joints in a document", () => {
  const numbers = numberedJoints("j", "hips", "left foot", "right foot", "", "head");

  it("are said by their own names, with their roles where these do not tell them", () => {
    const [, left] = numbers;
    expect(sayJoint(project(), left)).toEqual({ name: "j1", roles: { j1: "left foot" } });
    expect(sayJoint(project(), namedJoints("Hips", "LeftFoot")[1])).toEqual({ name: "LeftFoot", roles: {} });
    // Alone, "lfoot" would be the ankle.
    const ball = namedJoints("root", "lfemur", "ltibia", "lfoot")[3];
    expect(sayJoint(project(), ball)).toEqual({ name: "lfoot", roles: { lfoot: "left toe" } });
    const said = sayPose(
      project(),
      { joints: numbers },
      Float32Array.from({ length: 15 }, (_, i) => i),
    );
    expect(said.joints).toEqual({ j0: [0, 1, 2], j1: [3, 4, 5], j2: [6, 7, 8], j3: [9, 10, 11], j4: [12, 13, 14] });
    expect(said.roles).toEqual({ j0: "hips", j1: "left foot", j2: "right foot", j4: "head" });
    const names = namedJoints("root", "lfemur", "ltibia", "lfoot");
    expect(sayPose(project(), { joints: names }, new Float32Array(12)).roles).toEqual({});
  });

  it("lead to the same parts of another skeleton, and back", () => {
    const said = sayPose(project(), { joints: numbers }, new Float32Array(15).fill(7));
    const document = project(point("a", null), pose("1", said.joints, said.roles));
    const { name, roles } = sayJoint(document, numbers[4]);
    const paired = pairPoint("a", name, roles)(document);
    const there = { joints: namedJoints("Hips", "LeftLeg", "LeftFoot", "Head") };
    expect([...pointJoints(paired, there)]).toEqual([3]);
    expect([...(exampleJoints(paired, there)[0] ?? [])].map((x) => (Number.isNaN(x) ? 0 : x))).toEqual([
      7, 7, 7, 0, 0, 0, 7, 7, 7, 7, 7, 7,
    ]);
    expect([...pointJoints(paired, { joints: numbers })]).toEqual([4]);
  });

  it("keep what the document means by a name that is another part in this motion", () => {
    const said = sayPose(project(), { joints: numbers }, new Float32Array(15));
    const document = project(point("a", "j4"), pose("1", said.joints, said.roles));
    const other = numberedJoints("j", "head", "hips", "left hand", "right foot");
    expect([...pointJoints(document, { joints: other })]).toEqual([0]);
    expect(sayJoint(document, other[0]).name).toBe("j4"); // the head, as the document calls it
    const again = sayPose(
      document,
      { joints: other },
      Float32Array.from({ length: 12 }, (_, i) => i),
    );
    expect(again.joints).toEqual({ j4: [0, 1, 2], j0: [3, 4, 5], "left hand": [6, 7, 8], j3: [9, 10, 11] });
    const both = pose("2", again.joints, again.roles)(document);
    const [, second] = exampleJoints(both, { joints: other });
    expect([...(second ?? [])]).toEqual(Array.from({ length: 12 }, (_, i) => i));
    expect(document.joints).toMatchObject({ j0: "hips", j1: "left foot" });
    expect(both.joints).toMatchObject({ j0: "hips", j1: "left foot", j3: "right foot" });
  });
});
