// What is said of a motion, through the real core: how it is cut, mirrored and looped, and what its file is.

import { afterAll, beforeAll, describe, expect, test } from "vitest";

import { clipOf, setContacts, setFlights, setPin } from "../../src/document/clips";
import { correctFile, editMotion, type FileEdits, type MotionEdits } from "../../src/document/edit-clip";
import { parseProject, serializeProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine, Motion } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { roleOf } from "../../src/skeleton/pair-joints";
import { bake } from "../../src/sync/bake";
import { bestLoop } from "../../src/sync/best-loop";
import { Binding } from "../../src/sync/binding";
import { toLocalAll } from "../../src/sync/placement";
import { detailed } from "../../src/sync/details";
import { motionEdits, retargetInput } from "../../src/sync/translate";
import { asset } from "../support/files";

const cactus = parseProject(new TextDecoder().decode(asset("cactus/project.json").bytes), "project.json").document;
const dancing = (file: string): ProjectDocument => ({ ...cactus, motion: { files: [file] } });
const textOf = (file: string): string => new TextDecoder().decode(asset(`motions/${file}`).bytes);

let engine: Engine;
beforeAll(async () => {
  engine = await createNodeEngine();
});
afterAll(() => engine.close());

const read = (document: ProjectDocument, text = textOf(document.motion.files[0])): Promise<Motion> =>
  engine.setMotion({ name: document.motion.files[0], text, edits: motionEdits(document) });
const walk = dancing("walk.bvh");
const edited = (edits: MotionEdits): Promise<Motion> => read(editMotion(edits)(walk));
const corrected = (edits: FileEdits, text?: string): Promise<Motion> => read(correctFile(edits)(walk), text);

const place = ({ joints }: Motion, frames: Float32Array, frame: number, name: string): number[] => {
  const at = 3 * (frame * joints.length + joints.findIndex((joint) => joint.name === name));
  return [...frames.subarray(at, at + 3)];
};
const named = ({ joints }: Motion, role: string): string => joints.find((joint) => roleOf(joint) === role)?.name ?? "";
const close = (a: ArrayLike<number>, b: ArrayLike<number>): number => Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));

describe("a cut", () => {
  test("is these frames of the whole motion, which begin in the middle of the stage", async () => {
    const whole = await read(walk);
    const cut = await edited({ cut: [20, 60] });
    const size = 3 * whole.joints.length;
    expect([cut.frames, cut.takeFrames]).toEqual([41, whole.frames]);
    expect(cut.local).toEqual(whole.local.slice(20 * size, 61 * size));
    expect(cut.stands.left).toEqual(whole.stands.left.slice(20, 61));
    expect(cut.stands.right).toEqual(whole.stands.right.slice(20, 61));
    expect([cut.positions[0], cut.positions[2]]).toEqual([0, 0]);
    expect(Math.hypot(whole.positions[20 * size], whole.positions[20 * size + 2])).toBeGreaterThan(0.3);
    const beyond = await edited({ cut: [20, 1000] });
    expect(beyond.frames).toBe(whole.frames - 20);
  });

  test("leaves pins, contacts and flights where they are in the motion", async () => {
    const [{ id }] = walk.points;
    const cut = editMotion({ cut: [20, 60] })(walk);
    const said = [
      setPin({ id: "n1", point: id, frame: 5, kind: "place", position: [0, 1, 0] }),
      setContacts(id, [[-15, 8]]),
      setFlights([[10, 14]]),
    ].reduce((document, command) => command(document), cut);
    expect(said.clips?.["walk.bvh"]).toMatchObject({ pins: [{ frame: 25 }], contacts: { [id]: [[5, 28]] }, flights: [[30, 34]] });
    expect(parseProject(serializeProject(said), "project.json").document).toEqual(said);
    const model = await readModel([asset("cactus/cactus.glb")]);
    const asks = (document: ProjectDocument, frames: number) => {
      const motion = { joints: [], frames };
      const { constraints = [], contacts = [], flights } = detailed(retargetInput(model, document, motion), model, document, motion);
      return [constraints.map(({ frame }) => frame), contacts.map(({ runs }) => runs), flights];
    };
    expect(asks(said, 41)).toEqual([[5], [[[0, 8]]], [[10, 14]]]);
    expect(asks(editMotion({ cut: undefined })(said), 99)).toEqual([[25], [[[5, 28]]], [[30, 34]]]);
    expect(asks(editMotion({ cut: [31, 60] })(said), 30)).toEqual([[], [[]], []]);
    expect(clipOf(said)).toBe(clipOf(said)); // a dance that was solved stays solved
  });

  test("is refused where it ends before it begins", () => {
    const wrong = serializeProject({ ...walk, clips: { "walk.bvh": { cut: [9, 3] } } });
    expect(() => parseProject(wrong, "project.json")).toThrow(
      'project.json: clips["walk.bvh"].cut goes from 9 to 3: its first frame should come before its last.',
    );
  });
});

