// The view on a document that everything else works with: what its scene shows, posed, in the world, and the surface that is solved.

import type { GltfDocument } from "../../gltf/document";
import type { Drawn, DrawnInstance } from "../../gltf/drawn";
import { count } from "../count";
import { ModelError } from "../named-file";
import { SKINNED } from "../skinned";
import { TupleTable } from "../../util/tuple-table";
import { checkedBounds, type Corners, cornersOf, weldCorners, type WeldedSurface } from "../surface";
import { checkSize, trianglesIn } from "./check";
import { type Posed, posed } from "./posed";
import { trianglesOf } from "./triangles";
import { instanceMatrices, type Matrix, sceneNodes, worldMatrices } from "./world";

export interface View {
  /** File units and axes, `origin` less. */
  readonly drawn: Drawn;
  /** V x 3, file units and axes, `origin` less; every vertex is used by a face. */
  readonly positions: Float32Array;
  /** F x 3 over V; no face names a vertex twice, no two faces are the same. */
  readonly faces: Uint32Array;
  /** What was taken off all coordinates: zeros unless the model is so far away that single precision would show. */
  readonly origin: readonly [number, number, number];
}

/** Errors (ModelError): no triangles; a coordinate that is not a number or beyond 1e12; a corner without its vertex; all on one spot. */
export function viewOf(name: string, document: GltfDocument, notes: string[]): View {
  const pieces = piecesOf(name, document, notes);
  if (pieces.length === 0) throw new ModelError(`${name} has no triangles. ${whatElse(document)}`.trim());
  const origin = originOf(name, pieces);
  const corners = cornersOf(pieces, origin);
  const surface = weldCorners(name, corners, notes);
  const { positions, faces } = surface;
  return { positions, faces, drawn: drawnOf(pieces, corners, surface, origin), origin };
}

/** A primitive as a node shows it. */
interface Piece extends Posed, Pick<DrawnInstance, "node" | "mesh" | "primitive"> {
  /** Over the accessors' vertices. */
  readonly triangles: Uint32Array;
}

function piecesOf(name: string, document: GltfDocument, notes: string[]): Piece[] {
  const { nodes = [], meshes = [] } = document.json;
  const world = worldMatrices(document);
  const shown: { node: number; mesh: number; primitive: number; matrix: Matrix }[] = [];
  let triangles = 0;
  for (const node of sceneNodes(document)) {
    const { mesh } = nodes[node];
    if (mesh === undefined) continue;
    const inEach = meshes[mesh].primitives.map((primitive) => trianglesIn(document.json, primitive));
    for (const matrix of instanceMatrices(document, nodes[node], world[node])) {
      triangles += inEach.reduce((sum, n) => sum + n, 0);
      checkSize(name, triangles);
      inEach.forEach((n, primitive) => void (n > 0 && shown.push({ node, mesh, primitive, matrix })));
    }
  }
  const found = { skinned: false, morphed: false };
  const pieces = shown.map(({ matrix, ...where }): Piece => {
    const node = nodes[where.node];
    const primitive = meshes[where.mesh].primitives[where.primitive];
    found.skinned ||= node.skin !== undefined;
    found.morphed ||= (primitive.targets?.length ?? 0) > 0;
    const place = posed(document, node, primitive, matrix, world);
    return { ...where, ...place, triangles: trianglesOf(name, document, primitive, place.mirrored) };
  });
  if (found.skinned) notes.push(SKINNED);
  if (found.morphed) notes.push("This file has shape keys. We use its current shape.");
  return pieces;
}

/** Diagonals from the origin beyond which single precision would show. */
const FAR = 50;

function originOf(name: string, pieces: readonly Piece[]): readonly [number, number, number] {
  const { min, max } = checkedBounds(name, pieces);
  const centre = min.map((low, k) => (low + max[k]) / 2);
  const diagonal = Math.hypot(...min.map((low, k) => max[k] - low));
  return Math.hypot(...centre) > FAR * diagonal ? [centre[0], centre[1], centre[2]] : [0, 0, 0];
}

