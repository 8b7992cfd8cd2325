// Motions in files of models and animations: each clip as the engine takes it.

import { AnimationClip, VectorKeyframeTrack } from "three";
import { afterAll, expect, it } from "vitest";

import { createNodeEngine } from "../../src/engine/node";
import type { Motion } from "../../src/engine/types";
import type { FoundClip } from "../../src/io/clips/found-clip";
import { clipNames, readClips } from "../../src/io/clips/read-clips";
import { paceOf } from "../../src/io/clips/sample-clip";
import { ModelError, type NamedFile } from "../../src/io/named-file";
import { sortFiles } from "../../src/io/sort-files";
import { BONE_NAMES, type Channel, gliding, keys, movingFbx, movingGlb } from "../support/clips";
import { TETRAHEDRON, textFile } from "../support/files";

const engine = await createNodeEngine();
afterAll(() => engine.close());

async function refusal(file: NamedFile): Promise<string> {
  const error: unknown = await readClips([file]).catch((caught: unknown) => caught);
  expect(error).toBeInstanceOf(ModelError);
  return (error as ModelError).message;
}

const staged = async ({ motion }: FoundClip): Promise<Motion> => engine.setMotion(motion.input);

/** Where a joint is, less where the hips were at first. */
function place({ joints, positions }: Motion, frame: number, name: string): number[] {
  const at = (f: number, j: number): number[] => [...positions.subarray(3 * (f * joints.length + j), 3 * (f * joints.length + j) + 3)];
  const first = at(0, 0);
  return at(
    frame,
    joints.findIndex((joint) => joint.name === name),
  ).map((x, k) => x - first[k]);
}

const near = (got: readonly number[], want: readonly number[]): void => {
  expect(got).toHaveLength(want.length);
  got.forEach((x, k) => expect(x).toBeCloseTo(want[k], 3));
};

it("a skeleton that is scaled keeps its names and its places, in metres", async () => {
  const [clip] = await readClips([movingGlb({ Glide: gliding(2) })]);
  expect([clip.name, clip.seconds, clip.motion.files]).toEqual(["Glide", 1, ["person.bvh"]]);
  const motion = await staged(clip);
  expect(motion.joints.map(({ name }) => name)).toEqual(BONE_NAMES);
  expect(motion.source).toMatchObject({ frames: 31, metresPerUnit: 1 });
  expect(motion.source.fps).toBeCloseTo(30, 5);
  expect([motion.told, motion.notes]).toEqual([true, []]);
  near(place(motion, 15, "Hips"), [0, 0, 1]);
  near(place(motion, 30, "LeftHand"), [0.71, 0.45, 2]);
});

it("turns, steps and cubics are what the file says", async () => {
  const half = Math.SQRT1_2;
  const channels: Channel[] = [
    { bone: "LeftArm", path: "rotation", times: [0, 1], values: [0, 0, 0, 1, 0, 0, half, half] },
    { bone: "RightArm", path: "rotation", times: [0, 0.5, 1], values: [0, 0, 0, 1, 0, 0, -half, half, 0, 0, 0, 1], interpolation: "STEP" },
    // From 95 to 95 with a tangent of 80 a second out of the first key: 10 higher in the middle.
    {
      bone: "Hips",
      path: "translation",
      times: [0, 1],
      values: [...[0, 0, 0, 0, 95, 0, 0, 80, 0], ...[0, 0, 0, 0, 95, 0, 0, 0, 0]],
      interpolation: "CUBICSPLINE",
    },
    { bone: "Head", path: "scale", times: keys(30, 30), values: keys(30, 30).flatMap(() => [1, 1, 1]) },
  ];
  const motion = await staged((await readClips([movingGlb({ A: channels })]))[0]);
  const [hips, arm] = [0.1, Math.cos(Math.PI / 4) * 0.53];
  near(place(motion, 15, "Hips"), [0, hips, 0]);
  near(place(motion, 15, "LeftHand"), [0.18 + arm, hips + 0.45 + arm, 0]);
  near(place(motion, 14, "RightHand").slice(0, 1), [-0.71]);
  near(place(motion, 15, "RightHand"), [-0.18, hips + 0.45 + 0.53, 0]);
  near(place(motion, 30, "RightHand").slice(0, 1), [-0.71]);
});

it("bones that change their length, and armatures that move, are where the file has them", async () => {
  const times = keys(30, 30);
  const grow: Channel = { bone: "LeftForeArm", path: "translation", times, values: times.flatMap((_, k) => [28 + k, 0, 0]) };
  const motion = await staged((await readClips([movingGlb({ A: [grow] })]))[0]);
  near(place(motion, 30, "LeftHand"), [1.01, 0.45, 0]);
  const bigger: Channel = { bone: "Spine", path: "scale", times, values: times.flatMap((_, k) => [1, 1, 1].map((x) => x + k / 30)) };
  near(place(await staged((await readClips([movingGlb({ A: [bigger] })]))[0]), 30, "Head"), [0, 1, 0]);
});