test("a mirrored motion has the left foot do what the right one did, and goes the other way", async () => {
  const kick = dancing("kick.bvh");
  const whole = await read(kick);
  const mirrored = await read(editMotion({ mirror: true })(kick));
  const [left, right] = [named(whole, "left foot"), named(whole, "right foot")];
  for (const [one, other] of [
    [left, right],
    [named(whole, "left hand"), named(whole, "right hand")],
    [named(whole, "head"), named(whole, "head")],
  ])
    for (const frame of [0, 30, 60]) {
      const [x, y, z] = place(whole, whole.local, frame, one);
      expect(close(place(mirrored, mirrored.local, frame, other), [-x, y, z])).toBeLessThan(1e-5);
    }
  expect(mirrored.stands.left).toEqual(whole.stands.right);
  expect(mirrored.stands.left).not.toEqual(whole.stands.left);
  expect(
    close(
      mirrored.yaw,
      whole.yaw.map((turn) => -turn),
    ),
  ).toBeLessThan(1e-5);
});

describe("a loop", () => {
  test("is suggested where a walk comes round, also near a cut, and not where there is too little", async () => {
    const whole = await read(walk);
    const best = bestLoop(whole);
    expect(best?.gap).toBeLessThan(0.01);
    const [a, b] = best?.cut ?? [0, 0];
    const size = 3 * whole.joints.length;
    const pose = (frame: number): Float32Array => whole.local.subarray(frame * size, (frame + 1) * size);
    expect(close(pose(a), pose(b))).toBeLessThan(0.01);
    const near = bestLoop(whole, [20, 80])?.cut ?? [0, 0];
    expect(Math.abs(near[0] - 20)).toBeLessThanOrEqual(20);
    expect(Math.abs(near[1] - 80)).toBeLessThanOrEqual(20);
    expect(bestLoop({ ...whole, frames: 10 })).toBeNull();
  });

  test("of a long motion is found among all of its frames", async () => {
    const whole = await read(walk);
    const { joints } = whole;
    const [frames, period] = [1300, 731];
    const local = new Float32Array(frames * 3 * joints.length);
    for (let f = 0; f < frames; f++)
      for (let j = 0; j < joints.length; j++) {
        const phase = (2 * Math.PI * f) / period;
        local.set([Math.sin(phase + j), Math.cos(phase + 2 * j), 0], 3 * (f * joints.length + j));
      }
    const stands = { left: new Uint8Array(frames), right: new Uint8Array(frames) };
    const long = { ...whole, frames, local, stands, positions: new Float32Array(local.length), yaw: new Float32Array(frames) };
    const best = bestLoop(long);
    expect((best?.cut[1] ?? 0) - (best?.cut[0] ?? 0)).toBe(period);
  });

  // Two that come round by themselves, and one cut anywhere.
  test.each([
    ["walk.bvh", [8, 74]],
    ["hop.bvh", undefined],
    ["disco.bvh", [20, 77]],
  ] as const)("of %s ends exactly as it begins, goes on from where it is, and its feet stand over the seam", async (file, cut) => {
    const document = editMotion({ loop: true, ...(cut && { cut }) })(dancing(file));
    const model = await readModel([asset("cactus/cactus.glb")]);
    const { motion, frames, performance } = await bake(new Binding(engine), document, {
      model,
      motion: { name: file, text: textOf(file) },
    });
    const last = motion.frames - 1;
    const pose = (frame: number): Float32Array =>
      motion.local.subarray(3 * frame * motion.joints.length, 3 * (frame + 1) * motion.joints.length);
    expect(close(pose(last), pose(0))).toBeLessThan(1e-5);
    const shape = (frame: number): Float32Array => {
      const [x, , z, yaw] = frames[frame].root;
      return toLocalAll(frames[frame].positions, [x, 0, z, yaw]);
    };
    expect(close(shape(last), shape(0))).toBeLessThan(1e-4);
    // Nowhere does it go much faster than elsewhere.
    const step = (f: number): number => close(shape(f), shape(f - 1));
    const steps = Array.from({ length: last }, (_, f) => step(f + 1));
    expect(Math.max(...steps.slice(-8))).toBeLessThan(1.5 * Math.max(...steps.slice(0, -8)));
    expect(performance.slip.after).toBeLessThan(0.01);
  });
});

