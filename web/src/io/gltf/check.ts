// Files from strangers: everything that the other modules of this folder and three.js count on is looked at here, before anybody walks
// it. What is only odd stays; what would hang, overflow or read elsewhere is refused. Messages say what of the file is wrong.

import { COMPONENTS, WIDTHS } from "../../gltf/accessors";
import type { Gltf, GltfAccessor, GltfBufferView, GltfPrimitive } from "../../gltf/document";
import { count } from "../count";
import { ModelError } from "../named-file";

/** Bytes that one file may unpack to. */
export const MOST_UNPACKED = 2 ** 28;
/** Triangles and vertices of all that is drawn. */
const MOST_TRIANGLES = 8_000_000;
const MOST_VERTICES = 3 * MOST_TRIANGLES;

export function broken(name: string, what: string): ModelError {
  return new ModelError(`${name} is a broken glTF file: ${what}.`);
}

const isWhole = (x: unknown, most: number): x is number => Number.isInteger(x) && (x as number) >= 0 && (x as number) <= most;
const isObject = (x: unknown): x is Record<string, unknown> => typeof x === "object" && x !== null && !Array.isArray(x);
const isNumbers = (x: unknown, n: number): x is number[] => Array.isArray(x) && x.length === n && x.every(Number.isFinite);

const LISTS = ["accessors", "animations", "buffers", "bufferViews", "cameras", "images", "materials", "meshes", "nodes"] as const;
const MORE_LISTS = ["samplers", "scenes", "skins", "textures"] as const;

/** What can be said without the bytes: kinds, numbers that name other parts, and that nodes are no circle. Errors (ModelError). */
export function checkJson(name: string, json: Gltf): void {
  const no = (what: string): ModelError => broken(name, what);
  for (const list of [...LISTS, ...MORE_LISTS]) {
    const items: unknown = json[list];
    if (items !== undefined && !(Array.isArray(items) && items.every(isObject))) throw no(`its ${list} are no list of objects`);
  }
  const size = (list: (typeof LISTS)[number] | (typeof MORE_LISTS)[number]): number => json[list]?.length ?? 0;
  const names = (x: unknown, list: Parameters<typeof size>[0], who: string): void => {
    if (x !== undefined && !isWhole(x, size(list) - 1)) throw no(`${who} names one of its ${list} that is not there`);
  };
  const namesAll = (x: unknown, list: Parameters<typeof size>[0], who: string): void => {
    if (x === undefined) return;
    if (!Array.isArray(x)) throw no(`${who} holds no list of ${list}`);
    for (const each of x) names(each ?? -1, list, who);
  };

  names(json.scene, "scenes", "the file");
  json.scenes?.forEach(({ nodes }, s) => namesAll(nodes, "nodes", `scene ${s}`));
  json.skins?.forEach(({ joints, inverseBindMatrices }, s) => {
    namesAll(joints ?? -1, "nodes", `skin ${s}`);
    names(inverseBindMatrices, "accessors", `skin ${s}`);
  });
  json.images?.forEach(({ bufferView }, i) => names(bufferView, "bufferViews", `image ${i}`));
  json.textures?.forEach(({ source, sampler }, t) => {
    names(source, "images", `texture ${t}`);
    names(sampler, "samplers", `texture ${t}`);
  });
  json.materials?.forEach((material, m) => checkMaterial(material, (x) => names(x, "textures", `material ${m}`), 0));
  json.meshes?.forEach(({ primitives }, m) => {
    if (!(Array.isArray(primitives) && primitives.every((primitive) => isObject(primitive) && isObject(primitive.attributes)))) {
      throw no(`mesh ${m} holds no primitives`);
    }
    for (const { attributes, indices, material, targets = [] } of primitives) {
      if (!(Array.isArray(targets) && targets.every(isObject))) throw no(`mesh ${m} has shape keys that are none`);
      for (const map of [attributes, ...targets]) for (const index of Object.values(map)) names(index ?? -1, "accessors", `mesh ${m}`);
      names(indices, "accessors", `mesh ${m}`);
      names(material, "materials", `mesh ${m}`);
    }
  });
  json.nodes?.forEach((node, n) => {
    names(node.mesh, "meshes", `node ${n}`);
    names(node.skin, "skins", `node ${n}`);
    namesAll(node.children, "nodes", `node ${n}`);
    for (const [key, width] of [
      ["matrix", 16],
      ["translation", 3],
      ["rotation", 4],
      ["scale", 3],
    ] as const) {
      if (node[key] !== undefined && !isNumbers(node[key], width)) throw no(`the ${key} of node ${n} is not ${width} numbers`);
    }
  });
  checkTree(json, no);
}

