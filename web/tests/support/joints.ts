import type { Joint } from "../../src/engine/types";
import { readJointNames } from "../../src/skeleton/joint-names";
import { roleOf } from "../../src/skeleton/pair-joints";

/** Joints of a chain with the roles that their names tell, as the engine answers them. */
export function namedJoints(...names: string[]): Joint[] {
  const taken = new Set<string>();
  return readJointNames(names).map(({ side, part }, j) => {
    const role = roleOf({ side, part });
    const isFirst = role !== null && !taken.has(role);
    if (isFirst) taken.add(role);
    return { name: names[j], parent: j - 1, side: isFirst ? side : null, part: isFirst ? part : null };
  });
}

/** Joints whose names say nothing, with these roles: "left foot", "hips", "". */
export function numberedJoints(prefix: string, ...roles: string[]): Joint[] {
  return roles.map((role, j) => {
    const [, side, part] = /^(?:(left|right) )?(.*)$/.exec(role) ?? [];
    return {
      name: `${prefix}${j}`,
      parent: j - 1,
      side: side === "left" || side === "right" ? side : null,
      part: part === "" ? null : (part.replace(" ", "_") as Joint["part"]),
    };
  });
}

const VERTEBRAE = 7;
const ROW = Array.from({ length: 3 * VERTEBRAE + 3 }, () => 0).join(" ");

/** A BVH of a body without limbs. */
export const SNAKE = `HIERARCHY
${Array.from(
  { length: VERTEBRAE },
  (_, n) => `${n ? "JOINT" : "ROOT"} b${n}
{
OFFSET 0 0 ${n ? 0.3 : 0}
CHANNELS ${n ? "3" : "6 Xposition Yposition Zposition"} Zrotation Xrotation Yrotation
`,
).join("")}End Site
{
OFFSET 0 0 0.3
}
${"}\n".repeat(VERTEBRAE)}MOTION
Frames: 2
Frame Time: 0.0333
${ROW}
${ROW}
`;
