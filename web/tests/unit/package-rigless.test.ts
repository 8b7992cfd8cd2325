import { readFileSync } from "node:fs";
import { afterAll, beforeAll, describe, expect, it } from "vitest";

import { createRigless, DocumentError, EngineError, type Mesh, ModelError, type Rigless } from "../../src/package/node";
import { PERSON, skeleton, turnTo, VOCABULARIES } from "../support/skeletons";
import { nod, post } from "./engine-support";

/** A cube, which looks the same from everywhere. */
function cube(): { positions: number[]; faces: number[] } {
  const positions = Array.from({ length: 8 }, (_, k) => [k & 1, (k >> 1) & 1, k >> 2]).flat();
  const faces = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];
  return { positions, faces };
}

const hop = readFileSync(new URL("../../assets/motions/hop.bvh", import.meta.url), "utf8");
const nods = nod(20).text;
const { positions, faces } = post();
const last = positions.length - 3;
const points = [
  { id: "foot", name: "Foot", position: [0, 0, 0], joint: null },
  { id: "top", name: "Top", position: [0, 1.6, 0], joint: "Head" },
] as const;
const stands = { up: "+y", facing: "+z" } as const;

let rigless: Rigless;
beforeAll(async () => void (rigless = await createRigless()));
afterAll(() => rigless.close());

const at = (frame: Float32Array, vertex: number): number[] => [...frame.subarray(3 * vertex, 3 * vertex + 3)];