/** Whatever has the place of a texture in it, extensions too. */
function checkMaterial(part: unknown, names: (texture: unknown) => void, depth: number): void {
  if (!isObject(part) || depth > 4) return;
  for (const [key, value] of Object.entries(part)) {
    if (/texture$/i.test(key) && isObject(value) && "index" in value) names(value.index);
    else if (key !== "extras") checkMaterial(value, names, depth + 1);
  }
}

/** Errors: a node that is among its own children's children. No recursion: files may nest a hundred thousand deep. */
function checkTree({ nodes = [] }: Gltf, no: (what: string) => ModelError): void {
  const state = new Uint8Array(nodes.length); // 1: on the way down, 2: done
  for (let root = 0; root < nodes.length; root++) {
    const stack = [root];
    while (stack.length > 0) {
      const node = stack[stack.length - 1];
      if (state[node] !== 0) {
        if (state[node] === 1) state[node] = 2;
        stack.pop();
        continue;
      }
      state[node] = 1;
      for (const child of nodes[node].children ?? []) {
        if (state[child] === 1) throw no(`node ${child} is inside itself`);
        if (state[child] === 0) stack.push(child);
      }
    }
  }
}

/** Views against the buffers that are there; those of `skip` are packed, and their unpacker looks. Errors (ModelError). */
export function checkViews(
  name: string,
  { bufferViews = [] }: Gltf,
  buffers: readonly Uint8Array[],
  skip: (view: GltfBufferView) => boolean,
) {
  bufferViews.forEach((view, i) => {
    const { buffer, byteOffset = 0, byteLength, byteStride = 0 } = view;
    const most = Number.MAX_SAFE_INTEGER;
    if (!isWhole(buffer, buffers.length - 1) || !isWhole(byteOffset, most) || !isWhole(byteLength, most) || !isWhole(byteStride, 1024)) {
      throw broken(name, `buffer view ${i} is none`);
    }
    if (!skip(view) && byteOffset + byteLength > buffers[buffer].length) throw broken(name, "it ends early or its parts do not fit");
  });
}

