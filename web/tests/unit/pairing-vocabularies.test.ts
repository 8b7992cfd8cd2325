// One walk under many spellings of its joints: the same pairs and the same dance.

import { afterAll, beforeAll, describe, expect, it } from "vitest";

import { mirroredFrame } from "../../src/app/mirrored";
import { parseProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine, Motion, Performance } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { describeJoints } from "../../src/skeleton/pair-joints";
import { guessProject } from "../../src/sync/guess";
import { exampleJoints, pairingFault, pairingNotes, pointJoints } from "../../src/sync/pairing";
import { controlInputs, meshInput, retargetInput } from "../../src/sync/translate";
import type { SolverModel } from "../../src/sync/placement";
import { buildBodyPlan } from "../../src/viewport/body-plan";
import { asset } from "../support/files";
import { SNAKE } from "../support/joints";
import { golden, hasShared, sharedText, walk02 } from "./engine-support";

const WALK = new TextDecoder().decode(asset("motions/walk.bvh").bytes);

const side = (name: string): [role: string, joint: string][] => {
  const [word, other] = [name, name.toLowerCase()];
  return [
    [`${other} shoulder`, `${word}Shoulder`],
    [`${other} upper_arm`, `${word}Arm`],
    [`${other} lower_arm`, `${word}ForeArm`],
    [`${other} hand`, `${word}Hand`],
  ];
};
const leg = (name: string): [role: string, joint: string][] => {
  const other = name.toLowerCase();
  return [
    [`${other} upper_leg`, `${name}UpLeg`],
    [`${other} lower_leg`, `${name}Leg`],
    [`${other} foot`, `${name}Foot`],
    [`${other} toe`, `${name}Toe`],
  ];
};

/** The joints of the walk, in the order of the lists of names. */
const ROLES: readonly [role: string, joint: string][] = [
  ["hips", "Hips"],
  ["spine", "Spine"],
  ["chest", "Spine2"],
  ["neck", "Neck"],
  ["head", "Head"],
  ...side("Left"),
  ...side("Right"),
  ...leg("Left"),
  ...leg("Right"),
];

interface Golden {
  skeletons: { vocabulary: string; joints: [name: string, side: string, part: string, label: string][] }[];
}

/** By the joint's own name in the walk, what a vocabulary calls it. */
type Names = ReadonlyMap<string, string>;

/** The first joint of each role; a skeleton without a chest has the last joint of its spine there. */
function namesOf(joints: Golden["skeletons"][number]["joints"]): Names {
  const of = (role: string): string | undefined =>
    joints.find(([, on, part]) => (on === "none" ? part : `${on} ${part}`) === role)?.[0] ??
    (role === "chest"
      ? joints
          .filter(([, , part]) => part === "spine")
          .slice(1)
          .at(-1)?.[0]
      : undefined);
  return new Map(ROLES.flatMap(([role, joint]) => (of(role) === undefined ? [] : [[joint, of(role) ?? ""]])));
}

// The names of Acclaim's joints mean the far ends of bones, but in a BVH, which has ends, their beginnings.
const { skeletons } = golden<Golden>("joint-names");
const vocabularies = skeletons
  .filter(({ vocabulary }) => vocabulary !== "CMU Acclaim")
  .map(({ vocabulary, joints }): [string, Names] => [
    vocabulary,
    vocabulary === "numbers" || vocabulary === "letters" ? new Map(joints.map(([name], n) => [ROLES[n][1], name])) : namesOf(joints),
  ]);
if (hasShared) {
  const { names } = JSON.parse(sharedText("vocabularies.json")) as { names: Record<string, string[]> };
  for (const [vocabulary, list] of Object.entries(names))
    vocabularies.push([`${vocabulary}, as judges have it`, new Map(list.map((name, n) => [ROLES[n][1], name]))]);
}

/** The walk with its joints renamed; what a vocabulary does not name keeps its name between what all the others share. */
function renamed(names: Names): string {
  const all = [...names.values()];
  const shared = (at: (name: string, n: number) => string): number => {
    let n = 0;
    while (all.every((name) => n < name.length && at(name, n) === at(all[0], n))) n++;
    return n;
  };
  const before = all[0].slice(
    0,
    shared((name, n) => name[n]),
  );
  const after = shared((name, n) => name[name.length - 1 - n]);
  const suffix = after > 0 ? all[0].slice(-after) : "";
  return WALK.replace(/(ROOT|JOINT) (\S+)/g, (_, kind: string, name: string) => `${kind} ${names.get(name) ?? before + name + suffix}`);
}

let engine: Engine;
beforeAll(async () => void (engine = await createNodeEngine()));
afterAll(() => engine.close());

const read = (text: string): Promise<Motion> => engine.setMotion({ name: "walk.bvh", text });

async function dance(model: SolverModel, document: ProjectDocument, motion: Motion): Promise<Performance> {
  await engine.setMesh(meshInput(model, document.mesh));
  await engine.setControls(controlInputs(model, document));
  return engine.retarget(retargetInput(model, document, motion));
}

