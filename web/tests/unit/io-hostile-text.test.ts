// Text models that once took minutes or gigabytes: what is quadratic again runs into the time limit.

import { describe, expect, it, vi } from "vitest";

import { ModelError, type NamedFile } from "../../src/io/named-file";
import { type Model, readModel } from "../../src/io/read-model";
import { readPly } from "../../src/io/read-ply";
import { TextScanner } from "../../src/io/text-scanner";
import { addPolygon } from "../../src/io/triangulate";
import { TETRAHEDRON, textFile } from "../support/files";

async function outcome(name: string, content: string | Uint8Array): Promise<Model | string> {
  const file: NamedFile = typeof content === "string" ? textFile(name, content) : { name, bytes: content };
  try {
    return await readModel([file]);
  } catch (error) {
    expect(error).toBeInstanceOf(ModelError);
    return (error as ModelError).message;
  }
}

const faces = (model: Model | string): number | string => (typeof model === "string" ? model : model.faces.length / 3);
const CUT = "It may have been cut short: fetch or save it once more.";
const lines = (n: number, line: (k: number) => string): string => Array.from({ length: n }, (_, k) => line(k)).join("\n");

vi.setConfig({ testTimeout: 120_000 }); // minutes and gigabytes are told from a busy machine

describe("grows with the file's size alone", () => {
  it.each([
    ["open facets", "a.stl", "solid\n" + "facet normal 0 0 0\n".repeat(32_000), `a.stl ends before "endsolid". ${CUT}`],
    ["continued lines", "a.obj", `${TETRAHEDRON}f ${"1 \\\n".repeat(300_000)}\n`, 4],
    ["continued blanks", "a.obj", `${TETRAHEDRON}${"\\\n".repeat(300_000)}\n`, 4],
    [
      "a face of many corners",
      "a.obj",
      `${lines(100_000, (k) => `v ${Math.cos(k / 5e4)} ${Math.sin(k / 5e4)} 0`)}\nf ${lines(100_000, (k) => `${k + 1} \\`)}\n`,
      99_998,
    ],
    ["objects", "a.obj", TETRAHEDRON + lines(50_000, (k) => `o ${k}\nf 1 2 3`), 5],
    ["materials", "a.obj", TETRAHEDRON + lines(50_000, (k) => `usemtl ${k}\nf 1 2 3`), 5],
    ["libraries", "a.obj", TETRAHEDRON + lines(50_000, (k) => `mtllib ${k}.mtl`), 4],
    ["a long number", "a.obj", `v ${"9".repeat(3e6)} 0 0`, 'a.obj, line 1: "99999999999999999999…" is not a number.'],
    ["blanks", "a.obj", " ".repeat(3e7), "a.obj holds no OBJ model."],
    ["blank lines", "a.off", "\n".repeat(3e6), "a.off holds nothing but blanks."],
  ])("%s", async (_, name, text, expected) => {
    expect(faces(await outcome(name, text))).toBe(expected);
  });
});

const ply = (format: string, elements: string, body = ""): string => `ply\nformat ${format} 1.0\n${elements}\nend_header\n${body}`;
const XYZ = "property float x\nproperty float y\nproperty float z";
const FACE = "element face 1\nproperty list uint uint vertex_indices";
const ROWS = "0 0 0\n1 0 0\n0 1 0\n";

describe("counts that a file cannot hold", () => {
  it.each([
    [
      "a.ply",
      ply("binary_little_endian", `element vertex 1000000000\n${XYZ}\n${FACE}`),
      `a.ply promises 1,000,000,000 of "vertex", but no more than 0 fit in it. ${CUT}`,
    ],
    ["a.ply", ply("ascii", `element vertex 3\n${XYZ}\n${FACE}`, `${ROWS}4000000000 0 1 2\n`), `a.ply ends before its last row. ${CUT}`],
    [
      "a.ply",
      ply("ascii", `element vertex 3\n${XYZ}\n${FACE}`, `${ROWS}2.5 0 1 2\n`),
      "a.ply: 2.5 should be a whole number, how many values follow.",
    ],
    ["a.ply", ply("ascii", `element vertex\n${XYZ}`), 'a.ply: "element vertex" in its header should end with a count from 0.'],
    ["a.ply", ply("ascii", `element vertex many\n${XYZ}`), 'a.ply: "element vertex many" in its header should end with a count from 0.'],
    ["a.off", "OFF\n3 1000000000000 0\n", `a.off promises 3 vertices and 1,000,000,000,000 faces, more than fit in it. ${CUT}`],
    ["a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1000000000 0 1 2\n", "a.off, line 6: a face of 1000000000 corners names only 3."],
    ["a.off", "OFF\n2.5 1 0\n", "a.off, line 2: 2.5 should be a whole number from 0."],
  ])("%s: %#", async (name, text, message) => {
    expect(await outcome(name, text)).toBe(message);
  });
});

