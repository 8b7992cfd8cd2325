// What the engine's tests share: the golden cases, models and motions.

import { existsSync, readFileSync } from "node:fs";
import type { ControlInput, Engine, MeshInput, MotionInput } from "../../src/engine/types";

const SHARED = new URL("../../../../shared/data/", import.meta.url);

export const hasShared = existsSync(SHARED);

export const sharedText = (path: string) => readFileSync(new URL(path, SHARED), "utf8");

/** A golden case; the caller names the shape it needs. */
export function golden<T>(name: string): T {
  return JSON.parse(readFileSync(new URL(`../../../tests/golden/${name}.json`, import.meta.url), "utf8")) as T;
}

/** Turned by 180 degrees about Y, 1.7 m tall, on the floor: spot looks along -Z in its file. */
export function spot(): MeshInput {
  const positions: number[] = [];
  const faces: number[] = [];
  for (const line of sharedText("meshes/spot.obj").split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "v") positions.push(-Number(words[1]), Number(words[2]), -Number(words[3]));
    if (words[0] === "f") faces.push(...words.slice(1, 4).map((word) => parseInt(word, 10) - 1));
  }
  const ys = positions.filter((_, i) => i % 3 === 1);
  const low = Math.min(...ys);
  const scale = 1.7 / (Math.max(...ys) - low);
  return {
    positions: Float32Array.from(positions, (value, i) => (i % 3 === 1 ? value - low : value) * scale),
    faces: Uint32Array.from(faces),
  };
}

/** Hooves, muzzle, horns and rump, and the joints of a CMU skeleton that drive them. */
const SPOT_PLACES: [number, number, number, string][] = [
  [0.22, 0.06, 0.15, "rfoot"],
  [-0.22, 0.06, 0.15, "lfoot"],
  [0.2, 0.06, -0.6, "lfoot"],
  [-0.2, 0.06, -0.6, "rfoot"],
  [0, 1.04, 0.86, "head"],
  [0.18, 1.7, 0.45, "lhand"],
  [-0.18, 1.7, 0.45, "rhand"],
  [0, 0.66, -0.86, ""],
];

export const spotJoints = SPOT_PLACES.map((place) => place[3]);

export function spotControls(mesh: MeshInput): ControlInput[] {
  return SPOT_PLACES.map(([x, y, z]) => ({ vertex: nearestVertex(mesh, x, y, z), radius: 0.085 }));
}

function nearestVertex({ positions }: MeshInput, x: number, y: number, z: number): number {
  const distance = (v: number) => Math.hypot((positions[3 * v] ?? 0) - x, (positions[3 * v + 1] ?? 0) - y, (positions[3 * v + 2] ?? 0) - z);
  let nearest = 0;
  for (let v = 1; v < positions.length / 3; ++v) if (distance(v) < distance(nearest)) nearest = v;
  return nearest;
}

export const walk02 = (): MotionInput => ({
  skeleton: { name: "02.asf", text: sharedText("motions/02.asf") },
  name: "02_01.amc",
  text: sharedText("motions/02_01.amc"),
});

/** C x 3 positions of the controls at rest. */
export function restControls(mesh: MeshInput, controls: ControlInput[]): Float32Array {
  return Float32Array.from(controls.flatMap(({ vertex }) => [...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)]));
}

/** An octagonal post, 1.6 m tall, in `rings` rings: needs no file. */
export function post(rings = 9): MeshInput {
  const positions: number[] = [];
  const faces: number[] = [];
  for (let r = 0; r < rings; ++r) {
    for (let k = 0; k < 8; ++k) {
      positions.push(0.2 * Math.cos((k * Math.PI) / 4), (1.6 * r) / (rings - 1), -0.2 * Math.sin((k * Math.PI) / 4));
    }
  }
  for (let r = 0; r + 1 < rings; ++r) {
    for (let k = 0; k < 8; ++k) {
      const a = 8 * r + k;
      const b = 8 * r + ((k + 1) % 8);
      faces.push(a, b, b + 8, a, b + 8, a + 8);
    }
  }
  const bottom = positions.length / 3;
  positions.push(0, 0, 0, 0, 1.6, 0);
  for (let k = 0; k < 8; ++k) {
    faces.push(bottom, (k + 1) % 8, k, bottom + 1, 8 * (rings - 1) + k, 8 * (rings - 1) + ((k + 1) % 8));
  }
  return { positions: Float32Array.from(positions), faces: Uint32Array.from(faces) };
}

/** Its two ends. */
export const postControls = (mesh: MeshInput): ControlInput[] => {
  const last = mesh.positions.length / 3 - 1;
  return [
    { vertex: last - 1, radius: 0.1 },
    { vertex: last, radius: 0.1 },
  ];
};

const BVH_HEAD = `HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation
  JOINT Head
  {
    OFFSET 0 0.8 0
    CHANNELS 3 Yrotation Xrotation Zrotation
    End Site
    {
      OFFSET 0 0.2 0
    }
  }
}
MOTION
`;

/** Nods and bobs at 30 fps. */
export function nod(frames = 60): MotionInput {
  const rows = Array.from(
    { length: frames },
    (_, f) => `0 ${0.9 + 0.1 * Math.sin(f / 5)} 0 0 ${20 * Math.sin(f / 5)} 0 0 ${30 * Math.sin(f / 7)} 0`,
  );
  return { name: "nod.bvh", text: `${BVH_HEAD}Frames: ${frames}\nFrame Time: 0.0333333\n${rows.join("\n")}\n` };
}

/** A mesh, its controls and a motion, ready to retarget. */
export async function setUpPost(engine: Engine, frames = 60): Promise<MeshInput> {
  const mesh = post();
  await engine.setMesh(mesh);
  await engine.setControls(postControls(mesh));
  await engine.setMotion(nod(frames));
  return mesh;
}
