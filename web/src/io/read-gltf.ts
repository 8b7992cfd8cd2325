// GLB and glTF through glTF Transform: it needs no DOM and fetches nothing, so the page, its worker and Node read alike.
// A skinned or morphed model is taken in its current pose.

import {
  BufferUtils,
  type Document,
  type GLTF,
  type JSONDocument,
  Logger,
  type mat4,
  type Material,
  type Node,
  Primitive,
  type Texture,
  WebIO,
} from "@gltf-transform/core";

import { forgetFallbacks, hasMeshopt, unpackMeshopt } from "./meshopt";
import type { Picture } from "../gltf/document";
import { count } from "./count";
import type { Part } from "./model";
import { baseName, decodeUri, findFile, ModelError, type NamedFile } from "./named-file";
import { checkedPicture } from "./picture";

const GLB_BIN = "@glb.bin";

/** Errors (ModelError): not glTF 2.0; broken; compressed with Draco; a .bin that is missing; no triangles. */
export async function readGltf(
  name: string,
  file: NamedFile,
  files: readonly NamedFile[],
  notes: string[],
): Promise<{ parts: Part[]; texture: Picture | null }> {
  try {
    return await readSound(name, file, files, notes);
  } catch (error) {
    // What glTF Transform and we run into where a file's parts are of another kind or size than they say.
    if (error instanceof TypeError || error instanceof RangeError) throw broken(name);
    throw error;
  }
}

function broken(name: string): ModelError {
  return new ModelError(`${name} is a broken glTF file: it ends early or its parts do not fit.`);
}

async function readSound(
  name: string,
  file: NamedFile,
  files: readonly NamedFile[],
  notes: string[],
): Promise<{ parts: Part[]; texture: Picture | null }> {
  const source = splitGlb(name, file.bytes);
  const { json } = source;
  if (typeof json.asset?.version !== "string" || !json.asset.version.startsWith("2")) throw new ModelError(`${name} is not glTF 2.0.`);
  if (json.extensionsRequired?.includes("KHR_draco_mesh_compression")) {
    throw new ModelError(`${name} is compressed with Draco. Save it without compression.`);
  }
  forgetFallbacks(json);
  addResources(name, file.name, source, files);
  if (hasMeshopt(json)) await unpack(name, source);
  const pictureFrames = json.materials?.map(frameOf) ?? [];
  keepBaseColor(json);
  json.extensionsRequired = [];
  json.extensionsUsed = [];

  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT));
  const document = await io.readJSON(source);
  const scene = document.getRoot().getDefaultScene() ?? document.getRoot().listScenes()[0];
  const parts: Part[] = [];
  const found: Found = { pictures: new Set(), skinned: false, morphed: false };
  const visit = (node: Node): void => {
    parts.push(
      ...partsOf(
        node,
        found,
        (primitive) =>
          pictureFrames[
            document
              .getRoot()
              .listMaterials()
              .indexOf(primitive.getMaterial() as Material)
          ],
      ),
    );
    node.listChildren().forEach(visit);
  };
  (scene
    ? scene.listChildren()
    : document
        .getRoot()
        .listNodes()
        .filter((node) => !node.getParentNode())
  ).forEach(visit);
  if (parts.length === 0) throw new ModelError(`${name} has no triangles. ${whatElse(document)}`.trim());
  if (found.skinned) notes.push("This file already has a skeleton. We use its current pose and leave the bones out.");
  if (found.morphed) notes.push("This file has shape keys. We use its current shape.");

  return { parts, texture: textureOf([...found.pictures], notes) };
}

async function unpack(name: string, source: JSONDocument): Promise<void> {
  try {
    await unpackMeshopt(source, (buffer) => {
      const { uri } = (source.json.buffers ?? [])[buffer];
      return uri?.startsWith("data:") ? BufferUtils.createBufferFromDataURI(uri) : source.resources[uri ?? GLB_BIN];
    });
  } catch {
    throw broken(name);
  }
}

function textureOf(pictures: readonly Texture[], notes: string[]): Picture | null {
  if (pictures.length > 1) notes.push(`This model has ${pictures.length} pictures; we show its plain colours.`);
  if (pictures.length !== 1) return null;
  const [picture] = pictures;
  const name = baseName(decodeUri(picture.getURI())) || picture.getName() || "Its picture";
  const bytes = picture.getImage();
  if (bytes?.length) return checkedPicture(name, bytes, notes);
  notes.push(`This model names ${name}; drop it too.`);
  return null;
}

