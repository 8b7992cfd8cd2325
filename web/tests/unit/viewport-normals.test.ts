import { describe, expect, test } from "vitest";
import { buildTopology, writeNormals } from "../../src/viewport/normals";

/** Two squares hinged on the z axis, the second bent up by an angle; one render vertex per corner of the file. */
function hinge(degrees: number): { positions: Float32Array; index: Uint32Array; toVertex: Uint32Array } {
  const bend = (degrees * Math.PI) / 180;
  const x = Math.cos(bend);
  const y = Math.sin(bend);
  const positions = Float32Array.of(-1, 0, 0, 0, 0, 0, 0, 0, 1, -1, 0, 1, x, y, 0, x, y, 1);
  const index = Uint32Array.of(0, 3, 2, 0, 2, 1, 1, 2, 5, 1, 5, 4);
  return { positions, index, toVertex: Uint32Array.of(0, 1, 2, 3, 4, 5) };
}

function normalsOf(shape: ReturnType<typeof hinge>, posed = shape.positions): { normals: Float32Array; vertex: Uint32Array } {
  const topology = buildTopology(shape.positions, shape.index, shape.toVertex);
  const normals = new Float32Array(3 * topology.vertex.length);
  writeNormals(topology, posed, normals);
  return { normals, vertex: topology.vertex };
}

describe("smooth normals with creases", () => {
  test("an edge bent by less than 50 degrees is smooth: its vertices stay whole and lean half way", () => {
    const { normals, vertex } = normalsOf(hinge(40));
    expect(vertex.length).toBe(6);
    const at = vertex.indexOf(1);
    const lean = (Math.atan2(-normals[3 * at]!, normals[3 * at + 1]!) * 180) / Math.PI;
    expect(lean).toBeGreaterThan(10);
    expect(lean).toBeLessThan(30);
  });

  test("an edge bent by more than 50 degrees is a crease: its vertices are drawn twice, each flat", () => {
    const { normals, vertex } = normalsOf(hinge(60));
    expect(vertex.length).toBe(8);
    const ups = [...vertex.keys()]
      .filter((i) => vertex[i] === 1)
      .map((i) => normals[3 * i + 1]!)
      .sort();
    expect(ups[0]).toBeCloseTo(Math.cos(Math.PI / 3), 5);
    expect(ups[1]).toBeCloseTo(1, 5);
  });

  test("creases are decided at rest: bending a flat hinge later keeps it smooth", () => {
    const flat = hinge(0);
    const { normals, vertex } = normalsOf(flat, hinge(80).positions);
    expect(vertex.length).toBe(6);
    const at = vertex.indexOf(2);
    expect(normals[3 * at + 1]).toBeGreaterThan(Math.cos((80 * Math.PI) / 180) + 0.1);
    expect(normals[3 * at + 1]).toBeLessThan(0.99);
  });

  test("a seam of the texture does not show: render vertices of one solver vertex share their normal", () => {
    const { positions } = hinge(40);
    const seam = Float32Array.from([...positions, ...positions.subarray(3, 9)]);
    const { normals, vertex } = normalsOf(
      { positions: seam, index: Uint32Array.of(0, 3, 2, 0, 2, 1, 6, 7, 5, 6, 5, 4), toVertex: Uint32Array.of(0, 1, 2, 3, 4, 5, 1, 2) },
      positions,
    );
    const twins = [...vertex.keys()].filter((i) => vertex[i] === 1);
    expect(twins.length).toBe(2);
    for (let k = 0; k < 3; k++) expect(normals[3 * twins[0]! + k]).toBe(normals[3 * twins[1]! + k]);
  });

  test("a sphere's normals point out along its radii", () => {
    const { positions, index } = sphere(24, 12);
    const { normals, vertex } = normalsOf({ positions, index, toVertex: Uint32Array.from({ length: positions.length / 3 }, (_, i) => i) });
    vertex.forEach((v, i) => {
      const dot = [0, 1, 2].reduce((sum, k) => sum + normals[3 * i + k]! * positions[3 * v + k]!, 0);
      expect(dot).toBeGreaterThan(0.98);
    });
  });

  test("a face without area leaves its neighbours smooth and gives no NaN", () => {
    const shape = hinge(40);
    shape.index = Uint32Array.from([...shape.index, 1, 2, 2]);
    const { normals } = normalsOf(shape);
    expect(normals.every(Number.isFinite)).toBe(true);
  });
});

/** A closed sphere of radius 1, counter-clockwise from outside. */
function sphere(around: number, rings: number): { positions: Float32Array; index: Uint32Array } {
  const points: number[] = [0, 1, 0];
  for (let r = 1; r < rings; r++) {
    for (let a = 0; a < around; a++) {
      const [t, u] = [(Math.PI * r) / rings, (2 * Math.PI * a) / around];
      points.push(Math.sin(t) * Math.cos(u), Math.cos(t), Math.sin(t) * Math.sin(u));
    }
  }
  points.push(0, -1, 0);
  const last = points.length / 3 - 1;
  const at = (r: number, a: number): number => 1 + (r - 1) * around + (a % around);
  const index: number[] = [];
  for (let a = 0; a < around; a++) {
    index.push(0, at(1, a + 1), at(1, a), last, at(rings - 1, a), at(rings - 1, a + 1));
    for (let r = 1; r < rings - 1; r++) index.push(at(r, a), at(r, a + 1), at(r + 1, a), at(r, a + 1), at(r + 1, a + 1), at(r + 1, a));
  }
  return { positions: Float32Array.from(points), index: Uint32Array.from(index) };
}
