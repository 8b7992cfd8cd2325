import { describe, expect, it } from "vitest";
import { clipOf, saidOf } from "../../src/document/clips";
import { newDocument, setMesh } from "../../src/document/commands";
import {
  BESIDE,
  companionDocument,
  companionOf,
  moveCompanion,
  setCompanion,
  setCompanionMotion,
  swapDancers,
} from "../../src/document/duet";
import { parseProject, serializeProject } from "../../src/document/project";
import type { Offset, ProjectDocument } from "../../src/document/types";

const alone = (file: string, motion: string): ProjectDocument => ({
  ...newDocument(file, { file: `${file}.glb`, facing: "+z", up: "+y" }, { files: [motion] }),
  points: [{ id: "p1", name: "head", position: [0, 1, 0], joint: "Head" }],
});
const cow = alone("cow", "walk.bvh");
const lamp = alone("lamp", "hop.bvh");
const offset: Offset = { seconds: 0.5, place: [1.6, -0.4], yaw: 0.3 };
const duet = setCompanion(companionOf(lamp, offset, null))(cow);
const own = setCompanion(companionOf(lamp, offset, lamp.motion))(cow);

/** A file as anybody may have written it. */
type Loose = { mesh?: unknown; performers: Record<string, Record<string, unknown> & unknown[]>[] };

describe("a project of two", () => {
  it.each([duet, own])("comes back as it went, as version 2", (document) => {
    const text = serializeProject(document);
    expect(JSON.parse(text)).toMatchObject({ version: 2, name: "cow", performers: [{ mesh: { file: "cow.glb" } }, { offset }] });
    expect(parseProject(text, "duet.json").document).toEqual(document);
  });

  it("is of version 1 once the second has gone", () => {
    expect(serializeProject(setCompanion(null)(duet))).toBe(serializeProject(cow));
  });

  it("may hold one, and a companion without an offset stands where the other one does", () => {
    const file = JSON.parse(serializeProject(duet));
    delete file.performers[1].offset;
    expect(parseProject(JSON.stringify(file), "x").document.companion?.offset).toEqual({ seconds: 0, place: [0, 0], yaw: 0 });
    file.performers.pop();
    expect(parseProject(JSON.stringify(file), "x").document).toEqual(cow);
  });

  it.each([
    ["performers[0].motion is missing.", (file: Loose) => delete file.performers[0].motion],
    [
      "performers[0].offset is not a field that Rigless knows: the other one's is told from where this one is.",
      (file: Loose) => Object.assign(file.performers[0], { offset: {} }),
    ],
    ["performers[1].offset.place should be two numbers, but it has 3.", (file: Loose) => (file.performers[1].offset.place = [1, 2, 3])],
    ["performers[1].mesh.file is missing.", (file: Loose) => delete file.performers[1].mesh.file],
    [
      'performers[1].points[1].id is "p1", which another point has already.',
      (file: Loose) => file.performers[1].points.push(cow.points[0]),
    ],
    ["performers should be a list of 1 to 2 objects, but it has 3.", (file: Loose) => file.performers.push(file.performers[1])],
    ["mesh is not a field that Rigless knows.", (file: Loose) => (file.mesh = cow.mesh)],
  ])("names the field: %s", (message, spoil) => {
    const file = JSON.parse(serializeProject(duet));
    spoil(file);
    expect(() => parseProject(JSON.stringify(file), "duet.json")).toThrow(`duet.json: ${message}`);
  });
});

describe("a companion", () => {
  it("dances as the one in hand is cut and sped up, with pins of its own", () => {
    const pins = [{ id: "n1", point: "p1", frame: 9, kind: "place", position: [0, 1, 0] }] as const;
    const said: ProjectDocument = {
      ...duet,
      clips: { "walk.bvh": { cut: [4, 40], speed: 2, loop: true, flights: [[5, 6]] } },
      companion: { ...duet.companion!, clips: { "walk.bvh": { pins, speed: 0.5 } } },
    };
    const beside = companionDocument(said)!;
    expect(beside.motion).toEqual(cow.motion);
    expect(saidOf(beside)).toEqual({ cut: [4, 40], speed: 2, loop: true, pins });
    const moved = companionDocument(moveCompanion({ seconds: 2 })(said))!;
    expect(clipOf(moved)).toBe(clipOf(beside)); // so nothing is solved again
    expect(saidOf(companionDocument(own)!)).toEqual({});
  });

  it("that gets a motion of its own goes on as it was", () => {
    const sped: ProjectDocument = { ...duet, clips: { "walk.bvh": { speed: 2 } } };
    const apart = setCompanionMotion(sped.motion)(sped);
    expect(saidOf(companionDocument(apart)!)).toEqual({ speed: 2 });
    expect(setCompanionMotion(null)(apart).companion?.motion).toBeUndefined();
    expect(setCompanionMotion(null)(duet)).toBe(duet);
  });

  it("stays when the one in hand gets another model, and knows when nothing has changed", () => {
    expect(setMesh({ file: "x.obj", facing: "+z", up: "+y" })(duet).companion).toBe(duet.companion);
    expect(moveCompanion({ place: [1.6, -0.4] })(duet)).toBe(duet);
    expect(moveCompanion({ yaw: 1 })(cow)).toBe(cow);
    expect(companionDocument(cow)).toBeNull();
  });

  it.each([duet, own])("that is taken in hand leaves both where they are; twice is as before", (document) => {
    const swapped = swapDancers(document);
    expect([swapped.name, swapped.mesh.file, swapped.companion?.mesh.file]).toEqual(["cow", "lamp.glb", "cow.glb"]);
    expect(swapped.companion?.offset.seconds).toBe(-0.5);
    expect(swapDancers(swapped)).toEqual(document);
    expect(BESIDE.place[0]).toBeGreaterThan(0);
  });
});

it("nobody goes or is put where no project file reaches", () => {
  const far = moveCompanion({ place: [1e9, -1e9], yaw: 0.8 })(duet);
  for (const document of [far, swapDancers(far)]) expect(parseProject(serializeProject(document), "x").document).toEqual(document);
});
