import Ajv from "ajv/dist/2020";
import { describe, expect, it } from "vitest";

import { DocumentError, parseProject, serializeProject } from "../../src/document/project";
import schema from "../../src/document/project-schema.json";
import { KEYWORDS } from "../../src/document/schema";
import type { ProjectDocument } from "../../src/document/types";

const project: ProjectDocument = {
  version: 1,
  name: 'Cow "walk"\n[ 1, 2 ]',
  mesh: { file: "cow.obj", facing: "+x", up: "+y" },
  motion: { files: ["02.asf", "02_01.amc"] },
  points: [
    { id: "p1", name: "left hand", position: [0.1, -2e-7, 3], joint: "lhand" },
    { id: "p2", name: "top", position: [1, 2, 3], joint: null, radius: 0.1, mirror: "p2" },
  ],
  examples: [
    { id: "e1", source: { motion: "02_01.amc", frame: 12 }, joints: { root: [0, 0, 0], lhand: [1, 2, 3] }, points: { p1: [1, 1, 1] } },
    { id: "e2", source: { motion: "02_01.amc", frame: 40 }, joints: { root: [0, 0, 0] }, points: {} },
  ],
  joints: { lhand: "left hand", root: "hips" },
  clips: {
    "02_01.amc": {
      pins: [
        { id: "n1", point: "p1", frame: 30, kind: "place", position: [1, 0, 2] },
        { id: "n2", point: "p1", frame: 31, kind: "still" },
        { id: "n3", point: "p1", frame: 40, kind: "level", other: "p2" },
      ],
      contacts: {
        p1: [
          [0, 14],
          [40, 61],
        ],
        p2: [],
      },
      flights: [[70, 82]],
    },
  },
  settings: { volume: 1, smoothness: 0.3, energy: 0.5, groundContact: true, inPlace: false, symmetry: false },
};

type Path = readonly (string | number)[];
type Branch = Record<string | number, unknown>;

/** A copy with another value at a path; undefined takes the field away. */
function altered(path: Path, value: unknown): ProjectDocument {
  const copy = structuredClone(project);
  const owner = path.slice(0, -1).reduce((at: unknown, key) => (at as Branch)[key], copy) as Branch;
  const key = path[path.length - 1];
  if (value === undefined) delete owner[key];
  else owner[key] = value;
  return copy;
}

function messageOf(text: string): string {
  try {
    parseProject(text, "cow.json");
  } catch (error) {
    expect(error).toBeInstanceOf(DocumentError);
    return (error as DocumentError).message;
  }
  throw new Error("was accepted");
}