describe("a bare model", async () => {
  const model = await readModel([asset("cactus/cactus.glb")]);
  let guessed: (motion: Motion) => ProjectDocument;
  let pairs: Int32Array;
  let own: Performance;
  beforeAll(async () => {
    const said = await engine.analyseShape(model);
    guessed = (motion) => guessProject("cactus", "cactus.glb", ["walk.bvh"], model, said, motion.joints);
    const motion = await read(WALK);
    pairs = pointJoints(guessed(motion), motion);
    expect([...pairs].filter((joint) => joint >= 0).map((joint) => motion.joints[joint].name)).toEqual(
      expect.arrayContaining(["Head", "LeftHand", "RightHand", "LeftFoot", "RightFoot"]),
    );
    own = await dance(model, guessed(motion), motion);
  });

  // Which joint of a spine is the chest, names say: one may be the neighbour of another's.
  const limbs = (document: ProjectDocument, joints: ArrayLike<number>): number[] =>
    document.points.flatMap(({ id }, c) => (id === "chest" ? [] : [joints[c]]));
  let exactly = 0;

  it.each(vocabularies)("dances the same walk in the spelling of %s", async (_, names) => {
    const motion = await read(renamed(names));
    const document = guessed(motion);
    expect(motion.told).toBe(true);
    expect(limbs(document, pointJoints(document, motion))).toEqual(limbs(document, pairs));
    expect(pairingNotes(document, motion)).toEqual([]);
    const { controls } = await dance(model, document, motion);
    const apart = Math.max(...controls.map((x, k) => Math.abs(x - own.controls[k])));
    expect(apart).toBeLessThan(0.15); // metres: where neck and chest lie, a starter's lean depends on
    exactly += apart === 0 ? 1 : 0;
    // What it says of its joints leads back to the first walk as well.
    expect(limbs(document, pointJoints(document, await read(WALK)))).toEqual(limbs(document, pairs));
  });

  it("dances exactly the same in nearly all", () => expect(exactly).toBeGreaterThanOrEqual(vocabularies.length - 8));
});

describe("a project with poses", async () => {
  const { document } = parseProject(new TextDecoder().decode(asset("characters/dinosaur/project.json").bytes), "project.json");
  const model = await readModel([asset(`characters/dinosaur/${document.mesh.file}`)]);
  let own: Performance;
  let pairs: Int32Array;
  let mirrored: (number | null)[];
  beforeAll(async () => {
    const motion = await read(WALK);
    pairs = pointJoints(document, motion);
    own = await dance(model, document, motion);
    mirrored = document.examples.map((example) => mirroredFrame(example, document, motion));
  });

  it.each(vocabularies)("keeps its poses and dances the same walk in the spelling of %s", async (_, names) => {
    const motion = await read(renamed(names));
    expect([...pointJoints(document, motion)]).toEqual([...pairs]);
    expect(exampleJoints(document, motion).filter((joints) => joints === null)).toEqual([]);
    expect(pairingNotes(document, motion)).toEqual([]);
    const { controls } = await dance(model, document, motion);
    expect(controls).toEqual(own.controls);
    expect(document.examples.map((example) => mirroredFrame(example, document, motion))).toEqual(mirrored);
  });
});

it("a mannequin of numbered joints is the one of the named", async () => {
  const plan = (motion: Motion) =>
    buildBodyPlan({ joints: describeJoints(motion.joints), parents: Int32Array.from(motion.joints, ({ parent }) => parent) });
  const own = plan(await read(WALK));
  expect(own.torso).not.toBeNull();
  const numbers = await read(
    WALK.replace(
      /(ROOT|JOINT) \S+/g,
      (() =>
        (
          (n) => (_: string, kind: string) =>
            `${kind} joint_${n++}`
        )(0))(),
    ),
  );
  expect(plan(numbers)).toEqual(own);
  expect(describeJoints(numbers.joints).map(({ label }) => label)).toEqual(
    expect.arrayContaining(["Head", "Left elbow", "Right foot", "Hips"]),
  );
});

it("a motion of no body is told to be none", async () => {
  const motion = await read(SNAKE);
  expect(motion.told).toBe(false);
  const { document } = parseProject(new TextDecoder().decode(asset("cactus/project.json").bytes), "project.json");
  expect(pairingFault(document, motion)).toMatch(/^We cannot tell which joints of \S+ are/);
});

describe.skipIf(!hasShared)("CMU's skeleton (skipped where ../shared/data is absent)", () => {
  it("has the joint that the solver uses for each of our points, called as people call it", async () => {
    const motion = await engine.setMotion(walk02());
    const { document } = parseProject(new TextDecoder().decode(asset("cactus/project.json").bytes), "project.json");
    const moved = [...pointJoints(document, motion)];
    const labels = describeJoints(motion.joints).map(({ label }) => label);
    expect(document.points.map(({ joint }, c) => [joint, labels[moved[c]]])).toEqual([
      ["Head", "Head"],
      ["RightHand", expect.stringMatching(/^Right hand/)],
      ["LeftHand", expect.stringMatching(/^Left hand/)],
      ["RightFoot", "Right foot"],
      ["LeftFoot", "Left foot"],
      ["Hips", "Hips"],
    ]);
    expect(motion.joints[moved[0]].name).toBe("head");
    expect(labels).toContain("Left elbow"); // lhumerus
    expect(new Set(labels).size).toBe(labels.length);
  });
});
