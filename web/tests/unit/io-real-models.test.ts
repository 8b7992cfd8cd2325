import { describe, expect, it } from "vitest";

import { readModel } from "../../src/io/read-model";
import { hasShared, sharedFile } from "../support/files";

describe.skipIf(!hasShared)("common research models (skipped where ../shared/data is absent)", () => {
  it.each([
    ["spot.obj", 2930, 5856, 3239],
    ["cow.obj", 2903, 5804, 3365],
    ["cheburashka.off", 6669, 13334, 6913],
    ["knight.off", 502, 1000, 786],
    ["armadillo.obj", 43243, 86482, 43462],
  ])("%s: %d vertices, %d faces, %d as drawn, creases split", async (name, vertices, faces, drawn) => {
    const model = await readModel([sharedFile(`meshes/${name}`)]);
    expect(model.name).toBe(name);
    expect(model.positions.length / 3).toBe(vertices);
    expect(model.faces.length / 3).toBe(faces);
    expect(model.drawn.positions.length / 3).toBe(drawn);
    expect(model.drawn.index.map((r) => model.drawn.toVertex[r])).toEqual(model.faces);
    expect(model.notes).toEqual([]);
  });
});
