// The motions that come with the page: how they were made, and what the engine sees in their files.

import { readFileSync } from "node:fs";
import { afterAll, describe, expect, it } from "vitest";
import list from "../../assets/motions/index.json";
import { createNodeEngine } from "../../src/engine/node";
import { setUpPost } from "./engine-support";

interface Report {
  frames: number;
  stretch: number;
  lowestToeEnd: number;
  slideMillimetres: number[];
  flights: { frames: [number, number]; massOverG: number }[];
  secondDifference: { worst: string; seam: string };
}
interface Authored {
  make: () => unknown[];
  fps: number;
  travels: number[] | null;
}

const authoring = (path: string) => import(new URL(`../../authoring/${path}`, import.meta.url).href);
const { REPERTOIRE } = (await authoring("motions/repertoire.js")) as { REPERTOIRE: Record<string, Authored> };
const { reportMotion } = (await authoring("kit/motion-report.js")) as {
  reportMotion: (poses: unknown[], fps: number, way: { travels: number[] | null }) => Report;
};

const engine = await createNodeEngine();
afterAll(() => engine.close());

/** The engine's flights, in frames at 30 a second. */
const FLIGHTS: Record<string, number> = { hop: 3, jump: 1 };

it("the list names every motion", () => {
  expect(list.map(({ file }) => file)).toEqual(Object.keys(REPERTOIRE).map((id) => `${id}.bvh`));
});

describe.each(list)("$name", ({ file, seconds, travels }) => {
  const id = file.replace(".bvh", "");
  const { make, fps, travels: way } = REPERTOIRE[id]!;
  const report = reportMotion(make(), fps, { travels: way });

  it("stands without sliding, never overreaches, falls freely and closes its loop", () => {
    expect(report.stretch).toBeLessThan(1);
    expect(report.lowestToeEnd).toBeGreaterThan(-0.1);
    for (const slide of report.slideMillimetres) expect(slide).toBeLessThan(1);
    for (const {
      frames: [a, b],
      massOverG,
    } of report.flights)
      if (b - a > 4) expect(Math.abs(massOverG - 1)).toBeLessThan(0.05);
    expect(parseFloat(report.secondDifference.seam)).toBeLessThanOrEqual(parseFloat(report.secondDifference.worst) + 0.01);
    expect(seconds).toBeGreaterThanOrEqual(2);
    expect(seconds).toBeLessThanOrEqual(8);
  });

  it("is read whole, travels as listed, and its flights are found", async () => {
    const text = readFileSync(new URL(`../../assets/motions/${file}`, import.meta.url), "utf8");
    await setUpPost(engine);
    const motion = await engine.setMotion({ name: file, text });
    expect(motion.notes).toEqual([`${file} seems to be in centimetres.`]);
    expect(Math.abs(motion.frames - seconds * 30)).toBeLessThanOrEqual(3);
    const J = motion.joints.length;
    const place = (frame: number, k: number) => motion.positions[3 * frame * J + k];
    const gone = Math.hypot(place(motion.frames - 1, 0) - place(0, 0), place(motion.frames - 1, 2) - place(0, 2));
    expect(Math.abs(gone - travels)).toBeLessThan(0.25);
    // In the file as well, the ball of a foot that lies on the floor stays where it is.
    for (const toe of ["LeftToe", "RightToe"].map((name) => motion.joints.findIndex((other) => other.name === name))) {
      const at = (frame: number) => motion.positions.subarray(3 * (frame * J + toe), 3 * (frame * J + toe) + 3);
      const floor = Math.min(...Array.from({ length: motion.frames }, (_, frame) => at(frame)[1]));
      const down = (frame: number) => at(frame)[1] < floor + 0.0005;
      for (let frame = 1; frame < motion.frames; frame++) {
        if (down(frame - 1) && down(frame))
          expect(Math.hypot(at(frame)[0] - at(frame - 1)[0], at(frame)[2] - at(frame - 1)[2])).toBeLessThan(0.001);
      }
    }
    const joint = (name: string) => motion.joints.findIndex((other) => other.name === name);
    const performance = await engine.retarget({
      pairs: Int32Array.of(joint("LeftFoot"), joint("RightFoot")),
      examples: [],
      smoothness: 0.3,
      volume: 1,
      groundContact: true,
      inPlace: false,
    });
    if (id in FLIGHTS) expect(performance.flights).toHaveLength(FLIGHTS[id]!);
    else if (!["run", "folk"].includes(id)) expect(performance.flights).toEqual([]);
  });
});
