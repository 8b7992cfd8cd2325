import { toStage, turnToStage } from "../document/stage-transform";
import type { MeshRef } from "../document/types";
import type { Model } from "../io/model";
import type { DrawnModel } from "../stage/port";
import { stageFor } from "../sync/placement";

/** A model where its project puts it. */
export function drawnModel(model: Model, mesh: MeshRef): DrawnModel {
  const { document, drawn, faces } = model;
  const stage = stageFor(model, mesh);
  return { ...drawn, positions: toStage(stage, drawn.positions), normals: turnToStage(stage, drawn.normals), document, faces };
}
