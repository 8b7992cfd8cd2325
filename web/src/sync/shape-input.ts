// What an engine is told of a model that is to be understood. Pure.

import { boundsOf } from "../document/stage-transform";
import type { ShapeInput } from "../engine/types";
import { fileAxes } from "./file-axes";
import { readNamedBody } from "./named-body";
import type { SolverModel } from "./placement";

export function shapeInput({ positions, faces, name, joints = [] }: SolverModel): ShapeInput {
  const axes = fileAxes(name);
  const body = joints.length > 0 ? readNamedBody(joints, boundsOf(positions), axes) : null;
  return { positions, faces, axes, ...(body ?? {}) };
}
