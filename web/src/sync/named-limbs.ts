// Where the limbs of a model bend and leave its trunk, by the joints that its file names. Pure.

import { boundsOf, pointToStage } from "../document/stage-transform";
import type { ProjectDocument, Vec3 } from "../document/types";
import type { ControlInput } from "../engine/types";
import { STAGE_HEIGHT } from "../util/constants";
import { readNamedLimbs } from "./named-body";
import { type SolverModel, stageFor } from "./placement";

const far = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const between = (a: Vec3, b: Vec3): Vec3 => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

/** C: what is known of the limb at whose tip each point lies, stage. */
export function namedLimbs(
  model: SolverModel,
  { mesh, points }: Pick<ProjectDocument, "mesh" | "points">,
): readonly Pick<ControlInput, "onLimb" | "base" | "bend">[] {
  const stage = stageFor(model, mesh);
  const limbs = readNamedLimbs(model.joints ?? [], boundsOf(model.positions)).filter(({ base, end }) => far(base, end) > 0);
  const standing = points.filter(({ position, slab }) => !slab && pointToStage(stage, position)[1] < 0.08 * STAGE_HEIGHT);
  return points.map(({ position, slab }) => {
    if (slab || standing.length > 2) return {}; // an animal's thigh is in its trunk
    const away = (end: Vec3): number => far(end, position);
    const [limb] = limbs
      .filter(({ base, end, onwards }) => away(end) < 0.6 * far(base, end) + (onwards ? Math.hypot(...onwards) : 0))
      .sort((a, b) => away(a.end) - away(b.end));
    if (!limb || points.some((other) => !other.slab && far(limb.end, other.position) < away(limb.end))) return {};
    const bend = limb.bend ?? between(limb.base, position);
    return { onLimb: true, base: [...pointToStage(stage, limb.base)], bend: [...pointToStage(stage, bend)] };
  });
}
