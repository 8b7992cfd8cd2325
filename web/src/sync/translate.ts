// What a document asks of the engine, part by part: each setting of the document is translated here and nowhere else; what few
// documents say, in details.ts. Pure.

import { type Danced, saidOf } from "../document/clips";
import { toStage } from "../document/stage-transform";
import { DEFAULT_FOLLOW, type MeshRef, type ProjectDocument, SAID_ROLES } from "../document/types";
import type { BoundMeshInput, ControlInput, Motion, MotionEdits, RetargetInput, Solve } from "../engine/types";
import { DEFAULT_RADIUS, STAGE_HEIGHT } from "../util/constants";
import { exampleJoints, pointJoints } from "./pairing";
import { type SolverModel, stageFor } from "./placement";
import { exampleControls, pointPartners, pointVertices } from "./point-controls";

/** What of a model is solved. */
export const solveOf = (mesh: MeshRef): Solve => mesh.solve ?? "surface";

export function meshInput(model: SolverModel, mesh: MeshRef): BoundMeshInput {
  return { positions: toStage(stageFor(model, mesh), model.positions), faces: model.faces, parts: model.parts, solve: solveOf(mesh) };
}

export function controlInputs(model: SolverModel, document: Pick<ProjectDocument, "points">): ControlInput[] {
  return pointVertices(model, document.points).map((vertex, c) => ({
    vertex,
    radius: (document.points[c].radius ?? DEFAULT_RADIUS) * STAGE_HEIGHT,
    slab: document.points[c].slab ?? false,
  }));
}

/** As UpAxis counts them. */
const UPS: readonly (string | undefined)[] = ["+y", "+z", "-y", "-z"];

export function motionEdits(document: Danced): MotionEdits {
  const { file = {}, cut = [0, 1e9], mirror = false, loop = false } = saidOf(document);
  const { metresPerUnit = 0, fps = 0, up, turn = 0, joints = {} } = file;
  return {
    metresPerUnit,
    fps,
    up: UPS.indexOf(up),
    turns: turn / 90,
    mirror,
    first: cut[0],
    last: cut[1],
    loop,
    joints: SAID_ROLES.map((role) => joints[role] ?? ""),
  };
}

export function retargetInput(model: SolverModel, document: ProjectDocument, motion: Pick<Motion, "joints" | "frames">): RetargetInput {
  const { smoothness, volume, energy, groundContact, inPlace, symmetry } = document.settings;
  const known = exampleJoints(document, motion);
  return {
    pairs: pointJoints(document, motion),
    examples: document.examples.flatMap((example, n) => {
      const joints = known[n];
      return joints ? [{ joints, controls: exampleControls(model, document, example) }] : [];
    }),
    smoothness,
    volume,
    groundContact,
    inPlace,
    energy,
    follow: document.points.map(({ joint, follow }) => (joint === null ? (follow ?? DEFAULT_FOLLOW) : "stiff")),
    mirror: symmetry ? pointPartners(document.points) : null,
  };
}