/** Accessors against their views, and what primitives and skins take them for. Errors (ModelError). */
export function checkAccessors(name: string, json: Gltf): void {
  const { accessors = [], meshes = [], skins = [] } = json;
  const most = Math.max(0, ...accessors.map(({ bufferView, count }) => (bufferView === undefined ? 0 : count)));
  accessors.forEach((accessor, a) => {
    if (!isSound(accessor, json)) throw broken(name, "it ends early or its parts do not fit");
    // Without bytes it is all zeros, which serves only beside vertices that have some.
    if (accessor.bufferView === undefined && accessor.count > most) throw broken(name, `accessor ${a} has no bytes`);
  });
  const isOf = (index: number | undefined, type: string, ...components: number[]): boolean => {
    const accessor = index === undefined ? undefined : accessors[index];
    return accessor !== undefined && accessor.type === type && (components.length === 0 || components.includes(accessor.componentType));
  };
  meshes.forEach(({ primitives }, m) => {
    for (const { attributes, indices, targets = [] } of primitives) {
      const { POSITION } = attributes;
      if (POSITION === undefined) continue;
      const { count } = accessors[POSITION];
      if (!isOf(POSITION, "VEC3")) throw broken(name, `the positions of mesh ${m} are not in threes`);
      if (indices !== undefined && !isOf(indices, "SCALAR", 5121, 5123, 5125)) throw broken(name, `mesh ${m} has an index that is none`);
      for (const map of [attributes, ...targets]) {
        if (Object.values(map).some((index) => accessors[index].count !== count))
          throw broken(name, `mesh ${m} has vertices of different numbers`);
      }
      for (const key of ["POSITION", "NORMAL"]) {
        if ([attributes, ...targets].some((map) => map[key] !== undefined && !isOf(map[key], "VEC3"))) {
          throw broken(name, `mesh ${m} has a ${key.toLowerCase()} that is not three numbers`);
        }
      }
      for (const key of Object.keys(attributes).filter((known) => /^(JOINTS|WEIGHTS)_/.test(known))) {
        if (!isOf(attributes[key], "VEC4")) throw broken(name, `mesh ${m} is bound to its skeleton in an unknown way`);
      }
    }
  });
  skins.forEach(({ joints, inverseBindMatrices }, s) => {
    if (inverseBindMatrices === undefined) return;
    if (!isOf(inverseBindMatrices, "MAT4") || accessors[inverseBindMatrices].count < joints.length)
      throw broken(name, `skin ${s} has too few matrices`);
  });
}

function isSound({ bufferView, byteOffset = 0, componentType, count, type, sparse }: GltfAccessor, json: Gltf): boolean {
  const component = COMPONENTS[componentType];
  const width = WIDTHS[type];
  if (!component || !width || !isWhole(count, MOST_VERTICES) || !isWhole(byteOffset, Number.MAX_SAFE_INTEGER)) return false;
  if (bufferView !== undefined && !fits(json, bufferView, byteOffset, count, component.size * width, component.size)) return false;
  if (sparse === undefined) return true;
  const { indices, values } = sparse;
  if (!isObject(indices) || !isObject(values) || ![5121, 5123, 5125].includes(indices.componentType)) return false;
  if (!isWhole(sparse.count, count)) return false;
  const indexSize = COMPONENTS[indices.componentType].size;
  return (
    fits(json, indices.bufferView, indices.byteOffset ?? 0, sparse.count, indexSize, indexSize) &&
    fits(json, values.bufferView, values.byteOffset ?? 0, sparse.count, component.size * width, component.size)
  );
}

/** Typed arrays on the bytes want whole components, from the start of the view on. */
function fits({ bufferViews = [] }: Gltf, index: unknown, offset: number, count: number, element: number, component: number): boolean {
  const view = isWhole(index, bufferViews.length - 1) ? bufferViews[index] : null;
  if (!view || !isWhole(offset, view.byteLength)) return false;
  const stride = view.byteStride || element;
  if (stride % component !== 0 || offset % component !== 0 || stride < element) return false;
  return count === 0 || offset + (count - 1) * stride + element <= view.byteLength;
}

/** The places of its corners that a primitive's triangles take; 0 for points and lines. */
export function trianglesIn({ accessors = [] }: Gltf, { attributes, indices, mode = 4 }: GltfPrimitive): number {
  const from = indices ?? attributes.POSITION;
  const corners = attributes.POSITION === undefined || from === undefined ? 0 : accessors[from].count;
  if (mode === 4) return Math.floor(corners / 3);
  return mode === 5 || mode === 6 ? Math.max(0, corners - 2) : 0;
}

/** Errors (ModelError): so much that nobody's memory holds it, which few bytes can ask for. */
export function checkSize(name: string, triangles: number): void {
  if (triangles <= MOST_TRIANGLES) return;
  throw new ModelError(`${name} holds ${count(triangles, "triangle")}, and we open 8,000,000 at most. Simplify it first.`);
}
