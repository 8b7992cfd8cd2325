// Motions, retargeting and frames through the real core, against the golden cases where there are any.

import { afterEach, beforeEach, describe, expect, test } from "vitest";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine, Frame, Motion, RetargetInput, ShapedFrame } from "../../src/engine/types";
import { golden, hasShared, nod, restControls, setUpPost, sharedText, spot, spotControls, spotJoints, walk02 } from "./engine-support";

let engine: Engine;
beforeEach(async () => {
  engine = await createNodeEngine();
});
afterEach(() => engine.close());

const settings = { examples: [], smoothness: 0.3, volume: 1, groundContact: true, inPlace: false };

type Points = number[][];
interface GoldenClip {
  frames: number[];
  names: string[];
  parents: number[];
  pos: Points[];
  yaw: number[];
  local: Points[];
}

const point = (array: Float32Array, index: number) => [...array.subarray(3 * index, 3 * index + 3)];

/** All joints of golden frames that fall on 30 fps, up to where the world's origin is. */
function comparePositions(motion: Motion, clip: GoldenClip, metresPerUnit: number, tolerance: number): void {
  const count = clip.names.length;
  let origin: number[] | null = null;
  let compared = 0;
  clip.frames.forEach((source, i) => {
    if (source % 4 !== 0) return;
    for (let j = 0; j < count; ++j) {
      const joint = motion.joints.findIndex(({ name }) => name === clip.names[j]);
      expect(joint, clip.names[j]).toBeGreaterThanOrEqual(0);
      const found = point(motion.positions, (source / 4) * motion.joints.length + joint);
      const expected = (clip.pos[i]?.[j] ?? []).map((value) => value * metresPerUnit);
      origin ??= expected.map((value, k) => value - (found[k] ?? NaN));
      found.forEach((value, k) => {
        expect(Math.abs(value + (origin?.[k] ?? NaN) - (expected[k] ?? NaN))).toBeLessThan(tolerance);
      });
      ++compared;
    }
  });
  expect(compared).toBeGreaterThanOrEqual(3 * count);
}

describe.skipIf(!hasShared)("a motion file", () => {
  test("in ASF and AMC has the golden joint positions", async () => {
    const { asf } = golden<{ asf: GoldenClip & { frames_total: number } }>("motion");
    const motion = await engine.setMotion(walk02());
    expect(motion.source).toMatchObject({ frames: asf.frames_total, fps: 120 });
    expect(motion.frames).toBe(86);
    expect(motion.joints.map(({ name }) => name).slice(0, 3)).toEqual(asf.names.slice(0, 3));
    comparePositions(motion, asf, 1, 1e-5);
    const frame = asf.frames.indexOf(100);
    expect(motion.yaw[25]).toBeCloseTo(asf.yaw[frame] ?? NaN, 5);
    for (let j = 0; j < asf.names.length; ++j) {
      point(motion.local, 25 * motion.joints.length + j).forEach((value, k) => {
        expect(Math.abs(value - (asf.local[frame]?.[j]?.[k] ?? NaN))).toBeLessThan(1e-5);
      });
    }
    expect(Math.min(...motion.positions.filter((_, i) => i % 3 === 1))).toBeCloseTo(0, 6);
  });

  test("in BVH too, brought to metres", async () => {
    const { bvh } = golden<{ bvh: GoldenClip }>("motion");
    const motion = await engine.setMotion({ name: "131_03.bvh", text: sharedText("motions/131_03.bvh") });
    expect(motion.source.frames).toBe(1102);
    expect(motion.source.metresPerUnit).toBeCloseTo(0.0254 / 0.45, 6);
    comparePositions(motion, bvh, 0.0254 / 0.45, 2e-4);
  });

  test("with a walk in it gives the golden contacts to the paired controls", async () => {
    const mesh = spot();
    const controls = spotControls(mesh);
    await engine.setMesh({ ...mesh, solve: "solid" }); // its ears hang as arms do: more than its own surface can stand
    await engine.setControls(controls);
    const { joints } = await engine.setMotion(walk02());
    const pairs = Int32Array.from(spotJoints, (name) => joints.findIndex((joint) => joint.name === name));
    const performance = await engine.retarget({ ...settings, pairs });
    const { motions } = golden<{
      motions: { subject: number; trial: number; left_contact_runs: [number, number][]; right_contact_runs: [number, number][] }[];
    }>("contacts");
    const walk = motions.find(({ subject, trial }) => subject === 2 && trial === 1);
    const feet = [
      [1, walk?.left_contact_runs],
      [0, walk?.right_contact_runs],
    ] as const;
    for (const [control, runs] of feet) {
      for (let f = 0; f < performance.frames; ++f) {
        const near = runs?.some((run) => run.some((end) => Math.abs(4 * f - end) <= 8));
        if (near) continue;
        const stands = runs?.some(([begin, end]) => 4 * f >= begin && 4 * f < end);
        expect(performance.contacts[f * 8 + control], `control ${control}, frame ${f}`).toBe(stands ? 1 : 0);
      }
    }
    expect(performance.flights).toEqual([]);
    expect(performance.slip.before).toBeGreaterThan(0.01);
    expect(performance.slip.after).toBeLessThan(1e-6);

    const order = [40, 41, 0];
    const made: [number, Frame][] = [];
    await engine.frames(order, (frame, result) => made.push([frame, result]));
    expect(made.map(([frame]) => frame)).toEqual(order);
    for (const [, { positions, volumeRatio, root }] of made) {
      expect(Math.abs(Math.min(...positions.filter((_, i) => i % 3 === 1)))).toBeLessThan(1e-5);
      expect(volumeRatio).toBeGreaterThan(0.85);
      expect(volumeRatio).toBeLessThan(1.15);
      expect(root.every(Number.isFinite)).toBe(true);
    }
    const [first, second] = [made[0]?.[1].positions, made[1]?.[1].positions];
    controls.forEach(({ vertex }, c) => {
      if (!performance.contacts[40 * 8 + c] || !performance.contacts[41 * 8 + c]) return;
      expect(first?.[3 * vertex]).toBeCloseTo(second?.[3 * vertex] ?? NaN, 5);
      expect(first?.[3 * vertex + 2]).toBeCloseTo(second?.[3 * vertex + 2] ?? NaN, 5);
    });
  });
});

