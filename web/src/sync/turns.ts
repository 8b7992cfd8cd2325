// By how much poses turn points, for the engine and for a document. Not part of the first load: few projects turn any.

import { turnToStage } from "../document/stage-transform";
import type { Example, ProjectDocument, Vec3 } from "../document/types";
import type { Motion, RetargetInput } from "../engine/types";
import { exampleJoints } from "./pairing";
import { type SolverModel, stageFor } from "./placement";
import { own } from "./point-controls";

/** A turn of the file in the stage's axes. */
export function turnOnStage(model: SolverModel, { mesh }: Pick<ProjectDocument, "mesh">, turn: Vec3): Vec3 {
  const [x, y, z] = turnToStage(stageFor(model, mesh), turn);
  return [x, y, z];
}

/** A turn of the stage in the file's axes. */
export function turnOfFile(model: SolverModel, { mesh }: Pick<ProjectDocument, "mesh">, [x, y, z]: Vec3): Vec3 {
  const { rotation: r } = stageFor(model, mesh);
  return [r[0] * x + r[3] * y + r[6] * z, r[1] * x + r[4] * y + r[7] * z, r[2] * x + r[5] * y + r[8] * z];
}

/** For each point that any pose turns: of the poses that this motion knows, then of their mirror images. */
export function turnInputs(
  model: SolverModel,
  document: ProjectDocument,
  motion: Pick<Motion, "joints" | "frames">,
  { mirror }: Pick<RetargetInput, "mirror">,
): NonNullable<RetargetInput["turns"]> {
  const known = exampleJoints(document, motion);
  const poses = document.examples.filter((_, n) => known[n]);
  const turnOf = ({ turns = {} }: Example, c: number): Vec3 => {
    const turn = own(turns, document.points[c].id);
    return turn ? turnOnStage(model, document, turn) : [0, 0, 0];
  };
  return document.points.flatMap((_, control) => {
    const ways = poses.flatMap((pose) => turnOf(pose, control));
    const partner = mirror?.[control] ?? -1;
    if (partner >= 0)
      ways.push(
        ...poses.flatMap((pose) => {
          const [x, y, z] = turnOf(pose, partner);
          return [x, -y, -z]; // as a mirror across x = 0 shows a turn
        }),
      );
    return ways.some((way) => way !== 0) ? [{ control, ways: Float32Array.from(ways) }] : [];
  });
}