/** Render vertices are the files' own that a face uses, in the files' order. */
function drawnOf(
  pieces: readonly Piece[],
  { index, ranks }: Corners,
  { faces, kept, vertexOf }: WeldedSurface,
  origin: readonly number[],
): Drawn {
  const single = borders(faces);
  const rendered = new Int32Array(vertexOf.length).fill(-1);
  for (const triangle of kept) for (let k = 0; k < 3; k++) rendered[index[3 * triangle + k]] = 0;
  const vertices = rendered.reduce((sum, is) => sum + (is === 0 ? 1 : 0), 0);
  const drawn = {
    instances: [] as DrawnInstance[],
    positions: new Float32Array(3 * vertices),
    normals: new Float32Array(3 * vertices),
    index: new Uint32Array(3 * kept.length),
    toVertex: new Uint32Array(vertices),
  };
  let r = 0;
  let face = 0;
  let before = 0; // triangles of the pieces before
  pieces.forEach(({ node, mesh, primitive, positions, normals, triangles }, p) => {
    const [first, from] = [r, 3 * face];
    const own: number[] = [];
    ranks[p].forEach((corner, vertex) => {
      if (corner < 0 || rendered[corner] < 0) return;
      const length = normals ? Math.hypot(normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]) : 0;
      for (let k = 0; k < 3; k++) {
        drawn.positions[3 * r + k] = positions[3 * vertex + k] - origin[k];
        if (normals && length > 0) drawn.normals[3 * r + k] = normals[3 * vertex + k] / length;
      }
      drawn.toVertex[r] = vertexOf[corner];
      rendered[corner] = r++;
      own.push(vertex);
    });
    before += triangles.length / 3;
    let open = false;
    for (; face < kept.length && kept[face] < before; face++) {
      open ||= single[face] === 1;
      for (let k = 0; k < 3; k++) drawn.index[3 * face + k] = rendered[index[3 * kept[face] + k]];
    }
    if (from === 3 * face) return;
    const whole = own.length === positions.length / 3;
    drawn.instances.push({
      ...{ node, mesh, primitive, first, from },
      count: r - first,
      to: 3 * face,
      vertices: whole ? null : Uint32Array.from(own),
      flat: normals === null,
      open,
    });
  });
  return drawn;
}

/** F: 1 where one of a face's edges has not exactly one partner that runs the other way. */
function borders(faces: Uint32Array): Uint8Array {
  const edges = new TupleTable(faces.length, 2);
  const there = new Uint8Array(faces.length);
  const back = new Uint8Array(faces.length);
  const edgeOf = new Uint32Array(faces.length);
  const edge = new Int32Array(2);
  for (let c = 0; c < faces.length; c++) {
    const next = c % 3 === 2 ? c - 2 : c + 1;
    const [a, b] = [faces[c], faces[next]];
    edge[0] = Math.min(a, b);
    edge[1] = Math.max(a, b);
    const e = edges.put(edge);
    edgeOf[c] = e;
    const seen = a < b ? there : back;
    seen[e] = Math.min(2, seen[e] + 1);
  }
  const out = new Uint8Array(faces.length / 3);
  edgeOf.forEach((e, c) => {
    if (there[e] !== 1 || back[e] !== 1) out[Math.floor(c / 3)] = 1;
  });
  return out;
}

/** "It holds 2 curves and 1 camera." */
function whatElse({ json: { meshes = [], cameras = [] } }: GltfDocument): string {
  const sets = meshes.reduce((sum, { primitives }) => sum + primitives.length, 0);
  const held = [
    ...(sets ? [count(sets, "set of lines or points", "sets of lines or points")] : []),
    ...(cameras.length ? [count(cameras.length, "camera")] : []),
  ];
  return held.length ? `It holds ${held.join(" and ")}.` : "";
}