describe("project files", () => {
  it("come back as they went", () => {
    const text = serializeProject(project);
    expect(parseProject(text, "cow.json").document).toEqual(project);
    expect(serializeProject(parseProject(text, "cow.json").document)).toBe(text);
    expect(text).toContain('"position": [0.1, -2e-7, 3]');
  });

  it("get defaults where they say nothing", () => {
    const text = JSON.stringify({ version: 1, mesh: { file: "a.obj" }, motion: { files: ["a.bvh"] }, points: [], settings: { volume: 2 } });
    expect(parseProject(text, "a.json").document).toEqual({
      version: 1,
      name: "",
      mesh: { file: "a.obj", facing: "+z", up: "+y" },
      motion: { files: ["a.bvh"] },
      points: [],
      examples: [],
      settings: { volume: 2, smoothness: 0.3, energy: 0, groundContact: true, inPlace: false, symmetry: true },
    });
  });

  it.each<[string, Path, unknown]>([
    ["examples[0].points.p1 should be three numbers, but its second is null.", ["examples", 0, "points", "p1", 1], NaN],
    ["examples[0].points.p1 should be three numbers, but it has 2.", ["examples", 0, "points", "p1"], [1, 2]],
    ['examples[1].joints["left hand"] should be three numbers, but its first is "1".', ["examples", 1, "joints", "left hand"], ["1", 0, 0]],
    ["points[1].position should be three numbers, but it is null.", ["points", 1, "position"], null],
    ["points[0].joint should be a text or null, but it is 3.", ["points", 0, "joint"], 3],
    ["points[0].joint is missing.", ["points", 0, "joint"], undefined],
    [
      "joints.root should be hips, spine, chest, neck, head, left shoulder, left upper arm, left lower arm, left hand, left upper leg, " +
        "left lower leg, left foot, left toe, left tip, right shoulder, right upper arm, right lower arm, right hand, right upper leg, " +
        'right lower leg, right foot, right toe or right tip, but it is "paw".',
      ["joints", "root"],
      "paw",
    ],
    ['points[0].id should be a text that is not empty, but it is "".', ["points", 0, "id"], ""],
    ['points[1].id is "p1", which another point has already.', ["points", 1, "id"], "p1"],
    ['examples[1].id is "e1", which another example has already.', ["examples", 1, "id"], "e1"],
    ['examples[1].points places "gone", but no point has this id.', ["examples", 1, "points", "gone"], [0, 0, 0]],
    ['examples[1].turns places "gone", but no point has this id.', ["examples", 1, "turns"], { gone: [0, 0, 0] }],
    ['stiff[1].id is "s", which another stiff part has already.', ["stiff"], [1, 2].map(() => ({ id: "s", position: [0, 0, 0] }))],
    [
      'clips["02_01.amc"].pins[1].velocity is missing: a pin of kind "moves" says how fast.',
      ["clips", "02_01.amc", "pins", 1, "kind"],
      "moves",
    ],
    ["examples[1].source.frame should be a whole number from 0 to 1000000000, but it is 1.5.", ["examples", 1, "source", "frame"], 1.5],
    ['clips["02_01.amc"].pins[1].id is "n2", which another pin has already.', ["clips", "02_01.amc", "pins", 0, "id"], "n2"],
    ['clips["02_01.amc"].pins[1] holds "tail", but no point has this id.', ["clips", "02_01.amc", "pins", 1, "point"], "tail"],
    ['clips["02_01.amc"].pins[2] holds "tail", but no point has this id.', ["clips", "02_01.amc", "pins", 2, "other"], "tail"],
    [
      'clips["02_01.amc"].pins[2].other is missing: a pin of kind "level" names another point.',
      ["clips", "02_01.amc", "pins", 2, "other"],
      undefined,
    ],
    [
      'clips["02_01.amc"].pins[0].position is missing: a pin of kind "place" says where.',
      ["clips", "02_01.amc", "pins", 0, "position"],
      undefined,
    ],
    [
      'clips["02_01.amc"].pins[1].frame is 0, but no frame comes before it in which its point could stand.',
      ["clips", "02_01.amc", "pins", 1, "frame"],
      0,
    ],
    [
      'clips["02_01.amc"].pins[0].kind should be place, still, level or moves, but it is "glue".',
      ["clips", "02_01.amc", "pins", 0, "kind"],
      "glue",
    ],
    ['clips["02_01.amc"].contacts names "tail", but no point has this id.', ["clips", "02_01.amc", "contacts", "tail"], [[0, 1]]],
    [
      'clips["02_01.amc"].contacts.p1 has a run from 9 to 9, but it should end after it begins.',
      ["clips", "02_01.amc", "contacts", "p1"],
      [[9, 9]],
    ],
    ['clips["02_01.amc"].flights[0] should be two whole numbers, but it has 3.', ["clips", "02_01.amc", "flights", 0], [1, 2, 3]],
    ['mesh.facing should be +x, -x, +y, -y, +z or -z, but it is "north".', ["mesh", "facing"], "north"],
    ["mesh.file is missing.", ["mesh", "file"], undefined],
    ["motion.files should be a list of 1 to 2 texts, but it has 0.", ["motion", "files"], []],
    ["settings.volume should be a number from 0 to 3, but it is 9.", ["settings", "volume"], 9],
    ['settings.groundContact should be true or false, but it is "yes".', ["settings", "groundContact"], "yes"],
    ["settings.smoothnes is not a field that Rigless knows.", ["settings", "smoothnes"], 1],
    ["points should be a list of objects, but it is an object.", ["points"], {}],
    ['version should be 1, but it is "1".', ["version"], "1"],
    ["version is missing.", ["version"], undefined],
  ])("name the field: %s", (message, path, value) => {
    expect(messageOf(JSON.stringify(altered(path, value)))).toBe(`cow.json: ${message}`);
  });

  it("refuse numbers too large to be one", () => {
    const text = JSON.stringify(project).replace("[1,1,1]", "[1,1e999,1]");
    expect(messageOf(text)).toBe("cow.json: examples[0].points.p1 should be three numbers, but its second is Infinity.");
  });

  it("say so when a newer Rigless saved them", () => {
    expect(messageOf(JSON.stringify(altered(["version"], 3)))).toContain("This project was saved by a newer Rigless (version 3).");
  });

  it.each([
    ["", "cow.json is empty."],
    ["[1, 2, 3]", "cow.json: It should be an object, but it is a list of 3."],
    ["null", "cow.json: It should be an object, but it is null."],
  ])("that are not projects: %s", (text, message) => {
    expect(messageOf(text)).toBe(message);
  });

  it("cut short are named", () => {
    expect(messageOf(serializeProject(project).slice(0, 200))).toMatch(/^cow\.json is not whole JSON: /);
  });

  it("keep strange joint names apart from what every object has", () => {
    const text = JSON.stringify(project).replace('"lhand":[1,2,3]', '"__proto__":[1,2,3],"constructor":[4,5,6]');
    const joints = parseProject(text, "cow.json").document.examples[0].joints;
    expect(Object.keys(joints)).toEqual(["root", "__proto__", "constructor"]);
  });
});

