// What few projects say: stiff parts, turned points, own weights of the whole pose, pins that move on, and dances as in the paper.

import { afterAll, describe, expect, test } from "vitest";

import { addExample, setPoint, setSettings, solveMesh } from "../../src/document/commands";
import { setPin } from "../../src/document/clips";
import { parseProject, serializeProject } from "../../src/document/project";
import { removeStiff, setStiff } from "../../src/document/stiff";
import type { Command } from "../../src/document/store";
import type { Example, Pin, ProjectDocument, Vec3 } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import type { Frame, Performance } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { Binding } from "../../src/sync/binding";
import { stageFor } from "../../src/sync/placement";
import { sayPose } from "../../src/sync/pairing";
import { pointsOfControls, pointVertices } from "../../src/sync/point-controls";
import { rigidityOf } from "../../src/sync/stiff";
import { asset } from "../support/files";
import { nod } from "./engine-support";

const motion = nod(20);
const engine = await createNodeEngine();
afterAll(() => engine.close());
const model = await readModel([asset("cactus/cactus.glb")]);
const { document: cactus } = parseProject(new TextDecoder().decode(asset("cactus/project.json").bytes), "project.json");
const document: ProjectDocument = { ...cactus, motion: { files: [motion.name] } };

interface Dance {
  performance: Performance;
  frames: Frame[];
}

/** As the page and the command line make it, of what a file would hold. */
async function dance(said: ProjectDocument): Promise<Dance> {
  const read = parseProject(serializeProject(said), "project.json").document;
  const binding = new Binding(engine);
  await binding.take(read, { model, motion });
  const performance = await binding.solve(read);
  const frames: Frame[] = [];
  await binding.frames(
    Array.from({ length: performance.frames }, (_, f) => f),
    (f, frame) => (frames[f] = frame),
  );
  return { performance, frames };
}

const after = (...commands: Command[]): ProjectDocument => commands.reduce((d, command) => command(d), document);
const plain = { surface: await dance(document), solid: await dance(solveMesh("solid")(document)) };

/** How far the edges of the model within a region are from their rest, over all frames: rms share. */
function strain(frames: Frame[], inside: Float32Array): number {
  const { scale } = stageFor(model, document.mesh);
  let sum = 0;
  let count = 0;
  for (const { positions } of frames)
    for (let f = 0; f < model.faces.length; f += 3) {
      const [a, b] = [model.faces[f], model.faces[f + 1]];
      if (inside[a] < 10 || inside[b] < 10) continue;
      const [now, rest] = [positions, model.positions].map((p) => Math.hypot(...[0, 1, 2].map((k) => p[3 * a + k] - p[3 * b + k])));
      sum += (now / (rest * scale) - 1) ** 2;
      count++;
    }
  return Math.sqrt(sum / count);
}

describe.each(["surface", "solid"] as const)("of a %s", (solve) => {
  test("a stiff part keeps its shape, and softens again", async () => {
    const top = document.points[0].position;
    const stiff = after(solveMesh(solve), setStiff({ id: "s1", position: top, radius: 0.25 }));
    const inside = rigidityOf(model, stiff);
    const [soft, hard] = [plain[solve], await dance(stiff)].map(({ frames }) => strain(frames, inside));
    expect(hard).toBeLessThan(0.6 * soft);
    expect((await dance(removeStiff("s1")(stiff))).frames.map(({ positions }) => positions)).toEqual(
      plain[solve].frames.map(({ positions }) => positions),
    );
  });

  test("a pose that turns a point twists the dance there, and only as far as it teaches", async () => {
    const at = 10;
    const twisted = async (turn: Vec3): Promise<Dance> =>
      dance(after(solveMesh(solve), addExample(await poseAt(at, solve, { top: turn }))));
    const [straight, turned] = [await twisted([0, 0, 0]), await twisted([0.8, 0, 0])];
    const { turns } = turned.performance;
    const angle = (f: number): number => turns?.[3 * (f * document.points.length + TOP)] ?? NaN;
    expect(angle(at)).toBeGreaterThan(0.5);
    expect(Math.min(...Array.from({ length: 20 }, (_, f) => angle(f)))).toBeLessThan(0.7 * angle(at));
    expect(straight.performance.turns).toBeNull();
    expect(turned.performance.controls).toEqual(straight.performance.controls);
    expect(twistOf(turned.frames[at], straight.frames[at])).toBeCloseTo(angle(at), 1);
    const again = await dance(after(solveMesh(solve), addExample(await poseAt(at, solve, { top: [0.8, 0, 0] }))));
    expect(again.frames[at].positions).toEqual(turned.frames[at].positions);
  });
});

