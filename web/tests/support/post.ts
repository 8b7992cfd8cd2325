// A post that bends, for tests of what is written of a dance.

import type { Model } from "../../src/io/model";
import { readModel } from "../../src/io/read-model";
import { PNG, textFile } from "./files";

const ROWS = 25;
export const HEIGHT = 2;

/** A post of two materials, with a seam between them; the upper one may have a picture, which three.js loads only in a page. */
export function post(picture = false): Promise<Model> {
  const lines = ["mtllib p.mtl"];
  for (let r = 0; r < ROWS; r++)
    for (const [x, z] of [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ])
      lines.push(`v ${0.2 * x} ${(HEIGHT * r) / (ROWS - 1)} ${0.2 * z}`);
  lines.push("vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1");
  for (let r = 0; r + 1 < ROWS; r++) {
    if (r === 0 || r === 12) lines.push(`usemtl ${r === 0 ? "low" : "high"}`);
    for (let k = 0; k < 4; k++) {
      const [a, b] = [4 * r + k + 1, 4 * r + ((k + 1) % 4) + 1];
      lines.push(`f ${a}/1 ${b}/2 ${b + 4}/3 ${a + 4}/4`);
    }
  }
  const mtl = `newmtl low\nKd 1 0 0\nnewmtl high\n${picture ? "map_Kd skin.png" : "Kd 0 1 0"}\n`;
  return readModel([textFile("p.obj", lines.join("\n")), textFile("p.mtl", mtl), { name: "skin.png", bytes: PNG }]);
}

/** It bends in the middle while it goes and turns. */
export function bent({ positions }: Model, frames: number): { positions: Float32Array }[] {
  return Array.from({ length: frames }, (_, f) => {
    const out = new Float32Array(positions.length);
    for (let i = 0; i < out.length; i += 3) {
      const [x, y, z] = positions.subarray(i, i + 3);
      const much = Math.min(1, Math.max(0, (y - 0.7) / 0.6));
      const bend = Math.sin(0.4 * f);
      const [by, bz] = [1 + (y - 1) * Math.cos(bend) - z * Math.sin(bend), (y - 1) * Math.sin(bend) + z * Math.cos(bend)];
      const [ly, lz] = [y + much * (by - y), z + much * (bz - z)];
      const [c, s] = [Math.cos(0.2 * f), Math.sin(0.2 * f)];
      out.set([c * x + s * lz + 0.1 * f, ly, -s * x + c * lz], i);
    }
    return { positions: out };
  });
}
