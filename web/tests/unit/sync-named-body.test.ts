// What the joints of a file say of its body, whoever named them and however the file holds it.

import { afterAll, beforeAll, describe, expect, it } from "vitest";

import { HOSTILE, objText } from "../../authoring/strangers/hostile.js";
import { createNodeEngine } from "../../src/engine/node";
import type { AxisName, Engine } from "../../src/engine/types";
import { withJoints } from "../../src/io/gltf/joints";
import { modelOf } from "../../src/io/model";
import { readModel } from "../../src/io/read-model";
import { readNamedBody } from "../../src/sync/named-body";
import { shapeInput } from "../../src/sync/shape-input";
import { HOUND, PERSON, skeleton, turnTo, VOCABULARIES } from "../support/skeletons";

type Place = [number, number, number];
const vector = (axis: AxisName): Place =>
  ["x", "y", "z"].map((name) => (axis.charAt(1) === name ? Number(`${axis.charAt(0)}1`) : 0)) as Place;
const AXES: readonly AxisName[] = ["+x", "-x", "+y", "-y", "+z", "-z"];
const WAYS = AXES.flatMap((up) => AXES.filter((front) => front.charAt(1) !== up.charAt(1)).map((front) => [up, front] as const));

function boxOf(places: readonly (readonly number[])[], margin: number): { min: number[]; max: number[] } {
  const of = (pick: (...values: number[]) => number): number[] => [0, 1, 2].map((k) => pick(...places.map((place) => place[k])));
  return { min: of(Math.min).map((x) => x - margin), max: of(Math.max).map((x) => x + margin) };
}

const said = (joints: ReturnType<typeof skeleton>) =>
  readNamedBody(
    joints,
    boxOf(
      joints.map(({ position }) => position),
      0.04,
    ),
    "unknown",
  );

describe.each(Object.entries(VOCABULARIES))("a person in %s words", (_, name) => {
  it.each(WAYS)("stands with %s up and looks along %s", (up, front) => {
    const turn = turnTo(vector(up), vector(front));
    const body = said(skeleton(PERSON, name, turn));
    expect(body?.stands).toEqual({ up, facing: front });
    const places = (role: string, side: number): Place[] =>
      body?.landmarks.filter((one) => one.role === role && one.side === side).map(({ position }) => position) ?? [];
    const [hand] = places("hand", 1);
    expect(places("hand", 1)).toHaveLength(1);
    expect(places("hand", -1)).toHaveLength(1);
    for (const [k, x] of turn([0.312, 0.848, 0]).entries()) expect(hand[k]).toBeCloseTo(x, 5);
    expect(places("foot", 1)).toHaveLength(1);
    expect(places("foot", -1)).toHaveLength(1);
    expect(places("head", 0)).toHaveLength(1);
    expect(places("hips", 0)).toHaveLength(1);
  });
});

it("a hound stands on four feet, its ears are no head and what only steers its legs is nowhere", () => {
  for (const [up, front] of [
    ["+y", "+z"],
    ["+z", "-y"],
    ["+y", "-x"],
  ] as const) {
    const turn = turnTo(vector(up), vector(front));
    const body = said(skeleton(HOUND, VOCABULARIES.blender, turn));
    expect(body?.stands).toEqual({ up, facing: front });
    const roles = (role: string): number => body?.landmarks.filter((one) => one.role === role).length ?? 0;
    expect(roles("foot")).toBe(4);
    expect(roles("hand")).toBe(0);
    expect(roles("head")).toBe(1);
    const far = vector(front).findIndex((x) => x !== 0);
    for (const { position } of body?.landmarks ?? []) expect(Math.abs(position[far])).toBeLessThan(1);
  }
});

it("toes know better than names that somebody gave from in front", () => {
  const swapped = skeleton(PERSON, (word, side) => VOCABULARIES.plain(word, side === "L" ? "R" : "L"));
  const body = said(swapped);
  expect(body?.stands).toEqual({ up: "+y", facing: "+z" });
  const left = body?.landmarks.find(({ role, side }) => role === "hand" && side === 1);
  expect(left?.position[0]).toBeGreaterThan(0);
});

it("names that say nothing are not listened to", () => {
  expect(said(skeleton(PERSON, (word, side) => `bone_${word.length}${side}`))).toBeNull();
});

describe("with a model", () => {
  let engine: Engine;
  beforeAll(async () => void (engine = await createNodeEngine()));
  afterAll(() => engine.close());

  it("hands and feet are where the joints are, though the file holds it on its side", async () => {
    const made = HOSTILE["person-hanging"]();
    const turn = turnTo([1, 0, 0], [0, 1, 0]);
    const lying = {
      ...made,
      positions: made.positions.map((_, i) => turn([...made.positions.subarray(i - (i % 3), i - (i % 3) + 3)] as Place)[i % 3]),
    };
    const { document } = await readModel([{ name: "b.obj", bytes: new TextEncoder().encode(objText(lying)) }]);
    const model = modelOf("b.obj", withJoints(document, skeleton(PERSON, VOCABULARIES.mixamo, turn)), []);
    expect(model.joints).toHaveLength(21);
    const { up, facing, sure, points } = await engine.analyseShape(shapeInput(model));
    expect({ up, facing, sure }).toEqual({ up: "+x", facing: "+y", sure: 1 });
    for (const [role, limb] of [
      ["hand", "hand"],
      ["foot", "foot"],
    ] as const) {
      for (const side of ["left", "right"] as const) {
        const found = points.filter((point) => point.role === role && point.side === side);
        expect(found).toHaveLength(1);
        const place = model.positions.subarray(3 * found[0].vertex, 3 * found[0].vertex + 3);
        const wanted = turn(made.truth.limbs[`${side}-${limb}`]);
        expect(Math.hypot(...wanted.map((x, k) => x - place[k]))).toBeLessThan(0.2);
      }
    }
    const head = points.find(({ role }) => role === "head");
    expect(model.positions[3 * (head?.vertex ?? 0)]).toBeGreaterThan(1.5);
  });
});

describe("bodies without legs", () => {
  const joint = (name: string, parent: number | null, position: Place) => ({ name, parent, position });

  it("have their tail told, and a mouth is of the head", () => {
    const joints = [
      joint("Body", null, [0, 0.3, 0]),
      joint("Head", 0, [0, 0.9, 0]),
      joint("LowerMouth", 0, [0, 0.9, 0.3]),
      joint("Tail1", 0, [0, 0.1, -0.3]),
      joint("Tail2", 3, [0, 0.1, -0.6]),
    ];
    const places = joints.map(({ position }) => position);
    const snake = readNamedBody(joints, boxOf(places, 0.04), "y_up");
    expect(snake?.landmarks.map(({ role }) => role).sort()).toEqual(["head", "head", "tail", "tail", "tip"]);
  });

  it("have no hands where only the feet's thumbs are named", () => {
    const legs = (["L", "R"] as const).flatMap((side, k) => {
      const x = k === 0 ? 0.3 : -0.3;
      return [
        joint(`rear_upper_leg.${side}`, 0, [x, 0.4, -0.3]),
        joint(`rear_lower_leg.${side}`, 1 + 3 * k, [x, 0.1, -0.3]),
        joint(`rear_thumb_1.${side}`, 0, [x, 0.02, -0.3]),
      ];
    });
    const beetle = said([joint("body", null, [0, 0.4, 0]), ...legs, joint("head", 0, [0, 0.5, 0.5])]);
    const roles = beetle?.landmarks.map(({ role }) => role);
    expect(roles).toContain("foot");
    expect(roles).not.toContain("hand");
  });
});
