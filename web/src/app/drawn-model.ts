import { toStage, turnToStage } from "../document/stage-transform";
import type { MeshRef } from "../document/types";
import type { Model } from "../io/model";
import type { DrawnModel } from "../stage/port";
import { stageFor } from "../sync/placement";
import type { SolidCells } from "../util/solid-cells";

/** A model where its project puts it, and what carries it there. */
export function drawnModel(model: Model, mesh: MeshRef, solid: SolidCells | null): DrawnModel {
  const { document, drawn, faces } = model;
  const stage = stageFor(model, mesh);
  const rest = toStage(stage, model.positions);
  return { ...drawn, positions: toStage(stage, drawn.positions), normals: turnToStage(stage, drawn.normals), document, faces, rest, solid };
}
