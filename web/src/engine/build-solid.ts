// The solid inside a mesh. Its module is made for one call and dropped, and its memory with it.

import { solidInfoRow } from "./abi";
import { Heap } from "./heap";
import { Refusal } from "./refusal";
import type { SolidCells } from "../util/solid-cells";
import type { BoundMeshInput } from "./types";
import { instantiateShapeAnalysis } from "./wasm";

/** What a body is solved by: the cells, and which nodes are joined how stiffly. */
export interface BuiltSolid extends SolidCells {
  /** N + 1, into the neighbours. */
  first: Int32Array;
  neighbors: Int32Array;
  weights: Float32Array;
  /** N: of which part a node is. */
  partOf: Int32Array;
}

/** `wasm`: the bytes of shape-analysis.wasm. Errors (EngineError): bad_mesh. */
export function buildSolid({ positions, faces, parts = null, rigidity = null }: BoundMeshInput, wasm: ArrayBuffer): BuiltSolid {
  const module = instantiateShapeAnalysis(wasm);
  const heap = new Heap(module);
  const status = heap.lend([positions, faces, parts, rigidity], ([at, facesAt, partsAt, rigidityAt]) =>
    module.build_solid(at, positions.length / 3, facesAt, faces.length / 3, partsAt, rigidityAt),
  );
  if (status !== 0) throw new Refusal(status, { kind: "mesh" });
  const { nodes, elements, edges, cell } = heap.read(solidInfoRow, module.solid_info());
  return {
    cell,
    nodes: heap.floats(module.solid_nodes(), 3 * nodes),
    elements: heap.integers(module.solid_elements(), 8 * elements),
    elementOf: heap.integers(module.solid_element_of(), positions.length / 3),
    first: heap.integers(module.solid_first(), nodes + 1),
    neighbors: heap.integers(module.solid_neighbors(), edges),
    weights: heap.floats(module.solid_weights(), edges),
    partOf: heap.integers(module.solid_parts(), nodes),
  };
}
