// What comes with the page: each character as its list says, closed, and all of them small.

import { readdirSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { describe, expect, it } from "vitest";

import list from "../../assets/characters/index.json";
import { parseProject } from "../../src/document/project";
import { normalPath } from "../../src/io/named-file";
import { readModel } from "../../src/io/read-model";
import { asset } from "../support/files";

const decode = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const projectOf = (character: { project: string }) => {
  const path = normalPath(`characters/${character.project}`);
  const { document } = parseProject(decode(asset(path).bytes), "project.json");
  return { document, model: asset(path.replace(/[^/]*$/, document.mesh.file)) };
};

describe.each(list)("$name", (character) => {
  it("is one closed surface of as many vertices as its list says", async () => {
    const { positions, faces, notes } = await readModel([projectOf(character).model]);
    expect(positions.length / 3).toBe(character.vertices);
    const edges = new Set([...faces].map((v, i) => v * character.vertices + faces[i % 3 === 2 ? i - 2 : i + 1]));
    expect(edges.size).toBe(faces.length);
    const open = [...edges].filter(
      (edge) => !edges.has((edge % character.vertices) * character.vertices + Math.floor(edge / character.vertices)),
    );
    expect(open).toEqual([]);
    expect(character.vertices - edges.size / 2 + faces.length / 3).toBe(2);
    expect(notes).toEqual([]);
  });

  it("has points with partners and posed examples", () => {
    const { points, examples } = projectOf(character).document;
    expect(points.length).toBeGreaterThanOrEqual(6);
    expect(examples.length).toBeGreaterThanOrEqual(3);
    for (const { id, mirror } of points) {
      if (mirror !== undefined) expect(points.find((other) => other.id === mirror)?.mirror).toBe(id);
    }
  });
});

it("the whole cast and its motions are at most 600 kB compressed", () => {
  const motions = readdirSync(new URL("../../assets/motions", import.meta.url))
    .filter((file) => file.endsWith(".bvh"))
    .map((file) => asset(`motions/${file}`));
  const files = [
    ...motions,
    ...list.flatMap((character) => [projectOf(character).model, asset(normalPath(`characters/${character.project}`))]),
  ];
  expect(files.reduce((sum, { bytes }) => sum + gzipSync(bytes).length, 0)).toBeLessThan(600_000);
});
