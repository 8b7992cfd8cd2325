// What a bare mesh says of itself. Its module is made for one call and dropped, and its memory with it.

import { shapePointRow, shapeRow, writeLandmark } from "./abi";
import type { ShapePoint } from "./abi";
import { FILE_AXES_NAMES } from "../util/constants";
import { Heap } from "./heap";
import { Refusal } from "./refusal";
import type { ShapeAnalysisInput } from "./protocol";
import { EngineError } from "./types";
import type { AxisName, BodyPoint, ShapeAnalysis } from "./types";
import { instantiateShapeAnalysis } from "./wasm";

export function analyseShape({ mesh, wasm }: ShapeAnalysisInput): ShapeAnalysis {
  const { positions, faces, axes = "unknown", stands = null, landmarks = [] } = mesh;
  if (positions.length % 3 !== 0 || faces.length % 3 !== 0) {
    throw new EngineError("bad_mesh", "The model's points and triangles do not come in threes.");
  }
  const module = instantiateShapeAnalysis(wasm);
  const heap = new Heap(module);
  const axesOfIt = Float32Array.of(...axisVector(stands?.up), ...axisVector(stands?.facing));
  const status = heap.lend([positions, faces, axesOfIt], ([at, facesAt, standsAt]) =>
    heap.lendAll(writeLandmark, landmarks, (landmarksAt) =>
      module.analyse_shape(
        ...([at, positions.length / 3, facesAt, faces.length / 3, FILE_AXES_NAMES.indexOf(axes)] as const),
        ...([standsAt, landmarksAt, landmarks.length] as const),
      ),
    ),
  );
  if (status !== 0) throw new Refusal(status, { kind: "mesh" });
  const { up, front, sure, planePoint, planeNormal, misfit, symmetric, points } = heap.read(shapeRow, module.shape());
  return {
    up: axisName(up),
    facing: axisName(front),
    sure,
    symmetry: symmetric ? { point: planePoint, normal: planeNormal, misfit } : null,
    points: Array.from({ length: points }, (_, n) => bodyPoint(heap.read(shapePointRow, module.shape_point(n)))),
  };
}

function bodyPoint({ side, ...point }: ShapePoint): BodyPoint {
  return { ...point, side: side === 0 ? null : side > 0 ? "left" : "right" };
}

function axisVector(axis?: AxisName): number[] {
  return ["x", "y", "z"].map((name) => (axis?.charAt(1) === name ? Number(`${axis.charAt(0)}1`) : 0));
}

function axisName([x, y, z]: [number, number, number]): AxisName {
  const sign = x + y + z < 0 ? "-" : "+";
  return `${sign}${x !== 0 ? "x" : y !== 0 ? "y" : "z"}`;
}