it("of several clips each has its name; poses and what moves no skeleton are left out", async () => {
  const file = movingGlb({
    "Armature|Walk": gliding(1),
    "Armature|Run/fast": gliding(2, 15),
    "Armature|T-Pose": [{ bone: "Hips", path: "translation", times: [0], values: [0, 95, 0] }],
  });
  const clips = await readClips([file]);
  expect(clips.map(({ name, seconds }) => [name, seconds])).toEqual([
    ["Walk", 1],
    ["Run/fast", 0.5],
  ]);
  expect(clips.map(({ motion }) => motion.files)).toEqual([["person Walk.bvh"], ["person Run-fast.bvh"]]);
  expect(clipNames([{ name: "A|Idle|Base" }, { name: "A|Run|Base" }, { name: "A|Run|Base" }])).toEqual(["Idle", "Run", "Run 2"]);
});

it("a VRM animation says which node is which part of a human, and needs no skin", async () => {
  const humanBones = { hips: { node: 1 }, head: { node: 3 }, leftFoot: { node: 12 }, rightFoot: { node: 15 } };
  const extensions = { VRMC_vrm_animation: { specVersion: "1.0", humanoid: { humanBones } } };
  const [clip] = await readClips([movingGlb({ "": gliding(1) }, { skin: false, extensions }, "nod.vrma")]);
  const { joints } = await staged(clip);
  expect(joints.map(({ name }) => name)).toEqual(expect.arrayContaining(["hips", "head", "leftFoot", "rightFoot", "Spine"]));
});

it.each([false, true])("an FBX moves as it says (as text: %s)", async (text) => {
  const clips = await readClips([movingFbx({ text })]);
  expect(clips.map(({ name, motion }) => [name, motion.files[0]])).toEqual([["mixamo.com", "walk.bvh"]]);
  const motion = await staged(clips[0]);
  expect(motion.joints[0].name).toBe("mixamorig:Hips");
  expect(motion.source.frames).toBe(31);
  near(place(motion, 30, "mixamorig:LeftHand"), [0.71, 0.45, 2]);
});

it("the pace is that of most keys, 24 to 120 a second", () => {
  const clip = (...spacings: number[]): AnimationClip =>
    new AnimationClip(
      "",
      -1,
      spacings.map((fps) => new VectorKeyframeTrack("a.position", keys(20, fps), new Array(63).fill(0))),
    );
  expect(paceOf(clip(30, 30, 60))).toBe(30);
  expect(paceOf(clip(12))).toBe(24);
  expect(paceOf(clip(10))).toBe(30);
  expect(paceOf(clip(240))).toBe(120);
  expect(paceOf(clip(29.97))).toBe(30);
});

it("says what is missing", async () => {
  expect(await refusal(movingGlb({}))).toBe("person.glb holds no motion.");
  expect(await refusal(textFile("a.obj", TETRAHEDRON))).toBe("a.obj holds no motion that we read.");
  const pose: Channel = { bone: "Hips", path: "translation", times: [0], values: [0, 95, 0] };
  expect(await refusal(movingGlb({ T: [pose] }))).toBe("person.glb holds a pose, but no motion.");
  const twice = { ...pose, values: [...pose.values, ...pose.values] };
  expect(await refusal(movingGlb({ T: [twice] }))).toBe("person.glb holds motion, but of no skeleton: cameras, colours or shape keys.");
});

it("a file without a mesh is a motion, one with both is a model that moves, and another's motion where there is a model", async () => {
  const [bare, both, model] = [
    movingGlb({ A: gliding(1) }),
    movingGlb({ A: gliding(1) }, { mesh: true }, "both.glb"),
    textFile("a.obj", TETRAHEDRON),
  ];
  const sorted = async (files: NamedFile[], motionsOnly = false) => {
    const { models, moves, clips, problems } = await sortFiles(files, { motionsOnly });
    return [models.map(({ name }) => name), moves, clips.map(({ name }) => name), problems];
  };
  expect(await sorted([bare])).toEqual([[], false, ["person.glb"], []]);
  expect(await sorted([both])).toEqual([["both.glb"], true, [], []]);
  expect(await sorted([both], true)).toEqual([[], false, ["both.glb"], []]);
  expect(await sorted([both, bare])).toEqual([["both.glb"], true, ["person.glb"], []]);
  expect(await sorted([both, model])).toEqual([["a.obj"], false, ["both.glb"], []]);
  for (const text of [false, true]) {
    expect(await sorted([movingFbx({ text })])).toEqual([[], false, ["walk.fbx"], []]);
    expect(await sorted([movingFbx({ text, mesh: true })])).toEqual([["walk.fbx"], true, [], []]);
  }
});
