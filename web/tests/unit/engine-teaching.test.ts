// What the user asks of a retarget beside its examples, and what the engine says of them.

import { afterEach, beforeEach, describe, expect, test } from "vitest";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine, EngineError, ExampleInput, Motion, RetargetInput } from "../../src/engine/types";
import { hasShared, restControls, setUpPost, spot, spotControls, spotJoints, walk02 } from "./engine-support";

let engine: Engine;
beforeEach(async () => {
  engine = await createNodeEngine();
});
afterEach(() => engine.close());

const settings = { examples: [], smoothness: 0.3, volume: 1, groundContact: true, inPlace: false };
const at = (controls: Float32Array, count: number, frame: number, control: number) => [
  ...controls.subarray(3 * (frame * count + control), 3 * (frame * count + control) + 3),
];

type Three = [number, number, number];
const every = { x: true, y: true, z: true };
const place = (control: number, frame: number, value: Three) => ({ control, frame, fromControl: -1, fromFrame: 0, value, ...every });
const move = (control: number, frame: number, value: Three) => ({
  ...place(control, frame, value),
  fromControl: control,
  fromFrame: frame - 1,
});

describe("constraints", () => {
  const input: RetargetInput = { ...settings, pairs: Int32Array.of(0, 1) };

  test("are met, and the rest of the track hardly moves", async () => {
    await setUpPost(engine);
    const plain = await engine.retarget(input);
    const performance = await engine.retarget({ ...input, constraints: [move(1, 31, [0, 0, 0]), place(1, 30, [0.3, 1.7, 0.1])] });
    at(performance.controls, 2, 30, 1).forEach((x, k) => expect(x).toBeCloseTo([0.3, 1.7, 0.1][k] ?? NaN, 5));
    expect(performance.missed.worst).toHaveLength(2);
    expect(Math.max(...performance.missed.worst)).toBeLessThan(1e-6);
    at(performance.controls, 2, 5, 1).forEach((x, k) => expect(x).toBeCloseTo(at(plain.controls, 2, 5, 1)[k] ?? NaN, 2));
    expect(plain.missed.worst).toHaveLength(0);
  });

  test("say where one control is, seen from another, on some axes only", async () => {
    await setUpPost(engine);
    const plain = await engine.retarget(input);
    const level = { ...place(1, 30, [0, 0.25, 0]), fromControl: 0, fromFrame: 30, x: false, z: false };
    const { controls, missed } = await engine.retarget({ ...input, constraints: [level] });
    expect(at(plain.controls, 2, 30, 1)[1] - at(plain.controls, 2, 30, 0)[1]).not.toBeCloseTo(0.25, 2);
    expect(at(controls, 2, 30, 1)[1] - at(controls, 2, 30, 0)[1]).toBeCloseTo(0.25, 5);
    expect(missed.worst[0]).toBeLessThan(1e-6);
    expect(at(controls, 2, 30, 1)[0]).toBeCloseTo(at(plain.controls, 2, 30, 1)[0], 5);
  });

  test("that contradict each other meet half way and say by how much", async () => {
    await setUpPost(engine);
    const { controls, missed } = await engine.retarget({
      ...input,
      constraints: [place(1, 30, [0, 1.6, 0]), place(0, 10, [0, 0.1, 0]), place(1, 30, [0.2, 1.6, 0])],
    });
    expect(at(controls, 2, 30, 1)[0]).toBeCloseTo(0.1, 5);
    expect(missed.worst[0]).toBeCloseTo(0.1, 5);
    expect(missed.worst[1]).toBeLessThan(1e-6);
    expect(missed.worst[2]).toBeCloseTo(0.1, 5);
    expect([...missed.against]).toEqual([2, -1, 0]);
  });

  test("for what does not exist are refused by number", async () => {
    await setUpPost(engine);
    const good: RetargetInput["constraints"] = [move(1, 4, [0, 0, 0]), place(1, 3, [0, 1.6, 0])];
    const refused = (constraint: NonNullable<RetargetInput["constraints"]>[number]) =>
      engine.retarget({ ...input, constraints: [...good, constraint] }).then(
        () => "",
        (error: EngineError) => error.message,
      );
    expect(await refused(move(0, 0, [0, 0, 0]))).toMatch(/^Pin 3 /);
    expect(await refused(place(2, 3, [0, 0, 0]))).toMatch(/^Pin 3 /);
    expect(await refused(place(-1, 3, [0, 0, 0]))).toMatch(/^Pin 3 /);
    expect(await refused(place(0, 60, [0, 0, 0]))).toMatch(/^Pin 3 /);
    expect(await refused(place(0, 3, [0, NaN, 0]))).toMatch(/^Pin 3 /);
  });
});