function weAccept(value: unknown): boolean {
  try {
    return parseProject(JSON.stringify(value), "x") !== null;
  } catch {
    return false;
  }
}

describe("the schema", () => {
  const ajv = new Ajv({ strictTypes: false });
  const accepts = ajv.compile(schema);

  it("uses no keyword that is not interpreted", () => {
    const names = new Set<string>();
    const walk = (rule: object): void => {
      for (const [key, value] of Object.entries(rule)) {
        names.add(key);
        if (key === "properties" || key === "$defs") Object.values<object>(value).forEach(walk);
        if ((key === "items" || key === "additionalProperties") && typeof value === "object") walk(value);
      }
    };
    walk(schema);
    expect([...names].filter((name) => !KEYWORDS.some((known) => known === name))).toEqual([]);
  });

  it("means the same to a general validator", () => {
    expect(accepts(project)).toBe(true);
    const values = [null, true, -1, 0, 0.5, 2, 1e13, "", "+x", "text", [], [1, 2, 3], [1, null, 3], {}, { a: [1, 2, 3] }];
    const paths: Path[] = [
      ["version"],
      ["name"],
      ["mesh"],
      ["mesh", "file"],
      ["mesh", "up"],
      ["mesh", "more"],
      ["motion", "files"],
      ["points", 0, "position"],
      ["points", 0, "joint"],
      ["points", 1, "radius"],
      ["points", 1, "mirror"],
      ["examples"],
      ["examples", 0, "source"],
      ["examples", 0, "source", "frame"],
      ["examples", 0, "joints"],
      ["examples", 0, "joints", "root"],
      ["joints"],
      ["joints", "root"],
      ["settings"],
      ["settings", "inPlace"],
    ];
    const { version: _, name, ...dancer } = project;
    const duets = ["version", "performers"].flatMap((key) =>
      values.map((value) => ({ version: 2, name, performers: [dancer, { ...dancer, offset: {} }], [key]: value })),
    );
    const offsets = ["seconds", "place", "yaw", "more"].flatMap((key) =>
      values.map((value) => ({ version: 2, performers: [dancer, { ...dancer, offset: { [key]: value } }] })),
    );
    for (const copy of [...duets, ...offsets]) expect(weAccept(copy), JSON.stringify(copy).slice(-60)).toBe(accepts(copy));
    for (const path of paths) {
      for (const value of values) {
        const copy = altered(path, value);
        expect(weAccept(copy), `${path.join(".")} = ${JSON.stringify(value)}`).toBe(accepts(copy));
      }
    }
  });
});