describe("retargeting", () => {
  test("gives each example's controls at the example's frame", async () => {
    await setUpPost(engine);
    const motion = await engine.setMotion(nod());
    const count = motion.joints.length;
    const frames = [0, 8, 24, 40];
    const examples = frames.map((frame, n) => ({
      joints: motion.local.slice(3 * count * frame, 3 * count * (frame + 1)),
      controls: Float32Array.of(0.02 * n, 0, 0, 0.1 * n, 1.6 - 0.1 * n, 0.05 * n * n),
    }));
    const input: RetargetInput = { ...settings, pairs: Int32Array.of(-1, 1), examples, smoothness: 0, groundContact: false };
    const performance = await engine.retarget(input);
    frames.forEach((frame, n) => {
      performance.controls.slice(6 * frame, 6 * frame + 6).forEach((value, k) => {
        expect(Math.abs(value - (examples[n]?.controls[k] ?? NaN))).toBeLessThan(1e-4);
      });
    });
  });

  test("moves a model that was never shown anything", async () => {
    const mesh = await setUpPost(engine);
    const performance = await engine.retarget({ ...settings, pairs: Int32Array.of(-1, 1) });
    expect(performance.frames).toBe(60);
    const heads = Array.from({ length: 60 }, (_, f) => performance.controls[6 * f + 5] ?? NaN);
    expect(Math.max(...heads) - Math.min(...heads)).toBeGreaterThan(0.05);
    expect(mesh.positions.length).toBe(3 * 74);
  });

  test("knows unknown joints by what it does know", async () => {
    await setUpPost(engine);
    const motion = await engine.setMotion(nod());
    const joints = motion.local.slice(0, 3 * motion.joints.length);
    joints.fill(NaN, 6);
    const input = { ...settings, pairs: Int32Array.of(-1, 1), examples: [{ joints, controls: Float32Array.of(0, 0, 0, 0, 1.6, 0) }] };
    const performance = await engine.retarget(input);
    expect(performance.controls.every(Number.isFinite)).toBe(true);
  });

  test("of minutes shows its first frame, nearly as it will be, before all of it is solved", async () => {
    await setUpPost(engine, 2000);
    const looks: ShapedFrame[] = [];
    const input = { pairs: Int32Array.of(0, 1), examples: [], smoothness: 0.3, volume: 1, groundContact: true, inPlace: false };
    const { frames } = await engine.retarget(input, {}, (frame) => looks.push(frame));
    expect(frames).toBe(2000);
    expect(looks).toHaveLength(1);
    await engine.shapes([0], (_, { shape }) => {
      expect(Math.max(...shape.map((x, k) => Math.abs(x - looks[0].shape[k])))).toBeLessThan(0.05);
    });
  });

  test("leaves the travel out in place", async () => {
    await setUpPost(engine);
    const performance = await engine.retarget({ ...settings, pairs: Int32Array.of(-1, 1), inPlace: true });
    expect(performance.travel.every((value) => value === 0)).toBe(true);
  });
});

describe("a frame", () => {
  test("is the same bits alone, in any order, and after drags", async () => {
    const mesh = await setUpPost(engine);
    await engine.retarget({ ...settings, pairs: Int32Array.of(-1, 1) });
    const played = new Map<number, Frame>();
    await engine.frames(
      Array.from({ length: 20 }, (_, f) => f),
      (frame, result) => played.set(frame, result),
    );
    const targets = restControls(mesh, [
      { vertex: 72, radius: 0 },
      { vertex: 73, radius: 0 },
    ]).map((value) => value * 1.2);
    await engine.drag(targets, { volume: 3 });
    await engine.frames([19, 3, 11], (frame, result) => {
      expect(result.positions).toEqual(played.get(frame)?.positions);
      expect(result.root).toEqual(played.get(frame)?.root);
    });
  });

  test("does not disturb the drag that goes on", async () => {
    const mesh = await setUpPost(engine);
    await engine.retarget({ ...settings, pairs: Int32Array.of(-1, 1) });
    const targets = restControls(mesh, [
      { vertex: 72, radius: 0 },
      { vertex: 73, radius: 0 },
    ]);
    targets[3] = 0.4;
    await engine.drag(targets, { volume: 1, restart: true });
    const straight = await engine.drag(targets, { volume: 1 });
    await engine.drag(targets, { volume: 1, restart: true });
    await engine.frames([5], () => {});
    const after = await engine.drag(targets, { volume: 1 });
    expect(after.shape).toEqual(straight.shape);
  });
});