function splitGlb(name: string, bytes: Uint8Array): JSONDocument {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let text = bytes;
  const resources: Record<string, Uint8Array<ArrayBuffer>> = {};
  if (bytes.length >= 4 && view.getUint32(0, true) === 0x46546c67) {
    if (bytes.length < 20) throw broken(name);
    const size = view.getUint32(12, true);
    if (20 + size > bytes.length) throw broken(name);
    text = bytes.subarray(20, 20 + size);
    const bin = 20 + size;
    if (bin + 8 <= bytes.length && view.getUint32(bin + 4, true) === 0x004e4942) {
      const length = view.getUint32(bin, true);
      if (bin + 8 + length > bytes.length) throw broken(name);
      resources[GLB_BIN] = bytes.slice(bin + 8, bin + 8 + length);
    }
  }
  try {
    const json: unknown = JSON.parse(new TextDecoder().decode(text));
    if (typeof json === "object" && json !== null && "asset" in json) return { json: json as GLTF.IGLTF, resources };
  } catch {
    // Not JSON: said below.
  }
  throw new ModelError(`${name} holds no glTF model.`);
}

/** Puts the files beside a .gltf into its resources. Nothing is fetched. */
function addResources(name: string, path: string, source: JSONDocument, files: readonly NamedFile[]): void {
  for (const buffer of source.json.buffers ?? []) {
    if (!buffer.uri || buffer.uri.startsWith("data:")) continue;
    const file = findFile(files, decodeUri(buffer.uri), path);
    if (!file) throw new ModelError(`${name} needs ${baseName(decodeUri(buffer.uri))}; drop both together.`);
    source.resources[buffer.uri] = file.bytes.slice();
  }
  for (const image of source.json.images ?? []) {
    if (!image.uri || image.uri.startsWith("data:")) continue;
    source.resources[image.uri] = findFile(files, decodeUri(image.uri), path)?.bytes.slice() ?? new Uint8Array(0);
  }
}

/** Leaves of each material what we draw, so that nothing else can be broken. */
function keepBaseColor(json: GLTF.IGLTF): void {
  json.materials = json.materials?.map(({ pbrMetallicRoughness: pbr }) => {
    const index = pbr?.baseColorTexture?.index;
    const drawn = index !== undefined && json.textures?.[index]?.source !== undefined;
    return {
      pbrMetallicRoughness: {
        ...(pbr?.baseColorFactor && { baseColorFactor: pbr.baseColorFactor }),
        ...(drawn && { baseColorTexture: pbr?.baseColorTexture }),
      },
    };
  });
  delete json.animations;
}

interface Found {
  pictures: Set<Texture>;
  skinned: boolean;
  morphed: boolean;
}

/** A place in the picture from one of the file: KHR_texture_transform, with which quantised files bring theirs back to 0 to 1. */
type Frame = (u: number, v: number) => [number, number];

function frameOf(material: GLTF.IMaterial): Frame | undefined {
  const transform: unknown = material.pbrMetallicRoughness?.baseColorTexture?.extensions?.KHR_texture_transform;
  if (typeof transform !== "object" || transform === null) return undefined;
  const { offset = [0, 0], scale = [1, 1], rotation = 0 } = transform as { offset?: number[]; scale?: number[]; rotation?: number };
  const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
  return (u, v) => [c * scale[0] * u + s * scale[1] * v + offset[0], -s * scale[0] * u + c * scale[1] * v + offset[1]];
}

function partsOf(node: Node, found: Found, frameFor: (primitive: Primitive) => Frame | undefined): Part[] {
  const mesh = node.getMesh();
  const parts: Part[] = [];
  for (const primitive of mesh?.listPrimitives() ?? []) {
    const index = trianglesOf(primitive, determinant(node.getWorldMatrix()) < 0);
    const picture = primitive.getMaterial()?.getBaseColorTexture();
    if (index.length === 0) continue;
    if (picture) found.pictures.add(picture);
    found.skinned ||= node.getSkin() !== null;
    found.morphed ||= primitive.listTargets().length > 0;
    parts.push({ positions: posed(node, primitive), index, colors: colorsOf(primitive), uvs: uvsOf(primitive, frameFor(primitive)) });
  }
  return parts;
}

/** Corners of triangles, strips and fans; empty for points and lines. */
function trianglesOf(primitive: Primitive, mirrored: boolean): number[] {
  const indices = primitive.getIndices()?.getArray();
  const n = indices?.length ?? primitive.getAttribute("POSITION")?.getCount() ?? 0;
  const at = (k: number): number => (indices ? indices[k] : k);
  const out: number[] = [];
  const add = (a: number, b: number, c: number): void => void (mirrored ? out.push(at(a), at(c), at(b)) : out.push(at(a), at(b), at(c)));
  switch (primitive.getMode()) {
    case Primitive.Mode.TRIANGLES:
      for (let k = 0; k + 2 < n; k += 3) add(k, k + 1, k + 2);
      break;
    case Primitive.Mode.TRIANGLE_STRIP:
      for (let k = 0; k + 2 < n; k++) k % 2 ? add(k + 1, k, k + 2) : add(k, k + 1, k + 2);
      break;
    case Primitive.Mode.TRIANGLE_FAN:
      for (let k = 1; k + 1 < n; k++) add(0, k, k + 1);
      break;
  }
  return out;
}

