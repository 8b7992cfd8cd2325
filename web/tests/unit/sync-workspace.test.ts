import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, test } from "vitest";
import { setSettings } from "../../src/document/commands";
import { parseProject } from "../../src/document/project";
import { DocumentStore } from "../../src/document/store";
import type { ProjectDocument } from "../../src/document/types";
import { EngineClient } from "../../src/engine/client";
import { channelWorker } from "../../src/engine/node";
import type { Engine } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { Workspace } from "../../src/sync/workspace";

const asset = (path: string): Uint8Array => new Uint8Array(readFileSync(new URL(`../../assets/${path}`, import.meta.url)));
const text = (path: string): string => new TextDecoder().decode(asset(path));

let store: DocumentStore;
let workspace: Workspace;
let engines: Engine[];
let told: string[];

/** The cactus with the first second of its hop. */
async function cactus(): Promise<ProjectDocument> {
  const { document } = parseProject(text("cactus/project.json"), "project.json");
  const hop = text("motions/hop.bvh");
  const lines = hop.trimEnd().split("\n");
  const at = lines.findIndex((line) => line.startsWith("Frames:"));
  const short = [...lines.slice(0, at), "Frames: 30", ...lines.slice(at + 1, at + 2 + 30)].join("\n");
  const bytes = asset("cactus/cactus.glb");
  const file = workspace.library.addModel("cactus.glb", await readModel([{ name: "cactus.glb", bytes }]));
  const files = workspace.library.addMotion(["hop.bvh"], { name: "hop.bvh", text: short });
  return { ...document, mesh: { ...document.mesh, file }, motion: { files } };
}

beforeEach(async () => {
  engines = [];
  told = [];
  const create = (): Engine => {
    const wasm = new Uint8Array(readFileSync(new URL("../../src/engine/rigless.wasm", import.meta.url))).buffer;
    const engine = new EngineClient(channelWorker(), wasm, () => Promise.reject(new Error("not asked for")));
    engines.push(engine);
    return engine;
  };
  workspace = new Workspace(() => store.document, create);
  for (const name of ["mesh", "motion", "performance", "failed", "recovered"] as const) workspace.on(name, () => told.push(name));
  store = new DocumentStore(await cactus());
  store.subscribe(() => void workspace.sync());
});

afterEach(() => workspace.close());

/** Waits for the newest document's dance. */
async function danced(): Promise<Float32Array[]> {
  do await workspace.sync();
  while (workspace.cache.staleCount > 0);
  return Array.from({ length: workspace.cache.length }, (_, f) => workspace.cache.at(f)?.shape ?? new Float32Array(0));
}

test("a document is bound, solved and baked; nothing is done again without need", async () => {
  const frames = await danced();
  expect(told).toEqual(["mesh", "motion", "performance"]);
  expect(frames.length).toBe(30);
  expect(frames[0]?.length).toBe(3 * (workspace.report?.vertices ?? 0));
  expect(frames[0]).not.toEqual(frames[20]);
  await workspace.sync();
  expect(told.length).toBe(3);
});

test("a setting re-solves only the dance, and back again is the same to the bit", async () => {
  const before = await danced();
  store.apply(setSettings({ volume: 2.5, smoothness: 0.05 }));
  const juicy = await danced();
  expect(told).toEqual(["mesh", "motion", "performance", "performance"]);
  expect(juicy).not.toEqual(before);
  store.undo();
  expect(await danced()).toEqual(before);
});

test("of changes that come fast the last one holds", async () => {
  await danced();
  for (const volume of [0.2, 0.9, 1.7, 2.2, 3]) {
    store.apply(setSettings({ volume }));
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  const last = await danced();
  store.apply(setSettings({ volume: 1 }));
  await danced();
  store.undo();
  expect(await danced()).toEqual(last);
});

test("turning the model binds it anew", async () => {
  const before = await danced();
  store.apply((document) => ({ ...document, mesh: { ...document.mesh, facing: "+x" } }));
  const turned = await danced();
  expect(told).toEqual(["mesh", "motion", "performance", "mesh", "performance"]);
  expect(turned).not.toEqual(before);
});

test("a lost engine is replaced and told everything again", async () => {
  const before = await danced();
  engines[0]?.close();
  store.apply(setSettings({ volume: 2 }));
  await danced();
  expect(told).toContain("recovered");
  expect(engines.length).toBe(2);
  store.undo();
  expect(await danced()).toEqual(before);
  expect(told).not.toContain("failed");
});

test("what the engine refuses is refused before it is the document; the dance stays", async () => {
  const before = await danced();
  const files = workspace.library.addMotion(["bad.bvh"], { name: "bad.bvh", text: "HIERARCHY\nROOT Hips\n{\n" });
  await expect(workspace.tryOn({ ...store.document, motion: { files } })).rejects.toMatchObject({
    code: "bad_motion",
    message: expect.stringContaining("bad.bvh"),
  });
  const flat = workspace.library.addModel("flat.obj", { positions: new Float32Array(9), faces: Uint32Array.of(0, 1, 7) });
  await expect(workspace.tryOn({ ...store.document, mesh: { ...store.document.mesh, file: flat } })).rejects.toMatchObject({
    code: "bad_mesh",
  });
  expect(await danced()).toEqual(before);
  expect(told).not.toContain("failed");
});

test("without points there is nothing to solve", async () => {
  await danced();
  store.apply((document) => ({ ...document, points: [], examples: [] }));
  await workspace.sync();
  expect(workspace.performance).toBeNull();
  expect(workspace.cache.length).toBe(0);
  store.undo();
  expect((await danced()).length).toBe(30);
});

test("a drag deforms towards the hand", async () => {
  await danced();
  const controls = store.document.points.length;
  const targets = workspace.performance?.controls.slice(0, 3 * controls) ?? new Float32Array(0);
  targets[1] += 0.2;
  workspace.hold();
  const frame = await workspace.drag(targets, true);
  expect(frame.shape.length).toBe(3 * (workspace.report?.vertices ?? 0));
  expect(frame.shape.every(Number.isFinite)).toBe(true);
  workspace.release();
});
