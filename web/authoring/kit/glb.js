// A minimal GLB: one mesh, one material with a picture. Normals are whole numbers (KHR_mesh_quantization), four bytes each.
import { creasedNormals } from "./normals.js";

/** Corners with equal position and texture coordinate become one vertex. Texture coordinates are 16-bit, as glTF allows. */
function indexCorners(vertices, triangles, uv) {
  const seen = new Map();
  const corners = [];
  const indices = triangles.flatMap((t, f) =>
    t.map((v, k) => {
      const st = uv[f][k].map((x) => Math.round(x * 65535));
      const key = [v, ...st].join();
      if (!seen.has(key)) seen.set(key, corners.push({ v, p: vertices[v], st }) - 1);
      return seen.get(key);
    }),
  );
  return { corners, indices };
}

const pad = (buffer, fill) => Buffer.concat([buffer, Buffer.alloc((4 - (buffer.length % 4)) % 4, fill)]);

/** triangles: vertex triples; uv: per triangle three [u, v]; png: a file's bytes. */
export function encodeGlb({ name, vertices, triangles, uv, png, roughness }) {
  const joined = indexCorners(vertices, triangles, uv);
  const pointOf = joined.corners.map(({ v }) => v);
  const { indices, source, normals } = creasedNormals({ points: vertices, indices: joined.indices, pointOf });
  const corners = source.map((i) => joined.corners[i]);
  const blocks = [
    Buffer.from(Float32Array.from(corners.flatMap((c) => c.p)).buffer),
    Buffer.from(Uint16Array.from(corners.flatMap((c) => c.st)).buffer),
    pad(Buffer.from(Uint16Array.from(indices).buffer), 0),
    pad(png, 0),
    Buffer.from(normals.buffer),
  ];
  const offsets = blocks.map((_, i) => blocks.slice(0, i).reduce((sum, b) => sum + b.length, 0));
  const bound = (f) => [0, 1, 2].map((k) => Math.fround(f(...corners.map((c) => c.p[k]))));
  const view = (i, target, byteLength = blocks[i].length) => ({ buffer: 0, byteOffset: offsets[i], byteLength, ...(target && { target }) });
  const used = ["KHR_mesh_quantization"];
  const json = {
    asset: { version: "2.0", generator: "rigless authoring" },
    extensionsUsed: used,
    extensionsRequired: used,
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [{ name, primitives: [{ attributes: { POSITION: 0, NORMAL: 3, TEXCOORD_0: 1 }, indices: 2, material: 0 }] }],
    materials: [{ name, pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: roughness } }],
    textures: [{ source: 0, sampler: 0 }],
    samplers: [{ magFilter: 9729, minFilter: 9987, wrapS: 33071, wrapT: 33071 }],
    images: [{ name, mimeType: "image/png", bufferView: 3 }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: corners.length, type: "VEC3", min: bound(Math.min), max: bound(Math.max) },
      { bufferView: 1, componentType: 5123, normalized: true, count: corners.length, type: "VEC2" },
      { bufferView: 2, componentType: 5123, count: indices.length, type: "SCALAR" },
      { bufferView: 4, componentType: 5120, normalized: true, count: corners.length, type: "VEC3" },
    ],
    bufferViews: [
      view(0, 34962),
      view(1, 34962),
      view(2, 34963, indices.length * 2),
      view(3, 0, png.length),
      { ...view(4, 34962), byteStride: 4 },
    ],
    buffers: [{ byteLength: blocks.reduce((sum, b) => sum + b.length, 0) }],
  };
  const text = pad(Buffer.from(JSON.stringify(json)), 0x20);
  const binary = Buffer.concat(blocks);
  const head = (length, type) => {
    const b = Buffer.alloc(8);
    b.writeUInt32LE(length, 0);
    b.write(type, 4, "latin1");
    return b;
  };
  const header = Buffer.alloc(12);
  header.write("glTF", 0, "latin1");
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(12 + 16 + text.length + binary.length, 8);
  return Buffer.concat([header, head(text.length, "JSON"), text, head(binary.length, "BIN\0"), binary]);
}