describe("import rigless", () => {
  it("guesses how a mesh stands and what moves it", async () => {
    const dance = await rigless.retarget({ mesh: { positions, faces }, motion: hop });
    expect(dance).toMatchObject({ fps: 30, frames: 117, up: "+y" });
    expect(dance.points.map(({ joint }) => joint)).toContain("Head");
    const heights = Array.from({ length: dance.frames }, (_, f) => dance.frame(f)[last + 1]);
    expect(Math.max(...heights) - Math.min(...heights)).toBeGreaterThan(0.15);
    expect(() => dance.frame(117)).toThrow("There is no frame 117: they go from 0 to 116.");
  });

  it("takes which way is up from the kind of the mesh's file, as page and command line do", async () => {
    const { positions, faces } = cube();
    const up = async (file: string): Promise<string> => (await rigless.retarget({ mesh: { positions, faces, file }, motion: nods })).up;
    expect([await up("crate.obj"), await up("crate.STL"), await up("crate.glb")]).toEqual(["+y", "+z", "+y"]);
  });

  it("hears the joints that a mesh's file brings", async () => {
    const joints = skeleton(PERSON, VOCABULARIES.mixamo, turnTo([0, 1, 0], [-1, 0, 0]));
    const dance = await rigless.retarget({ mesh: { positions, faces, joints }, motion: nods });
    expect(dance).toMatchObject({ up: "+y", facing: "-x" });
    expect(dance.points.map(({ name }) => name)).toEqual(expect.arrayContaining(["Left hand", "Right hand"]));
  });

  it("answers in the mesh's own units and axes", async () => {
    const task = { motion: nods, points, mesh: { positions, faces, ...stands } };
    const plain = await rigless.retarget(task);
    // The same post, lying: file z is up, in centimetres.
    const turned = (list: ArrayLike<number>): number[] =>
      Array.from({ length: list.length / 3 }, (_, v) => [100 * list[3 * v], -100 * list[3 * v + 2], 100 * list[3 * v + 1]]).flat();
    const lying = await rigless.retarget({
      ...task,
      mesh: { positions: turned(positions), faces, up: "+z", facing: "-y" },
      points: points.map((point) => ({ ...point, position: turned(point.position) as unknown as [number, number, number] })),
    });
    const [a, b] = [turned(plain.frame(10)), lying.frame(10)];
    expect(Math.max(...a.map((x, i) => Math.abs(x - b[i])))).toBeLessThan(0.05);
    expect(Math.max(...a.map((x, i) => Math.abs(x - turned(positions)[i])))).toBeGreaterThan(1);
  });

  it("keeps the caller's vertices: doubled ones move together, unused ones stay", async () => {
    const soup = Array.from(faces, (v) => [...positions.subarray(3 * v, 3 * v + 3)]).flat();
    const mesh: Mesh = { positions: [7, 7, 7, ...soup], faces: Array.from(faces, (_, i) => i + 1), ...stands };
    const whole = (await rigless.retarget({ mesh: { positions, faces, ...stands }, motion: nods, points })).frame(7);
    const loose = (await rigless.retarget({ mesh, motion: nods, points })).frame(7);
    expect(loose).toHaveLength(3 + 3 * faces.length);
    expect(at(loose, 0)).toEqual([7, 7, 7]);
    faces.forEach((v, corner) => expect(at(loose, corner + 1)).toEqual(at(whole, v).map((x) => expect.closeTo(x, 4))));
  });

  it("learns from poses, by a frame of the motion or by joints", async () => {
    const task = { mesh: { positions, faces, ...stands }, motion: nods, points };
    const plain = await rigless.retarget(task);
    const bent = { foot: [0, 0, 0], top: [0.9, 1.1, 0] } as const;
    const taught = await rigless.retarget({ ...task, poses: [{ human: 5, points: bent }] });
    expect(taught.frame(5)[last]).toBeGreaterThan(plain.frame(5)[last] + 0.3);
    const joints = { Hips: [0, 0, 0], Head: [0, 1.355447, 0.409993], Head_end: [0, 1.640099, 0.620485] } as const; // frame 5
    const other = await rigless.retarget({ ...task, poses: [{ human: joints, points: bent }] });
    expect(at(other.frame(5), last / 3)).toEqual(at(taught.frame(5), last / 3).map((x) => expect.closeTo(x, 3)));
    await expect(rigless.retarget({ ...task, poses: [{ human: 20, points: bent }] })).rejects.toThrow(
      "Pose 1 is at frame 20, but the motion's go from 0 to 19.",
    );
  });

  it("says what is wrong by kinds of error that it exports", async () => {
    const mesh = { positions, faces, ...stands };
    const refused = (task: Parameters<Rigless["retarget"]>[0]) => rigless.retarget(task).catch((error: unknown) => error);
    expect(await refused({ mesh: { positions, faces: [0, 1, 999] }, motion: nods })).toBeInstanceOf(ModelError);
    expect(await refused({ mesh, motion: "no motion", points })).toMatchObject({ code: "bad_motion" });
    expect(await refused({ mesh, motion: nods, points: [] })).toMatchObject({ code: "bad_controls" });
    const odd = await refused({ mesh, motion: nods, points: [{ ...points[0], position: [0, NaN, 0] }] });
    expect(odd).toBeInstanceOf(DocumentError);
    expect((odd as Error).message).toBe("The task: points[0].position should be three numbers, but its second is null.");
    expect(await refused({ mesh, motion: nods, points, settings: { volume: 9 } })).toBeInstanceOf(DocumentError);
  });

  it("can be watched and cancelled; tasks take turns", async () => {
    const steps = new Set<string>();
    const abort = new AbortController();
    const task = { mesh: { positions, faces, ...stands }, motion: hop, points };
    const cancelled = rigless.retarget(task, { signal: abort.signal, onProgress: () => abort.abort() });
    const done = rigless.retarget({ ...task, motion: nods }, { onProgress: (step) => steps.add(step) });
    const error: unknown = await cancelled.catch((reason: unknown) => reason);
    expect(error).toBeInstanceOf(EngineError);
    expect(error).toMatchObject({ code: "cancelled" });
    expect((await done).frames).toBe(20);
    expect([...steps]).toEqual(expect.arrayContaining(["Binding the model", "Binding the points", "Solving", "Deforming"]));
  });
});
