// A solid's frames as they are drawn: maps of its nodes, which carry the vertices to where the core carries them.

import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, test } from "vitest";
import { EngineClient } from "../../src/engine/client";
import { channelWorker } from "../../src/engine/node";
import type { Engine, Frame, MeshInput, ShapedFrame, SolidCells } from "../../src/engine/types";
import { mapsToWorld, toWorld } from "../../src/sync/placement";
import { carryVertices, restMaps } from "../../src/util/solid-cells";
import { nod, post, postControls, restControls } from "./engine-support";

const wasm = (name: string) => new Uint8Array(readFileSync(new URL(`../../src/engine/${name}`, import.meta.url))).buffer;
let engine: Engine;

beforeEach(() => {
  engine = new EngineClient(channelWorker(), wasm("rigless.wasm"), async () => wasm("shape-analysis.wasm"));
});
afterEach(() => engine.close());

async function solidPost(rings: number): Promise<{ mesh: MeshInput; solid: SolidCells }> {
  const mesh = post(rings);
  const { solid } = await engine.setMesh({ ...mesh, solve: "solid" });
  if (!solid) throw new Error("No solid was solved.");
  await engine.setControls(postControls(mesh));
  return { mesh, solid };
}

async function retargeted(rings: number): Promise<{ mesh: MeshInput; solid: SolidCells; frames: Frame[]; shapes: ShapedFrame[] }> {
  const made = await solidPost(rings);
  await engine.setMotion(nod(40));
  const settings = { examples: [], smoothness: 0.3, volume: 1, groundContact: false, inPlace: false };
  await engine.retarget({ pairs: Int32Array.of(0, 1), ...settings });
  const frames: Frame[] = [];
  const shapes: ShapedFrame[] = [];
  await engine.shapes([30, 3], (f, frame) => (shapes[f] = frame));
  await engine.frames([3, 30], (f, frame) => (frames[f] = frame));
  return { ...made, frames, shapes };
}

function carried(solid: SolidCells, { positions }: MeshInput, maps: Float32Array): Float32Array {
  const out = new Float32Array(positions.length);
  carryVertices(solid, positions, maps, Array.from(solid.elementOf.keys()), out);
  return out;
}

const worst = (a: Float32Array, b: Float32Array): number => a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i]!)), 0);

test("a frame that is drawn is the maps of the nodes, however many vertices they carry to where the core does", async () => {
  const few = await retargeted(9);
  const many = await retargeted(400);
  expect(many.mesh.positions.length).toBeGreaterThan(40 * few.mesh.positions.length);
  for (const { mesh, solid, frames, shapes } of [few, many]) {
    for (const f of [3, 30]) {
      const { shape, root, volumeRatio } = shapes[f]!;
      expect(shape.length).toBe(4 * solid.nodes.length);
      expect({ root, volumeRatio }).toEqual({ root: frames[f]!.root, volumeRatio: frames[f]!.volumeRatio });
      expect(worst(carried(solid, mesh, shape), frames[f]!.positions)).toBeLessThan(2e-6);
      expect(worst(mesh.positions, frames[f]!.positions)).toBeGreaterThan(0.05);
    }
  }
  expect(many.shapes[3]!.shape.byteLength).toBeLessThan(250_000);
});

test("a drag answers them too, in the body's own place; they are put into the world as vertices are", async () => {
  const { mesh, solid } = await solidPost(40);
  const targets = restControls(mesh, postControls(mesh));
  targets[3] += 0.4;
  const { shape } = await engine.drag(targets, { volume: 1, restart: true });
  expect(shape.length).toBe(4 * solid.nodes.length);
  const local = carried(solid, mesh, shape);
  expect(worst(local, mesh.positions)).toBeGreaterThan(0.2);
  const root = [0.3, 0.02, -1, 0.7] as ShapedFrame["root"];
  expect(worst(carried(solid, mesh, mapsToWorld(shape, root)), toWorld(local, root))).toBeLessThan(2e-6);
});

test("where the surface is solved there is no solid, and a shape is its vertices", async () => {
  const mesh = post();
  expect((await engine.setMesh(mesh)).solid).toBeNull();
  const controls = postControls(mesh);
  await engine.setControls(controls);
  expect((await engine.drag(restControls(mesh, controls), { volume: 1 })).shape.length).toBe(mesh.positions.length);
});

test("at rest the nodes' maps leave every vertex where it is", async () => {
  const { mesh, solid } = await solidPost(20);
  expect(worst(carried(solid, mesh, restMaps(solid)), mesh.positions)).toBeLessThan(1e-6);
});