describe("a file that was read wrongly", () => {
  test("has another unit, rate and heading where these are said, and nothing else changes", async () => {
    const found = await read(walk);
    const small = await corrected({ metresPerUnit: 0.5 * found.source.metresPerUnit });
    expect(small.source.metresPerUnit).toBeCloseTo(0.5 * found.source.metresPerUnit, 9);
    expect(
      close(
        small.local,
        found.local.map((x) => 0.5 * x),
      ),
    ).toBeLessThan(1e-5);
    const slow = await corrected({ fps: found.source.fps / 2 });
    expect(slow.frames).toBe(2 * found.frames - 1);
    expect(slow.source.fps).toBe(found.source.fps); // of the file
    const turned = await corrected({ turn: 90 });
    expect(close(turned.local, found.local)).toBeLessThan(1e-5);
    expect(
      close(
        turned.yaw,
        found.yaw.map((yaw) => yaw + Math.PI / 2),
      ),
    ).toBeLessThan(1e-5);
    const [x, , z] = place(found, found.positions, found.frames - 1, found.joints[0].name);
    const [tx, , tz] = place(turned, turned.positions, found.frames - 1, found.joints[0].name);
    expect(close([tx, tz], [z, -x])).toBeLessThan(1e-5);
  });

  test("stands on another axis", async () => {
    const lying = await corrected({ up: "+z" });
    const head = place(lying, lying.local, 10, named(lying, "head"));
    const upright = await read(walk);
    const [x, y, z] = place(upright, upright.positions, 10, named(upright, "head"));
    expect(Math.abs(head[1])).toBeLessThan(0.5 * y);
    expect(Math.hypot(x, z)).toBeGreaterThan(0);
    expect(await corrected({ up: "+y" })).toMatchObject({ frames: upright.frames, local: upright.local });
  });

  test("has other hands and feet, and other hips, where these are said", async () => {
    const found = await read(walk);
    const [left, right] = [named(found, "left foot"), named(found, "right foot")];
    const swapped = await corrected({ joints: { "left foot": right, "right foot": left } });
    expect([named(swapped, "left foot"), named(swapped, "right foot")]).toEqual([right, left]);
    expect(named(swapped, "left lower leg")).toBe(named(found, "right lower leg"));
    expect(swapped.stands.left).toEqual(found.stands.right);
    const chest = named(found, "chest");
    const from = await corrected({ joints: { hips: chest } });
    expect(from.joints[0].name).toBe(chest);
    expect(from.joints.length).toBeLessThan(found.joints.length);
    expect(await corrected({ joints: { head: "nobody" } })).toMatchObject({ joints: found.joints });
  });

  test("keeps what was said of its frames when they go at another rate", () => {
    const [{ id }] = walk.points;
    const said = [
      editMotion({ cut: [20, 60] }),
      setPin({ id: "n1", point: id, frame: 10, kind: "still" }),
      setContacts(id, [[0, 10]]),
      correctFile({ fps: 60 }, 2),
    ].reduce((document, command) => command(document), walk);
    expect(said.clips?.["walk.bvh"]).toEqual({
      file: { fps: 60 },
      cut: [10, 30],
      pins: [{ id: "n1", point: id, frame: 15, kind: "still" }],
      contacts: { [id]: [[10, 15]] },
    });
    expect(correctFile({ fps: undefined }, 0.5)(said).clips?.["walk.bvh"]).toMatchObject({ cut: [20, 60], pins: [{ frame: 30 }] });
  });
});
