// An animated GLB of core glTF 2.0: the rest model, one morph target per kept frame and weights that lead from each to the
// next, so that two targets at most act at a time (viewers promise no more than eight).

import { type Accessor, type Buffer, Document, Logger, type Mesh, VertexLayout, WebIO } from "@gltf-transform/core";

import { FPS } from "../engine/types";
import { linear } from "./color";
import type { DrawnSource } from "./model";
import { vertexNormals } from "./vertex-normals";

export interface GlbInput {
  /** The clip's and the mesh's name; spaces become underscores. */
  name: string;
  drawn: DrawnSource;
  /** F x 3 over V. */
  faces: Uint32Array;
  /** V x 3, stage metres. */
  rest: Float32Array;
  /** V x 3 each, world stage metres; frame f is at f / 30 s. */
  frames: readonly { readonly positions: Float32Array }[];
  /** File units per stage metre: the model keeps its own size. */
  scale: number;
  /** Every k-th frame and the last one are kept; the viewer goes straight between them. */
  every: number;
}

/** #e4d2bf, the clay of a model without colours. */
const CLAY = [0xe4, 0xd2, 0xbf].map((byte) => linear(byte / 255));

/** The frames that `every` keeps: 0, k, 2k, ... and the last. */
export function keptFrames(frames: number, every: number): number[] {
  const kept: number[] = [];
  for (let f = 0; f < frames; f += every) kept.push(f);
  if (frames > 0 && kept[kept.length - 1] !== frames - 1) kept.push(frames - 1);
  return kept;
}

/** Bytes of a GLB with so many render vertices and kept frames, without what does not grow with both. */
export function glbBytes(vertices: number, kept: number): number {
  return 24 * vertices * kept + 4 * kept * kept;
}

/**
 * Y up, facing +Z, in the model's own units; travel and turn are in the vertices. Normals have targets too, because a model that
 * turns would be lit from the wrong side without; they double the size: 24 bytes per render vertex and kept frame.
 */
export async function writeGlb(input: GlbInput): Promise<Uint8Array<ArrayBuffer>> {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
  const buffer = document.createBuffer();
  const name = input.name.trim().replace(/\s+/g, "_") || "dance";
  const kept = keptFrames(input.frames.length, input.every);
  const mesh = addMesh(document, buffer, name, input, kept);
  const node = document.createNode(name).setMesh(mesh);
  const scene = document.createScene(name).addChild(node);
  document.getRoot().setDefaultScene(scene);
  document.getRoot().getAsset().generator = "Rigless";
  if (kept.length > 0) {
    const sampler = document
      .createAnimationSampler()
      .setInterpolation("LINEAR")
      .setInput(
        scalars(
          document,
          buffer,
          Float32Array.from(kept, (f) => f / FPS),
        ),
      )
      .setOutput(scalars(document, buffer, identity(kept.length)));
    const channel = document.createAnimationChannel().setTargetNode(node).setTargetPath("weights").setSampler(sampler);
    document.createAnimation(name).addSampler(sampler).addChannel(channel);
  }
  return new WebIO().setVertexLayout(VertexLayout.SEPARATE).writeBinary(document);
}

function addMesh(document: Document, buffer: Buffer, name: string, input: GlbInput, kept: readonly number[]): Mesh {
  const { drawn, faces, frames, scale } = input;
  const vec = (array: Float32Array, type: "VEC2" | "VEC3" = "VEC3"): Accessor =>
    document
      .createAccessor()
      .setType(type)
      .setArray(array as Float32Array<ArrayBuffer>)
      .setBuffer(buffer);
  const rest = onDrawn(drawn, input.rest, scale);
  const restNormals = onDrawn(drawn, vertexNormals(input.rest, faces), 1);
  const index = drawn.toVertex.length < 65535 ? Uint16Array.from(drawn.index) : drawn.index.slice();
  const primitive = document
    .createPrimitive()
    .setIndices(document.createAccessor().setType("SCALAR").setArray(index).setBuffer(buffer))
    .setAttribute("POSITION", vec(rest))
    .setAttribute("NORMAL", vec(restNormals))
    .setMaterial(materialOf(document, drawn));
  if (drawn.colors) primitive.setAttribute("COLOR_0", vec(drawn.colors.slice()));
  if (drawn.uvs) primitive.setAttribute("TEXCOORD_0", vec(drawn.uvs.slice(), "VEC2"));
  for (const f of kept) {
    const { positions } = frames[f];
    primitive.addTarget(
      document
        .createPrimitiveTarget(`frame_${f}`)
        .setAttribute("POSITION", vec(difference(onDrawn(drawn, positions, scale), rest)))
        .setAttribute("NORMAL", vec(difference(onDrawn(drawn, vertexNormals(positions, faces), 1), restNormals))),
    );
  }
  return document
    .createMesh(name)
    .addPrimitive(primitive)
    .setWeights(kept.map(() => 0))
    .setExtras({ targetNames: kept.map((f) => `frame_${f}`) });
}

function materialOf(document: Document, drawn: DrawnSource): ReturnType<Document["createMaterial"]> {
  const material = document.createMaterial("skin").setMetallicFactor(0).setRoughnessFactor(0.8).setDoubleSided(true);
  const { texture } = drawn;
  // Core glTF knows PNG and JPEG only.
  if (texture && texture.mime !== "image/webp") {
    const bytes = texture.bytes.slice();
    material.setBaseColorTexture(document.createTexture("skin").setImage(bytes).setMimeType(texture.mime));
  } else if (!drawn.colors) {
    material.setBaseColorFactor([CLAY[0], CLAY[1], CLAY[2], 1]);
  }
  return material;
}

function scalars(document: Document, buffer: Buffer, array: Float32Array<ArrayBuffer>): Accessor {
  return document.createAccessor().setType("SCALAR").setArray(array).setBuffer(buffer);
}

/** Weights at key n: target n alone. */
function identity(n: number): Float32Array<ArrayBuffer> {
  const out = new Float32Array(n * n);
  for (let k = 0; k < n; k++) out[k * n + k] = 1;
  return out;
}

/** R x 3 of V x 3 values. */
function onDrawn(drawn: DrawnSource, values: Float32Array, scale: number): Float32Array {
  const out = new Float32Array(3 * drawn.toVertex.length);
  drawn.toVertex.forEach((v, r) => {
    for (let k = 0; k < 3; k++) out[3 * r + k] = scale * values[3 * v + k];
  });
  return out;
}

function difference(a: Float32Array, b: Float32Array): Float32Array {
  return a.map((x, i) => x - b[i]);
}