it("a colour of 1e308 is white, one of -1e308 black", () => {
  const colored = `${XYZ}\nproperty float red\nproperty float green\nproperty float blue`;
  const rows = "0 0 0 1e308 0 0\n1 0 0 -1e308 0 .5\n0 1 0 0 0 0\n3 0 1 2\n";
  const file = textFile("a.ply", ply("ascii", `element vertex 3\n${colored}\n${FACE}`, rows));
  const { colors } = readPly("a.ply", file, [file], []).parts[0];
  expect(Array.from(colors ?? []).map((c) => Math.round(c * 1000))).toEqual([1000, 0, 0, 0, 0, 214, 0, 0, 0]);
});

it("a text STL may shout", async () => {
  const facet = "  FACET NORMAL 0 0 1\n OUTER LOOP\n VERTEX 0 0 0\n VERTEX 1 0 0\n VERTEX 0 1 0\n ENDLOOP\n ENDFACET\n";
  expect(faces(await outcome("a.stl", `SOLID A\n${facet}ENDSOLID A\n`))).toBe(1);
});

describe("triangles", () => {
  const area = (index: readonly number[], p: readonly number[]): number[] =>
    Array.from({ length: index.length / 3 }, (_, t) => {
      const [a, b, c] = [0, 1, 2].map((k) => 3 * index[3 * t + k]);
      return ((p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a])) / 2;
    });

  it("a concave polygon is cut inside itself, whichever way it is seen and however far away it is", () => {
    // An arrow's head: a fan from its first corner would leave it.
    const flat = [0, 0, 0, 2, 4, 0, 4, 0, 0, 2, 1, 0].map((x, k) => x + (k % 3 === 2 ? 0 : 1e6));
    const out: number[] = [];
    addPolygon(out, [0, 1, 2, 3], [0, 1, 2, 3], flat);
    const areas = area(out, flat);
    const sum = areas.reduce((a, b) => a + b);
    expect(out).toHaveLength(6);
    expect(areas.every((a) => a * sum > 0)).toBe(true);
    for (const turned of [
      [3, 2, 1, 0],
      [2, 3, 0, 1],
    ]) {
      const other: number[] = [];
      addPolygon(other, turned, turned, flat);
      const found = area(other, flat);
      expect(found.every((a) => a > 0) || found.every((a) => a < 0)).toBe(true);
      expect(Math.abs(found.reduce((a, b) => a + b))).toBeCloseTo(Math.abs(sum), 3);
    }
  });

  it("a convex one is a fan", () => {
    const out: number[] = [];
    addPolygon(out, [7, 8, 9, 10], [0, 1, 2, 3], [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect(out).toEqual([7, 8, 9, 7, 9, 10]);
  });
});

it("numbers are what JavaScript reads", () => {
  const words = [
    "0",
    "-0.5",
    "1e3",
    "1.25E-2",
    ".5",
    "5.",
    "+7",
    "123456789.123456789",
    "1e-320",
    "1e400",
    "4.9406564584124654e-324",
    "9007199254740993",
  ];
  const scanner = new TextScanner("t", new TextEncoder().encode(words.join(" ")), "OBJ");
  scanner.nextLine();
  for (const word of words) {
    scanner.next();
    expect(scanner.number()).toBe(Number(word));
  }
  for (const word of ["", "x", "1x", "1e", "-", ".", "1,5", "nan", "inf", "0x10", "1.2.3"]) {
    const odd = new TextScanner("t", new TextEncoder().encode(`${word} z`), "OBJ");
    odd.nextLine();
    odd.next();
    expect(odd.number()).toBeNaN();
  }
});

it("lines are counted through every kind of end", () => {
  const scanner = new TextScanner("t", new TextEncoder().encode("a\r\n\rb \\\r\n c\n# d\ne"), "OBJ");
  const found: [string, number][] = [];
  while (scanner.nextLine()) while (scanner.next()) found.push([scanner.word(), scanner.line]);
  expect(found).toEqual([
    ["a", 1],
    ["b", 3],
    ["c", 4],
    ["e", 6],
  ]);
});

it("says how far it is from the first megabyte on", async () => {
  const told: number[] = [];
  const file = textFile("a.obj", TETRAHEDRON + lines(300_000, (k) => `# ${k}`) + "\n");
  await readModel([file], { onProgress: (done) => told.push(done) });
  expect(file.bytes.length).toBeGreaterThan(2 << 20);
  expect(told.length).toBeGreaterThan(2);
  expect(told.every((done, k) => done > (told[k - 1] ?? 0) && done < 1)).toBe(true);
});
