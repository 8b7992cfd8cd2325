import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

import { parseProject, serializeProject } from "../../src/document/project";
import schema from "../../src/document/project-schema.json";
import { serializeTrack, type Track, trackOf } from "../../src/io/write-track";
import { readModel } from "../../src/io/read-model";
import { TETRAHEDRON, textFile } from "../support/files";

const page = readFileSync(new URL("../../../docs/project-format.md", import.meta.url), "utf8");

function example(name: string): string {
  const found = new RegExp(`<!-- example: ${name} -->\\n\`\`\`json\\n([^]*?)\`\`\``).exec(page);
  if (!found) throw new Error(`no example ${name}`);
  return found[1];
}

/** Every field's name that a value holds, by path: "points[].id". Keys of `joints` and a pose's `points` are names, not fields. */
function fields(value: unknown, path = ""): string[] {
  if (Array.isArray(value)) return value.flatMap((item) => fields(item, `${path}[]`));
  if (typeof value !== "object" || value === null || /joints$|examples\[\]\.points$|clips\.\*\.contacts$/.test(path)) return [];
  return Object.entries(value).flatMap(([key, inner]) => {
    const at = path === "clips" ? "clips.*" : path ? `${path}.${key}` : key;
    return [at, ...fields(inner, at)];
  });
}

it("the page's project is one, says everything there is to say, and each field is explained", () => {
  const { document } = parseProject(example("project.json"), "project.json");
  expect(document).toEqual(JSON.parse(example("project.json")));
  const said = new Set(fields(document));
  const { $defs } = schema;
  const known = [
    ...Object.keys($defs.solo.properties),
    ...(["mesh", "motion", "settings"] as const).flatMap((key) => Object.keys($defs[key].properties).map((inner) => `${key}.${inner}`)),
    ...Object.keys($defs.point.properties).map((key) => `points[].${key}`),
    ...Object.keys($defs.example.properties).map((key) => `examples[].${key}`),
    ...Object.keys($defs.clip.properties).map((key) => `clips.*.${key}`),
    ...Object.keys($defs.file.properties).map((key) => `clips.*.file.${key}`),
    ...Object.keys($defs.pin.properties).map((key) => `clips.*.pins[].${key}`),
  ];
  expect(known.filter((field) => !said.has(field))).toEqual([]);
  const explained = known.filter((field) => !["mesh", "motion", "settings"].includes(field));
  expect(explained.filter((field) => !page.includes(`| \`${field}\` |`))).toEqual([]);
});

it("the page's project of two dancers is one, and each field of its own is explained", () => {
  const { document } = parseProject(example("duet.json"), "duet.json");
  expect(JSON.parse(serializeProject(document))).toEqual(JSON.parse(example("duet.json")));
  const known = [
    "performers",
    "performers[].offset",
    ...Object.keys(schema.$defs.offset.properties).map((key) => `performers[].offset.${key}`),
  ];
  expect(known.filter((field) => !page.includes(`| \`${field}\` |`))).toEqual([]);
});

it("the page's track has exactly the fields that are written", async () => {
  const model = await readModel([textFile("t.obj", TETRAHEDRON)]);
  const { document } = parseProject(example("project.json"), "project.json");
  const C = document.points.length;
  const frame = {
    positions: model.positions,
    volumeRatio: 1,
    root: [0, 0.5, 2, Math.PI / 2] as [number, number, number, number],
    milliseconds: 1,
  };
  const track = trackOf(document, model, {
    motion: {
      frames: 2,
      takeFrames: 86,
      stands: { left: new Uint8Array(2), right: new Uint8Array(2) },
      joints: [],
      positions: new Float32Array(0),
      local: new Float32Array(0),
      yaw: new Float32Array(2),
      source: { frames: 8, fps: 120, metresPerUnit: 1 },
      notes: [],
      told: true,
    },
    performance: {
      frames: 2,
      controls: Float32Array.from({ length: 6 * C }, (_, i) => i),
      turns: null,
      contacts: Uint8Array.from([1, 0, 1, 1, 1, 0]),
      flights: [[0, 1]],
      yaw: new Float32Array(2),
      travel: new Float32Array(4),
      slip: { before: 0, after: 0 },
      missed: { worst: new Float32Array(0), against: new Int32Array(0) },
      coverage: new Float32Array(2),
      ask: [],
      enough: { have: 0, want: 0 },
      starters: 0,
      sourceContacts: new Uint8Array(6),
      milliseconds: 1,
    },
    frames: [frame, frame],
  });
  const shown = JSON.parse(example("track.json")) as Track;
  expect([...new Set(fields(track))]).toEqual([...new Set(fields(shown))]);
  expect(JSON.parse(serializeTrack(track))).toMatchObject({ format: "rigless-track", version: 1, frames: 2 });

  // A quarter turn about +Y takes x to -z and z to x; then the root is added; file units.
  const s = track.units.metresPerUnit;
  expect(track.controls[0][1]).toEqual([5, 4 + 0.5, -3 + 2].map((x) => expect.closeTo(x / s, 5)));
  expect(track.root[0]).toEqual([0, 0.5 / s, 2 / s, Math.PI / 2]);
  expect(track.contacts.labels).toEqual([
    [1, 0, 1],
    [1, 1, 0],
  ]);
  expect(track.contacts.runs).toEqual([[[0, 2]], [[1, 2]], [[0, 1]]]);
});
