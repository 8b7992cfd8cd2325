// A model that brings clips dances them as they were made.

import { expect, test } from "vitest";
import { newDocument } from "../../src/document/commands";
import type { Point, Vec3 } from "../../src/document/types";
import { createNodeEngine } from "../../src/engine/node";
import { readClips } from "../../src/io/clips/read-clips";
import { ownDance } from "../../src/io/own-dance";
import { readModel } from "../../src/io/read-model";
import { pointVertices } from "../../src/sync/point-controls";
import { GltfMaker } from "../support/gltf";
import { sphere } from "../support/surfaces";

/** A snowman whose head, 2 above his hips, nods by a quarter turn within a second, while the hips go 3 along x. */
function nodding() {
  const maker = new GltfMaker();
  const { positions, index } = sphere(12, 9);
  maker.mesh({ attributes: { POSITION: maker.floats([...positions]) }, indices: maker.shorts([...index]) });
  maker.json.nodes = [
    { name: "Hips", mesh: 0, children: [1] },
    { name: "Head", mesh: 0, translation: [0, 2, 0] },
  ];
  maker.json.scenes = [{ nodes: [0] }];
  const times = Array.from({ length: 31 }, (_, k) => k / 30);
  const nods = times.flatMap((t) => [Math.sin((t * Math.PI) / 4), 0, 0, Math.cos((t * Math.PI) / 4)]);
  maker.json.animations = [
    {
      name: "Nod",
      channels: [
        { sampler: 0, target: { node: 1, path: "rotation" } },
        { sampler: 1, target: { node: 0, path: "translation" } },
      ],
      samplers: [
        { input: maker.floats(times, "SCALAR"), output: maker.floats(nods, "VEC4"), interpolation: "LINEAR" },
        { input: maker.floats(times, "SCALAR"), output: maker.floats(times.flatMap((t) => [3 * t, 0, 0])), interpolation: "LINEAR" },
      ],
    },
  ];
  return maker.glb("snowman.glb");
}

test("its points hang on its own joints, and poses show where these take them", async () => {
  const engine = await createNodeEngine();
  try {
    const file = nodding();
    const model = await readModel([file]);
    const [{ motion: clip }] = await readClips([file]);
    const motion = await engine.setMotion(clip.input);
    const point = (id: string, position: Vec3): Point => ({ id, name: id, position, joint: null });
    const points = [point("crown", [0, 3, 0]), point("belly", [0, 0, 1])];
    const mesh = { file: file.name, facing: "+z", up: "+y", solve: "solid" } as const;
    const document = { ...newDocument("snowman", mesh, { files: clip.files }), points };
    const danced = ownDance(model, document, [point("nose", [0, 2, 1])], motion, clip)?.(document);
    expect(danced?.points.map(({ id, joint }) => [id, joint])).toEqual([
      ["crown", "Head"],
      ["belly", "Hips"],
    ]);
    const last = danced?.examples.at(-1);
    expect(last?.source).toEqual({ motion: clip.input.name, frame: 30 });
    const [crown, belly] = pointVertices(model, points).map((v) => [...model.positions.subarray(3 * v, 3 * v + 3)]);
    [crown[0], 2 - crown[2], crown[1] - 2].forEach((x, k) => expect(last?.points.crown[k]).toBeCloseTo(x, 3));
    belly.forEach((x, k) => expect(last?.points.belly[k]).toBeCloseTo(x, 3));
    expect(danced?.examples.length).toBeGreaterThan(10);
    const { moves: _, ...another } = clip;
    expect(ownDance(model, document, [], motion, another)).toBeNull();
  } finally {
    engine.close();
  }
});
