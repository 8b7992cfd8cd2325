import { readFile } from "node:fs/promises";
import { createRigless } from "rigless";

// A post of nine square rings: positions and faces as any loader gives them, in any units and axes.
const positions = [0, 0, 0, 0, 160, 0];
const faces = [];
for (let y = 0; y < 9; y++) {
  for (let k = 0; k < 4; k++) {
    positions.push(k % 2 ? 20 * (k - 2) : 0, 20 * y, k % 2 ? 0 : 20 * (k - 1));
    const [a, b] = [4 * y + k + 2, 4 * y + ((k + 1) % 4) + 2];
    if (y === 0) faces.push(0, b, a);
    faces.push(...(y < 8 ? [a, b, b + 4, a, b + 4, a + 4] : [a, b, 1]));
  }
}

const rigless = await createRigless();
const dance = await rigless.retarget({ mesh: { positions, faces }, motion: await readFile("dance.bvh", "utf8") });
for (let f = 0; f < dance.frames; f++) console.log(`frame ${f}: the top is at ${dance.frame(f).slice(3, 6)}`);
rigless.close();
