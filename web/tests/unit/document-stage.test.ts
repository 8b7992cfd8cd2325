import { describe, expect, it } from "vitest";

import { boundsOf, facingFor, fromStage, pointFromStage, pointToStage, stageOf, toStage } from "../../src/document/stage-transform";
import type { Axis, Vec3 } from "../../src/document/types";

const AXES: Axis[] = ["+x", "-x", "+y", "-y", "+z", "-z"];
const bounds = { min: [-3, 10, -0.5], max: [1, 14, 2.5] } as const;

const along = (axis: Axis): Vec3 => {
  const sign = axis[0] === "-" ? -1 : 1;
  return [axis[1] === "x" ? sign : 0, axis[1] === "y" ? sign : 0, axis[1] === "z" ? sign : 0];
};

describe("the stage", () => {
  const pairs = AXES.flatMap((facing) => AXES.map((up) => [facing, up] as const));

  it.each(pairs)("facing %s, up %s: stands in the middle, 1.7 m, looking along +z", (facing, up) => {
    const stage = stageOf(bounds, facing, up);
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((n) => [0, 1, 2].map((k) => ((n >> k) & 1 ? bounds.max : bounds.min)[k]));
    const { min, max } = boundsOf(toStage(stage, corners));
    expect(min[1]).toBeCloseTo(0, 6);
    expect(min[0] + max[0]).toBeCloseTo(0, 6);
    expect(min[2] + max[2]).toBeCloseTo(0, 6);
    expect(Math.max(max[1], 0.6 * (max[0] - min[0]), 0.6 * (max[2] - min[2]))).toBeCloseTo(1.7, 6);
    const turned = (axis: Axis): number[] => {
      const [a, b] = [pointToStage(stage, [0, 0, 0]), pointToStage(stage, along(axis))];
      return b.map((x, k) => (x - a[k]) / stage.scale);
    };
    expect(turned(up)).toEqual([0, 1, 0].map((x) => expect.closeTo(x, 9)));
    expect(turned(facingFor(facing, up))).toEqual([0, 0, 1].map((x) => expect.closeTo(x, 9)));
    const r = stage.rotation;
    expect(r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) + r[2] * (r[3] * r[7] - r[4] * r[6])).toBe(1);
  });

  it.each(pairs)("facing %s, up %s: there and back", (facing, up) => {
    const stage = stageOf(bounds, facing, up);
    const point: Vec3 = [0.3, 11.7, -0.2];
    expect(pointFromStage(stage, pointToStage(stage, point))).toEqual(point.map((x) => expect.closeTo(x, 12)));
    expect([...fromStage(stage, toStage(stage, point))]).toEqual(point.map((x) => expect.closeTo(x, 5)));
  });

  it("a model cannot look along its up axis: it gets the usual front", () => {
    expect(facingFor("+y", "+y")).toBe("+z");
    expect(facingFor("-z", "+z")).toBe("-y");
    expect(facingFor("+x", "-x")).toBe("+z");
    expect(facingFor("-x", "+y")).toBe("-x");
  });

  it("scales a wide model by its width", () => {
    const stage = stageOf({ min: [0, 0, 0], max: [10, 1, 2] }, "+z", "+y");
    expect(stage.scale).toBeCloseTo(1.7 / 6, 12);
  });

  it("keeps a model without extent where it is not", () => {
    const stage = stageOf({ min: [1, 2, 3], max: [1, 2, 3] }, "+z", "+y");
    expect(pointToStage(stage, [1, 2, 3])).toEqual([0, 0, 0]);
  });
});