const TOP = document.points.findIndex(({ joint }) => joint === "Head");

/** The dance at a frame as a pose, with turns of the top. */
async function poseAt(frame: number, solve: "surface" | "solid", { top }: { top: Vec3 }): Promise<Example> {
  const binding = new Binding(engine);
  const read = await binding.takeMotion(document, motion);
  const size = 3 * read.joints.length;
  const { controls } = plain[solve].performance;
  const stride = 3 * document.points.length;
  return {
    id: "turned",
    source: { motion: motion.name, frame },
    joints: sayPose(document, read, read.local.subarray(frame * size, (frame + 1) * size)).joints,
    points: pointsOfControls(model, document, controls.subarray(frame * stride, (frame + 1) * stride)),
    ...(top.some((way) => way !== 0) && { turns: { [document.points[TOP].id]: top } }),
  };
}

/** By how much the surroundings of the top are turned about the axis across in one frame against another, radians. */
function twistOf(a: Frame, b: Frame): number {
  const center = pointVertices(model, document.points)[TOP];
  const { scale } = stageFor(model, document.mesh);
  const near = (v: number): boolean =>
    v !== center && Math.hypot(...[0, 1, 2].map((k) => model.positions[3 * v + k] - model.positions[3 * center + k])) * scale < 0.15;
  let sine = 0;
  let cosine = 0;
  for (let v = 0; v < model.positions.length / 3; v++) {
    if (!near(v)) continue;
    const [p, q] = [a, b].map(({ positions }) => [1, 2].map((k) => positions[3 * v + k] - positions[3 * center + k]));
    sine += q[0] * p[1] - q[1] * p[0];
    cosine += q[0] * p[0] + q[1] * p[1];
  }
  return Math.atan2(sine, cosine);
}

test("a point listens to the whole pose as much as it says", async () => {
  const { id } = document.points[TOP];
  const weighing = async (wholePose: number): Promise<Float32Array> =>
    (await dance(after(setPoint(id, { wholePose })))).performance.controls;
  const usual = plain.surface.performance.controls;
  expect(await weighing(0.5)).toEqual(usual);
  const alone = await weighing(0);
  const changed = document.points.map((_, c) =>
    alone.some((value, i) => Math.floor(i / 3) % document.points.length === c && value !== usual[i]),
  );
  expect(changed).toEqual(document.points.map((_, c) => c === TOP));
});

test("pins that move on and pins as high as any other point are kept", async () => {
  const [a, b] = [TOP, document.points.findIndex(({ joint }) => joint === "LeftHand")];
  const { scale } = stageFor(model, document.mesh);
  const pin = (more: Partial<Pin>): Pin => ({ id: "n", point: document.points[a].id, frame: 9, kind: "place", ...more });
  const tracks = async (...pins: Pin[]): Promise<(c: number, f: number, k: number) => number> => {
    const { controls } = (await dance(after(setSettings({ groundContact: false }), ...pins.map(setPin)))).performance;
    return (c, f, k) => controls[3 * (f * document.points.length + c) + k];
  };
  const moves = await tracks(pin({ kind: "moves", velocity: [0.3, -0.6, 0.9] }));
  const velocity = [0, 1, 2].map((k) => (30 * (moves(a, 9, k) - moves(a, 8, k))) / scale);
  expect(velocity).toEqual([0.3, -0.6, 0.9].map((value) => expect.closeTo(value, 2)));
  const level = await tracks(pin({ kind: "level", other: document.points[b].id }));
  expect(level(a, 9, 1)).toBeCloseTo(level(b, 9, 1), 3);
  const free = plain.surface.performance.controls;
  expect(Math.abs(free[3 * (9 * document.points.length + a) + 1] - free[3 * (9 * document.points.length + b) + 1])).toBeGreaterThan(0.1);
});

test("as in the paper: another dance, and the same as before when it is switched off", async () => {
  const paper = await dance(after(setSettings({ paper: true })));
  const calm = await dance(after(setSettings({ paper: true, energy: 1, symmetry: false })));
  expect(paper.frames.every(({ positions }) => positions.every(Number.isFinite))).toBe(true);
  expect(calm.performance.controls).toEqual(paper.performance.controls);
  expect(paper.performance.controls).not.toEqual(plain.surface.performance.controls);
  const rest = document.points.map((_, c) => paper.performance.contacts[c]);
  expect(rest.length).toBe(document.points.length);
  const back = await dance(after(setSettings({ paper: true }), setSettings({ paper: false })));
  expect(back.frames.map(({ positions }) => positions)).toEqual(plain.surface.frames.map(({ positions }) => positions));
});
