import { afterAll, beforeAll, describe, expect, it } from "vitest";

import { createNodeEngine } from "../../src/engine/node";
import type { BodyRole, Engine, MeshInput, ShapeAnalysis } from "../../src/engine/types";
import { readModel } from "../../src/io/read-model";
import { hasShared, sharedFile } from "../support/files";
import { post } from "./engine-support";

let engine: Engine;
beforeAll(async () => void (engine = await createNodeEngine()));
afterAll(() => engine.close());

async function shared(file: string): Promise<MeshInput> {
  const { positions, faces } = await readModel([sharedFile(`meshes/${file}`)]);
  return { positions, faces };
}

const wanted = (u: ShapeAnalysis): Partial<Record<BodyRole, number>> => {
  const counts: Partial<Record<BodyRole, number>> = {};
  for (const { wanted, role } of u.points) if (wanted) counts[role] = (counts[role] ?? 0) + 1;
  return counts;
};

/** z up, looking along -y: as scans and prints come. */
const scanned = ({ positions, faces }: MeshInput): MeshInput => ({
  positions: Float32Array.from(positions, (_, i) => (i % 3 === 0 ? positions[i] : i % 3 === 1 ? -positions[i + 1] : positions[i - 1])),
  faces,
});

describe.skipIf(!hasShared)("models that everybody knows (skipped where ../shared/data is absent)", () => {
  const human = { head: 1, hand: 2, foot: 2, hips: 1, chest: 1 };
  const beast = { head: 1, foreleg: 2, foot: 2, hips: 1, chest: 1 };
  it.each([
    ["spot.obj", "-z", beast],
    ["cow.obj", "+x", beast],
    ["cheburashka.off", "+z", human],
    ["armadillo.obj", "+z", human],
    ["knight.off", "+z", human],
  ] as const)("%s stands up, looks along %s and has its limbs", async (file, facing, limbs) => {
    const u = await engine.analyseShape(await shared(file));
    expect(u).toMatchObject({ up: "+y", facing });
    expect(wanted(u)).toEqual(limbs);
    expect(u.symmetry?.misfit).toBeLessThan(0.02);
    u.points.forEach(({ partner, side }, n) => {
      if (partner >= 0)
        expect(u.points[partner]).toMatchObject({ partner: n, side: side === null ? null : side === "left" ? "right" : "left" });
    });
    for (const point of u.points) if (point.wanted) expect(point.partner).toBeGreaterThanOrEqual(0);
  });

  it("knows a model that lies on its back in its file, as scans do", async () => {
    expect(await engine.analyseShape(scanned(await shared("cheburashka.off")))).toMatchObject({ up: "+z", facing: "-y" });
    expect(await engine.analyseShape(scanned(await shared("spot.obj")))).toMatchObject({ up: "+z", facing: "+y" });
  });
});

it("holds a post by its top, its trunk and both edges of its base", async () => {
  const u = await engine.analyseShape(post());
  expect(u).toMatchObject({ up: "+y", facing: "+z" });
  expect(wanted(u)).toEqual({ head: 1, foot: 2, hips: 1, chest: 1 });
  const foot = u.points.find((point) => point.role === "foot" && point.side === "left");
  expect(post().positions[3 * (foot?.vertex ?? 0)]).toBeGreaterThan(0.15);
});

it("binds nothing and refuses what is no mesh", async () => {
  const report = await engine.setMesh(post());
  await engine.analyseShape(post(5));
  await engine.setControls([{ vertex: report.vertices - 1, radius: 0.1 }]);
  const triangle = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  expect((await engine.analyseShape({ positions: triangle, faces: Uint32Array.of(0, 1, 2) })).points.length).toBeGreaterThan(0);
  await expect(engine.analyseShape({ positions: triangle, faces: Uint32Array.of(0, 1, 3) })).rejects.toMatchObject({ code: "bad_mesh" });
  await expect(engine.analyseShape({ positions: triangle, faces: new Uint32Array(0) })).rejects.toMatchObject({ code: "bad_mesh" });
  await expect(engine.analyseShape({ positions: triangle.with(4, NaN), faces: Uint32Array.of(0, 1, 2) })).rejects.toMatchObject({
    code: "bad_mesh",
  });
  const aborted = AbortSignal.abort();
  await expect(engine.analyseShape(post(), { signal: aborted })).rejects.toMatchObject({ code: "cancelled" });
});
