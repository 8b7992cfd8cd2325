// Two GLBs of ours as one: both scenes' nodes in one scene, and clips of one name as one clip.

import type { Gltf, GltfAnimation, GltfNode } from "../../gltf/document";
import { split } from "./read";
import { packGlb } from "./write";

/** Where the second one hangs; it can be moved by it. */
export type Placed = Required<Pick<GltfNode, "name" | "translation" | "rotation">>;

type List = "accessors" | "bufferViews" | "images" | "materials" | "meshes" | "nodes" | "samplers" | "skins" | "textures";

/** What extensions of the whole second file say is left out: they name its things by number, in ways of their own. */
export function joinGlbs(first: Uint8Array, second: Uint8Array, placed: Placed): Uint8Array<ArrayBuffer> {
  const [a, b] = [split("The first one", first), split("The second one", second)];
  const begin = (a.bin?.length ?? 0) + (-(a.bin?.length ?? 0) & 3);
  const bytes = new Uint8Array(begin + (b.bin?.length ?? 0));
  if (a.bin) bytes.set(a.bin);
  if (b.bin) bytes.set(b.bin, begin);
  const moved = renumbered(b.json, a.json, begin);
  const both = <K extends List>(list: K): Pick<Gltf, K> => {
    const joined = [...(a.json[list] ?? []), ...(moved[list] ?? [])];
    return (joined.length > 0 ? { [list]: joined } : {}) as unknown as Pick<Gltf, K>;
  };
  const nodes = both("nodes").nodes ?? [];
  const roots = moved.scenes?.[0]?.nodes ?? [];
  const isSkinned = (root: number): boolean => nodes[root].skin !== undefined; // its joints carry it, wherever it hangs
  const wrap = nodes.length;
  const scenes = [
    { ...a.json.scenes?.[0], nodes: [...(a.json.scenes?.[0]?.nodes ?? []), wrap, ...roots.filter(isSkinned)] },
    ...(a.json.scenes?.slice(1) ?? []),
  ];
  const text = JSON.stringify(moved);
  const used = b.json.extensionsUsed?.filter((name) => text.includes(`"${name}":`) || name === "KHR_mesh_quantization") ?? [];
  const extensionsUsed = [...new Set([...(a.json.extensionsUsed ?? []), ...used])];
  const required = b.json.extensionsRequired?.filter((name) => used.includes(name)) ?? [];
  const extensionsRequired = [...new Set([...(a.json.extensionsRequired ?? []), ...required])];
  const json: Gltf = {
    ...a.json,
    ...both("accessors"),
    ...both("bufferViews"),
    ...both("images"),
    ...both("materials"),
    ...both("meshes"),
    ...both("samplers"),
    ...both("skins"),
    ...both("textures"),
    nodes: [...nodes, { ...placed, children: roots.filter((root) => !isSkinned(root)) }],
    scenes,
    animations: together(a.json.animations ?? [], moved.animations ?? []),
    buffers: [{ byteLength: bytes.length }],
    ...(extensionsUsed.length > 0 && { extensionsUsed }),
    ...(extensionsRequired.length > 0 && { extensionsRequired }),
  };
  return packGlb({ json, buffers: [bytes], images: [] });
}

