import { describe, expect, test } from "vitest";
import { bindNormals, writeNormals } from "../../src/gltf/surface-normals";
import { hinge, type Shape, sphere } from "../support/surfaces";

const identity = (n: number): Uint32Array => Uint32Array.from({ length: n }, (_, i) => i);

/** What a surface with these normals at rest shows once it is posed. */
function posedNormals(
  { positions, index }: Shape,
  normals: number[],
  posed: Float32Array,
  toVertex = identity(normals.length / 3),
): number[] {
  const binding = bindNormals(positions, { normals: Float32Array.from(normals), index, toVertex });
  const out = new Float32Array(normals.length);
  writeNormals(binding, posed, out);
  return [...out];
}

/** About +y, then about +x. */
function turned(values: ArrayLike<number>): number[] {
  const [c, s] = [Math.cos(2), Math.sin(2)];
  const [d, t] = [Math.cos(1), Math.sin(1)];
  return Array.from({ length: values.length / 3 }, (_, i) => {
    const [x, y, z] = [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
    const [u, w] = [c * x + s * z, -s * x + c * z];
    return [u, d * y - t * w, t * y + d * w];
  }).flat();
}

const close = (values: ArrayLike<number>, digits = 5) => Array.from(values, (x) => expect.closeTo(x, digits));

describe("a file's normals on a surface that moves", () => {
  const ball = sphere(12, 8);
  const out = [...ball.positions];
  /** As no surface of this shape has them: bent to one side. */
  const odd = Array.from({ length: out.length / 3 }, (_, i) => {
    const n = [out[3 * i] + 0.4, out[3 * i + 1] + 0.2, out[3 * i + 2]];
    return n.map((x) => x / Math.hypot(...n));
  }).flat();

  test("at rest they are the file's, smooth, odd or turned inside out", () => {
    for (const normals of [odd, odd.map((x) => -x)]) expect(posedNormals(ball, normals, ball.positions)).toEqual(close(normals));
    const own = posedNormals(ball, out, ball.positions);
    own.forEach((x, i) => expect(Math.abs(x - out[i])).toBeLessThan(0.04));
  });

  test("they turn with the body, odd ones and hard edges too", () => {
    expect(posedNormals(ball, odd, Float32Array.from(turned(ball.positions)))).toEqual(close(turned(odd), 4));
    // Both faces of a hinge end at its vertices 1 and 2, each with a normal of its own.
    const { positions } = hinge(60);
    const shape = { positions, index: Uint32Array.of(0, 3, 2, 0, 2, 1, 6, 7, 5, 6, 5, 4) };
    const far = [-Math.sin(Math.PI / 3), 0.5, 0];
    const normals = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((r) => (r < 4 ? [0, 1, 0] : far));
    const toVertex = Uint32Array.of(0, 1, 2, 3, 4, 5, 1, 2);
    expect(posedNormals(shape, normals, positions, toVertex)).toEqual(close(normals));
    expect(posedNormals(shape, normals, Float32Array.from(turned(positions)), toVertex)).toEqual(close(turned(normals), 4));
    // Only the second face bends on: the first one's normals stay.
    const bent = posedNormals(shape, normals, hinge(85).positions, toVertex);
    expect(bent.slice(0, 12)).toEqual(close(normals.slice(0, 12)));
    expect(bent.slice(18, 21)).toEqual(close([-Math.sin((85 * Math.PI) / 180), Math.cos((85 * Math.PI) / 180), 0]));
  });

  test("a smooth hinge stays smooth however far it bends", () => {
    const flat = hinge(0);
    const normals = posedNormals(flat, Array(6).fill([0, 1, 0]).flat(), hinge(80).positions);
    expect(normals[7]).toBeGreaterThan(Math.cos((80 * Math.PI) / 180) + 0.1);
    expect(normals[7]).toBeLessThan(0.99);
  });

  test("a seam of the texture does not show: copies of one vertex with one normal share it", () => {
    const { positions } = hinge(40);
    const shape = { positions, index: Uint32Array.of(0, 3, 2, 0, 2, 1, 6, 7, 5, 6, 5, 4) };
    const normals = posedNormals(shape, Array(8).fill([0, 1, 0]).flat(), hinge(75).positions, Uint32Array.of(0, 1, 2, 3, 4, 5, 1, 2));
    expect(normals.slice(3, 9)).toEqual(normals.slice(18, 24));
  });

  test("faces wound either way do not cancel out", () => {
    const index = ball.index.slice();
    for (let f = 0; f < index.length; f += 6) [index[f + 1], index[f + 2]] = [index[f + 2], index[f + 1]];
    const normals = posedNormals({ ...ball, index }, out, Float32Array.from(turned(ball.positions)));
    turned(out).forEach((x, i) => expect(Math.abs(x - normals[i])).toBeLessThan(0.06));
  });

  test("nothing is written where faces are flat", () => {
    expect(
      posedNormals(
        ball,
        out.map(() => 0),
        ball.positions,
      ),
    ).toEqual(out.map(() => 0));
  });
});