describe("contacts and flights", () => {
  test("of the user replace those of the motion", async () => {
    await setUpPost(engine);
    const performance = await engine.retarget({
      ...settings,
      pairs: Int32Array.of(-1, 1),
      contacts: [
        {
          control: 1,
          runs: [
            [5, 20],
            [50, 90],
          ],
        },
        { control: 0, runs: [] },
      ],
      flights: [
        [30, 45],
        [40, 42],
        [50, 51],
      ],
    });
    const stands = (control: number) => Array.from({ length: 60 }, (_, f) => f).filter((f) => performance.contacts[2 * f + control]);
    expect(stands(0)).toEqual([]);
    expect(stands(1)).toEqual([...Array(60).keys()].filter((f) => (f >= 5 && f < 20) || f >= 50));
    expect(performance.flights).toEqual([[30, 45]]);
    expect(performance.sourceContacts).toHaveLength(120);
    expect(performance.slip.after).toBeLessThan(1e-6);
  });
});

describe.skipIf(!hasShared)("coverage", () => {
  let motion: Motion;
  let rest: Float32Array;
  let pairs: Int32Array;
  beforeEach(async () => {
    const mesh = spot();
    await engine.setMesh(mesh);
    await engine.setControls(spotControls(mesh));
    motion = await engine.setMotion(walk02());
    rest = restControls(mesh, spotControls(mesh));
    pairs = Int32Array.from(spotJoints, (name) => motion.joints.findIndex((joint) => joint.name === name));
  });
  const example = (frame: number): ExampleInput => ({
    joints: motion.local.slice(3 * frame * motion.joints.length, 3 * (frame + 1) * motion.joints.length),
    controls: rest.map((x, i) => x + 0.05 * Math.sin(i + frame)),
  });

  test("asks for frames whose poses lower the error until they are enough", async () => {
    const examples: ExampleInput[] = [];
    let last = Infinity;
    for (let n = 0; ; ++n) {
      const { coverage, ask, enough, starters } = await engine.retarget({ ...settings, pairs, examples });
      expect(coverage).toHaveLength(motion.frames);
      const rms = Math.sqrt(coverage.reduce((sum, x) => sum + x * x, 0) / coverage.length);
      if (n === 0) expect(rms).toBeCloseTo(Math.SQRT2, 1);
      if (n > 0) expect(rms).toBeLessThan(last);
      expect(enough.have).toBe(n);
      expect(starters > 0).toBe(n < 4);
      expect(ask).toHaveLength(8);
      expect(ask[0]?.gain).toBeGreaterThan(0);
      if (enough.want === n) {
        expect(rms).toBeLessThan(0.16);
        expect(n).toBeLessThan(9);
        return;
      }
      last = rms;
      examples.push(example(ask[0]?.frame ?? 0));
    }
  });

  test("counts mirror images, which teach the other side", async () => {
    const mirror = Int32Array.of(1, 0, 3, 2, 4, 6, 5, 7);
    const examples = [example(10), example(30)];
    const one = await engine.retarget({ ...settings, pairs, examples });
    const both = await engine.retarget({ ...settings, pairs, examples, mirror, mirrorPlane: { point: [0, 0, 0], normal: [1, 0, 0] } });
    expect(one.enough.have).toBe(2);
    expect(both.enough.have).toBe(4);
    expect(Math.max(...both.coverage)).toBeLessThan(Math.max(...one.coverage));
    expect(both.controls).not.toEqual(one.controls);
  });
});