/** The second one's JSON with numbers that lie behind those of the first. */
function renumbered(json: Gltf, first: Gltf, begin: number): Gltf {
  const by = (list: List) => (index: number) => index + (first[list]?.length ?? 0);
  const [accessor, view, node, texture] = [by("accessors"), by("bufferViews"), by("nodes"), by("textures")];
  const all = (map: Record<string, number>): Record<string, number> =>
    Object.fromEntries(Object.entries(map).map(([name, index]) => [name, accessor(index)]));
  const some = <K extends string>(key: K, value: number | undefined, move: (index: number) => number) =>
    (value === undefined ? {} : { [key]: move(value) }) as Partial<Record<K, number>>;
  const animations = json.animations as OurAnimation[] | undefined;
  return {
    asset: json.asset,
    accessors: json.accessors?.map((one) => ({
      ...one,
      ...some("bufferView", one.bufferView, view),
      ...(one.sparse && {
        sparse: {
          ...one.sparse,
          indices: { ...one.sparse.indices, bufferView: view(one.sparse.indices.bufferView) },
          values: { ...one.sparse.values, bufferView: view(one.sparse.values.bufferView) },
        },
      }),
    })),
    bufferViews: json.bufferViews?.map((one) => ({ ...one, byteOffset: (one.byteOffset ?? 0) + begin })),
    images: json.images?.map((one) => ({ ...one, ...some("bufferView", one.bufferView, view) })),
    materials: json.materials?.map((one) => withTextures(one, texture)),
    meshes: json.meshes?.map((mesh) => ({
      ...mesh,
      primitives: mesh.primitives.map(({ extensions: _, ...one }) => ({
        ...one,
        attributes: all(one.attributes),
        ...some("indices", one.indices, accessor),
        ...some("material", one.material, by("materials")),
        ...(one.targets && { targets: one.targets.map(all) }),
      })),
    })),
    nodes: json.nodes?.map(({ extensions: _, ...one }) => ({
      ...one,
      ...(one.children && { children: one.children.map(node) }),
      ...some("mesh", one.mesh, by("meshes")),
      ...some("skin", one.skin, by("skins")),
    })),
    samplers: json.samplers,
    scenes: json.scenes?.map((one) => ({ ...one, ...(one.nodes && { nodes: one.nodes.map(node) }) })),
    skins: json.skins?.map((one) => ({
      ...one,
      joints: one.joints.map(node),
      ...some("skeleton", one.skeleton, node),
      ...some("inverseBindMatrices", one.inverseBindMatrices, accessor),
    })),
    textures: json.textures?.map((one) => ({
      ...one,
      ...some("sampler", one.sampler, by("samplers")),
      ...some("source", one.source, by("images")),
      ...(one.extensions && { extensions: withSources(one.extensions, by("images")) }),
    })),
    animations: animations?.map((one) => ({
      ...one,
      samplers: one.samplers.map((sampler) => ({ ...sampler, input: accessor(sampler.input), output: accessor(sampler.output) })),
      channels: one.channels.map((channel) => ({ ...channel, target: { ...channel.target, node: node(channel.target.node) } })),
    })),
  };
}

interface OurAnimation extends GltfAnimation {
  channels: { sampler: number; target: { node: number; path: string } }[];
}

/** Pictures of a material lie under keys that end in "Texture", in extensions too. */
function withTextures<T>(value: T, move: (index: number) => number): T {
  if (Array.isArray(value)) return value.map((one: unknown) => withTextures(one, move)) as T;
  if (typeof value !== "object" || value === null) return value;
  const entries = Object.entries(value).map(([key, inner]: [string, unknown]) => {
    const next = withTextures(inner, move);
    return [key, /[tT]exture$/.test(key) && hasIndex(next) ? { ...next, index: move(next.index) } : next];
  });
  return Object.fromEntries(entries) as T;
}

const hasIndex = (value: unknown): value is { index: number } =>
  typeof value === "object" && value !== null && "index" in value && typeof value.index === "number";

/** Other kinds of picture of a texture: KHR_texture_basisu, EXT_texture_webp. */
function withSources(extensions: Record<string, unknown>, move: (index: number) => number): Record<string, unknown> {
  const moved = Object.entries(extensions).map(([name, one]) => {
    const source = typeof one === "object" && one !== null && "source" in one ? one.source : undefined;
    return [name, typeof source === "number" ? { ...(one as object), source: move(source) } : one];
  });
  return Object.fromEntries(moved);
}

/** Clips of one name are one clip. */
function together(first: GltfAnimation[], second: GltfAnimation[]): GltfAnimation[] {
  const joined = first.map((one) => {
    const other = second.find(({ name }) => name === one.name);
    if (!other) return one;
    const channels = (other.channels as OurAnimation["channels"]).map((channel) => ({
      ...channel,
      sampler: channel.sampler + one.samplers.length,
    }));
    return { ...one, samplers: [...one.samplers, ...other.samplers], channels: [...one.channels, ...channels] };
  });
  return [...joined, ...second.filter(({ name }) => !first.some((one) => one.name === name))];
}
