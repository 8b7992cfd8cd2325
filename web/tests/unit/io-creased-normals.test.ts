import { describe, expect, test } from "vitest";
import { creasedNormals } from "../../src/io/gltf/creased-normals";
import { hinge, sphere } from "../support/surfaces";

/** By corner. */
function normalsOf(...parts: Parameters<typeof creasedNormals>[0]): number[][] {
  return creasedNormals(parts).flatMap((normals) => {
    if (!normals) return [];
    return Array.from({ length: normals.length / 3 }, (_, c) => [...normals.subarray(3 * c, 3 * c + 3)]);
  });
}

describe("smooth normals with creases", () => {
  test("an edge bent by less than 50 degrees is smooth: its corners lean half way", () => {
    const shape = hinge(40);
    const normals = normalsOf(shape);
    const atHinge = normals.filter((_, c) => shape.index[c] === 1);
    expect(atHinge).toHaveLength(3);
    for (const normal of atHinge) {
      expect(normal).toEqual(atHinge[0]);
      expect((Math.atan2(-normal[0], normal[1]) * 180) / Math.PI).toBeGreaterThan(10);
      expect((Math.atan2(-normal[0], normal[1]) * 180) / Math.PI).toBeLessThan(30);
    }
  });

  test("an edge bent by more than 50 degrees is a crease: each side is flat", () => {
    const shape = hinge(60);
    const ups = normalsOf(shape).map(([, y]) => y);
    shape.index.forEach((_, c) => expect(ups[c]).toBeCloseTo(c < 6 ? 1 : 0.5, 5));
  });

  test("two parts that meet are one surface, though they share no vertex", () => {
    const { positions, index } = hinge(40);
    const [near, far] = [index.slice(0, 6), index.slice(6)];
    expect(normalsOf({ positions, index: near }, { positions: positions.slice(), index: far })).toEqual(normalsOf({ positions, index }));
    expect(normalsOf({ positions, index: near, normals: positions }, { positions, index: far })).toEqual(
      normalsOf({ positions, index: far }),
    );
  });

  test("a sphere's normals point out along its radii", () => {
    const shape = sphere(24, 12);
    normalsOf(shape).forEach((normal, c) => {
      const place = shape.positions.subarray(3 * shape.index[c]);
      expect(normal.reduce((sum, x, k) => sum + x * place[k], 0)).toBeGreaterThan(0.98);
    });
  });

  test("a face without area leaves its neighbours smooth and gives no NaN", () => {
    const { positions, index } = hinge(40);
    const normals = normalsOf({ positions, index: [...index, 1, 2, 2] });
    expect(normals.slice(0, 12)).toEqual(normalsOf(hinge(40)));
    expect(normals.flat().every(Number.isFinite)).toBe(true);
  });
});