/** World positions of a primitive's vertices: shape keys, then the skeleton or the node. */
function posed(node: Node, primitive: Primitive): Float32Array {
  const position = primitive.getAttribute("POSITION");
  if (!position) return new Float32Array(0);
  const weights = node.getWeights().length ? node.getWeights() : (node.getMesh()?.getWeights() ?? []);
  const targets = primitive.listTargets().map((target) => target.getAttribute("POSITION"));
  const place = skinOf(node, primitive) ?? transformBy(node.getWorldMatrix());
  const out = new Float32Array(3 * position.getCount());
  const delta: number[] = [];
  for (let v = 0; v < position.getCount(); v++) {
    const p: number[] = position.getElement(v, []);
    targets.forEach((target, m) => {
      if (!target || !weights[m]) return;
      target.getElement(v, delta);
      for (let k = 0; k < 3; k++) p[k] += weights[m] * delta[k];
    });
    out.set(place(p, v), 3 * v);
  }
  return out;
}

type Place = (p: number[], vertex: number) => number[];

function transformBy(m: readonly number[]): Place {
  return ([x, y, z]) => [0, 1, 2].map((k) => m[k] * x + m[k + 4] * y + m[k + 8] * z + m[k + 12]);
}

/** Linear blend skinning with the joints where the file has them; null if the node has no skin. */
function skinOf(node: Node, primitive: Primitive): Place | null {
  const skin = node.getSkin();
  const sets = [0, 1].flatMap((set) => {
    const joints = primitive.getAttribute(`JOINTS_${set}`);
    const weights = primitive.getAttribute(`WEIGHTS_${set}`);
    return joints && weights ? [{ joints, weights }] : [];
  });
  if (!skin || sets.length === 0) return null;
  const inverse = skin.getInverseBindMatrices();
  const bones = skin.listJoints().map((joint, j) => {
    const world = transformBy(joint.getWorldMatrix());
    const bind = inverse ? transformBy(inverse.getElement(j, new Array<number>(16))) : null;
    return (p: number[], v: number): number[] => world(bind ? bind(p, v) : p, v);
  });
  return (p, v) => {
    const sum = [0, 0, 0];
    for (const { joints, weights } of sets) {
      const j = joints.getElement<number[]>(v, []);
      weights.getElement<number[]>(v, []).forEach((w, k) => {
        if (w === 0 || !bones[j[k]]) return;
        bones[j[k]](p, v).forEach((x, d) => (sum[d] += w * x));
      });
    }
    return sum;
  };
}

/** Vertex colours times the material's colour, linear; null if both are white. */
function colorsOf(primitive: Primitive): Float32Array | null {
  const factor = primitive.getMaterial()?.getBaseColorFactor() ?? [1, 1, 1];
  const color = primitive.getAttribute("COLOR_0");
  const n = primitive.getAttribute("POSITION")?.getCount() ?? 0;
  if (!color && factor.slice(0, 3).every((c) => c === 1)) return null;
  const out = new Float32Array(3 * n);
  for (let v = 0; v < n; v++) {
    const rgb = color ? color.getElement<number[]>(v, []) : [1, 1, 1];
    for (let k = 0; k < 3; k++) out[3 * v + k] = rgb[k] * factor[k];
  }
  return out;
}

function uvsOf(primitive: Primitive, frame: Frame | undefined): Float32Array | null {
  const set = primitive.getMaterial()?.getBaseColorTextureInfo()?.getTexCoord() ?? 0;
  const uv = primitive.getAttribute(`TEXCOORD_${set}`);
  if (!uv) return null;
  const out = new Float32Array(2 * uv.getCount());
  for (let v = 0; v < uv.getCount(); v++) {
    const [s, t] = uv.getElement<number[]>(v, []);
    out.set(frame ? frame(s, t) : [s, t], 2 * v);
  }
  return out;
}

function determinant(m: mat4): number {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) + m[8] * (m[1] * m[6] - m[5] * m[2]);
}

/** "It holds 2 curves and 1 camera." */
function whatElse(document: Document): string {
  const root = document.getRoot();
  const meshes = root.listMeshes().reduce((sum, mesh) => sum + mesh.listPrimitives().length, 0);
  const held = [
    ...(meshes ? [count(meshes, "set of lines or points", "sets of lines or points")] : []),
    ...(root.listCameras().length ? [count(root.listCameras().length, "camera")] : []),
  ];
  return held.length ? `It holds ${held.join(" and ")}.` : "";
}
