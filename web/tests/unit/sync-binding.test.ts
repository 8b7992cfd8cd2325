import { afterEach, beforeEach, expect, test } from "vitest";

import { addPoint, pairPoint, setSettings, solveMesh, turnMesh } from "../../src/document/commands";
import { parseProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import type { Engine } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { bake } from "../../src/sync/bake";
import { Binding } from "../../src/sync/binding";
import { Workspace } from "../../src/sync/workspace";
import { asset } from "../support/files";
import { nod } from "./engine-support";

const { document } = parseProject(new TextDecoder().decode(asset("cactus/project.json").bytes), "project.json");
const model = await readModel([asset("cactus/cactus.glb")]);
const motion = nod(20);

let engine: Engine;
let calls: string[];

/** The engine itself; each call is written down. */
function written(real: Engine): Engine {
  return new Proxy(real, {
    get: (target, name: keyof Engine) => {
      const value = target[name] as (...args: unknown[]) => unknown;
      return (...args: unknown[]) => {
        calls.push(name);
        return value.apply(target, args);
      };
    },
  });
}

beforeEach(async () => {
  calls = [];
  engine = written(await createNodeEngine());
});
afterEach(() => engine.close());

test("each part of a document is told once, and again when it has changed", async () => {
  const binding = new Binding(engine);
  const dances = async (changed: ProjectDocument): Promise<string[]> => {
    calls = [];
    await binding.take(changed, { model, motion });
    if (!binding.isSolved(changed)) await binding.solve(changed);
    return calls;
  };
  expect(await dances(document)).toEqual(["setMesh", "setControls", "setMotion", "retarget"]);
  expect(await dances(document)).toEqual([]);
  expect(await dances(setSettings({ volume: 2 })(document))).toEqual(["retarget"]);
  expect(await dances(pairPoint(document.points[0].id, null)(document))).toEqual(["retarget"]);
  const more = addPoint({ ...document.points[0], id: "more", radius: 0.2 })(document);
  expect(await dances(more)).toEqual(["setControls", "retarget"]);
  expect(await dances(turnMesh("+x", "+y")(more))).toEqual(["setMesh", "setControls", "retarget"]);
  await expect(new Binding(engine).solve(document)).rejects.toMatchObject({ code: "bad_mesh" });
});

test("the page and the command line get the same frames, to the bit", async () => {
  for (const solve of ["surface", "solid"] as const) {
    const chosen = solveMesh(solve)(document);
    const baked = await bake(new Binding(engine), chosen, { model, motion });
    const workspace = new Workspace(
      () => present,
      () => engine,
    );
    const file = workspace.library.addModel("cactus.glb", model);
    const present = { ...chosen, mesh: { ...chosen.mesh, file }, motion: { files: workspace.library.addMotion(["nod.bvh"], motion) } };
    const exported = await workspace.vertexFrames({});
    do await workspace.sync();
    while (workspace.cache.staleCount > 0);
    expect(workspace.cache.length).toBe(20);
    const plays = workspace.cache.at(7)?.shape;
    if (solve === "surface") expect(plays).toEqual(baked.frames[7].positions);
    else expect(plays?.length).toBe(4 * (workspace.report?.solid?.nodes.length ?? 0));
    baked.frames.forEach(({ positions, root }, f) => {
      expect(exported[f].positions).toEqual(positions);
      expect(workspace.cache.at(f)?.root).toEqual(root);
    });
  }
});
