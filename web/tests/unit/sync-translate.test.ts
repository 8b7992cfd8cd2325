import { describe, expect, it } from "vitest";

import { addExample, addPoint, newDocument } from "../../src/document/commands";
import { pointFromStage } from "../../src/document/stage-transform";
import type { ProjectDocument } from "../../src/document/types";
import { readModel } from "../../src/io/read-model";
import { detailed } from "../../src/sync/details";
import { stageFor } from "../../src/sync/placement";
import { exampleControls, pointsOfControls, pointVertices, restControls } from "../../src/sync/point-controls";
import { controlInputs, meshInput, retargetInput } from "../../src/sync/translate";
import { namedJoints } from "../support/joints";
import { TETRAHEDRON, textFile } from "../support/files";

const joints = namedJoints("root", "lfoot", "head");

const document: ProjectDocument = [
  addPoint({ id: "a", name: "top", position: [0.1, 0.9, 0], joint: "head" }),
  addPoint({ id: "b", name: "paw", position: [0.9, 0, 0], joint: "mixamorig:LeftFoot", radius: 0.1 }),
  addPoint({ id: "c", name: "back", position: [0, 0, 0], joint: null }),
  addPoint({ id: "d", name: "fin", position: [0, 0, 1], joint: "dorsal" }),
  addExample({ id: "1", source: { motion: "m", frame: 0 }, joints: { Root: [0, 0, 0], head: [0, 1, 0] }, points: { a: [0, 2, 0] } }),
  addExample({ id: "2", source: { motion: "m", frame: 0 }, joints: { tentacle: [1, 2, 3] }, points: {} }),
].reduce((d, command) => command(d), newDocument("t", { file: "t.obj", facing: "-x", up: "+z" }, { files: ["m.asf", "m.amc"] }));

describe("what the engine is asked", async () => {
  const model = await readModel([textFile("t.obj", TETRAHEDRON)]);
  const stage = stageFor(model, document.mesh);

  it("mesh on the stage", () => {
    const { positions, faces } = meshInput(model, document.mesh);
    expect(faces).toBe(model.faces);
    expect(stage.scale).toBeCloseTo(1.7, 6);
    // file z is up; file -x is +z of the stage, so file y is its -x
    expect([...positions]).toEqual([0.85, 0, 0.85, -0.85, 0, 0.85, 0.85, 0, -0.85, 0.85, 1.7, 0.85].map((x) => expect.closeTo(x, 5)));
  });

  it("controls at the nearest vertex, discs in metres", () => {
    expect(pointVertices(model, document.points).map((v) => [...model.positions.subarray(3 * v, 3 * v + 3)])).toEqual([
      [0, 1, 0],
      [1, 0, 0],
      [0, 0, 0],
      [0, 0, 1],
    ]);
    expect(controlInputs(model, document).map(({ radius }) => radius)).toEqual(
      [0.085, 0.17, 0.085, 0.085].map((r) => expect.closeTo(r, 9)),
    );
  });

  it("two points on one spot get two vertices", () => {
    const twice = [document.points[0], { ...document.points[0], id: "again" }];
    const [a, b] = pointVertices(model, twice);
    expect(a).not.toBe(b);
  });

  it("pairs by role, and the settings", () => {
    const input = retargetInput(model, document, { joints, frames: 60 });
    expect([...input.pairs]).toEqual([2, 1, -1, -1]);
    const { symmetry: _, ...settings } = document.settings;
    expect(input).toMatchObject(settings);
  });

  it("pins on the stage, contacts and flights as far as the clip goes, partners that agree with each other", () => {
    const points = document.points.map((point) => ({
      ...point,
      ...{ a: { mirror: "a" }, b: { mirror: "d" }, c: { mirror: "b" }, d: { mirror: "b" } }[point.id],
    }));
    const said: ProjectDocument = {
      ...document,
      points,
      clips: {
        "m.amc": {
          pins: [
            { id: "1", point: "b", frame: 59, kind: "place", position: [0, 2, 0] },
            { id: "2", point: "a", frame: 3, kind: "still" },
            { id: "3", point: "a", frame: 60, kind: "still" },
            { id: "4", point: "a", other: "b", frame: 3, kind: "level" },
          ],
          contacts: {
            d: [
              [0, 5],
              [50, 90],
            ],
            a: [],
          },
          flights: [
            [50, 80],
            [70, 80],
          ],
        },
      },
    };
    const clip = { joints, frames: 60 };
    const input = detailed(retargetInput(model, said, clip), model, said, clip);
    expect(input.constraints).toHaveLength(3);
    expect(input.constraints?.[0]).toMatchObject({ control: 1, frame: 59, fromControl: -1, x: true, y: true, z: true });
    expect(pointFromStage(stage, (input.constraints?.[0] as { value: [number, number, number] }).value)).toEqual(
      [0, 2, 0].map((v) => expect.closeTo(v, 5)),
    );
    expect(input.constraints?.[1]).toMatchObject({ control: 0, frame: 3, fromControl: 0, fromFrame: 2, value: [0, 0, 0] });
    expect(input.constraints?.[2]).toEqual({
      control: 0,
      frame: 3,
      fromControl: 1,
      fromFrame: 3,
      value: [0, 0, 0],
      x: false,
      y: true,
      z: false,
    });
    expect(input.contacts).toEqual([
      { control: 0, runs: [] },
      {
        control: 3,
        runs: [
          [0, 5],
          [50, 60],
        ],
      },
    ]);
    expect(input.flights).toEqual([[50, 59]]);
    expect([...(input.mirror ?? [])]).toEqual([0, 3, -1, 1]);
    expect(retargetInput(model, { ...said, settings: { ...said.settings, symmetry: false } }, { joints, frames: 60 }).mirror).toBeNull();
    expect(detailed(retargetInput(model, document, clip), model, document, clip)).toMatchObject({
      constraints: [],
      contacts: [],
      flights: null,
      mirror: null,
    });
  });

  it("examples in the motion's order, NaN for joints that they do not know, rest for points that they do not name", () => {
    const { examples } = retargetInput(model, document, { joints, frames: 60 });
    expect(examples).toHaveLength(1);
    expect([...examples[0].joints]).toEqual([0, 0, 0, NaN, NaN, NaN, 0, 1, 0]);
    const rest = restControls(model, document);
    expect([...examples[0].controls.subarray(3)]).toEqual([...rest.subarray(3)]);
    const [x, y, z] = examples[0].controls;
    expect(pointFromStage(stage, [x, y, z])).toEqual([0, 2, 0].map((v) => expect.closeTo(v, 5)));
  });

  it("and back: controls as an example holds them", () => {
    const points = { a: [0.5, 2, 1], b: [3, 0, 0.25], c: [0, 0, 0], d: [0, -1, 1] } as const;
    const back = pointsOfControls(model, document, exampleControls(model, document, { points }));
    for (const [id, place] of Object.entries(points)) expect(back[id]).toEqual(place.map((x) => expect.closeTo(x, 5)));
  });
});
