import { existsSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { describe, expect, it } from "vitest";

import { readModel } from "../../src/io/read-model";

const data = new URL("../../../../shared/data/meshes/", import.meta.url);

describe.skipIf(!existsSync(data))("common research models (skipped where ../shared/data is absent)", () => {
  it.each([
    ["spot.obj", 2930, 5856, 3225],
    ["cow.obj", 2903, 5804, 2903],
    ["cheburashka.off", 6669, 13334, 6669],
    ["knight.off", 502, 1000, 502],
    ["armadillo.obj", 43243, 86482, 43243],
  ])("%s: %d vertices, %d faces, %d as drawn", async (name, vertices, faces, drawn) => {
    const model = await readModel([{ name, bytes: readFileSync(new URL(name, data)) }]);
    expect(model.name).toBe(basename(name));
    expect(model.positions.length / 3).toBe(vertices);
    expect(model.faces.length / 3).toBe(faces);
    expect(model.drawn.positions.length / 3).toBe(drawn);
    expect(model.drawn.index.map((r) => model.drawn.toVertex[r])).toEqual(model.faces);
    expect(model.notes).toEqual([]);
  });
});
