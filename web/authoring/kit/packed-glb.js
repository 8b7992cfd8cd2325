// A GLB in few bytes: whole-number positions (KHR_mesh_quantization), meshopt's codecs (EXT_meshopt_compression), and of a
// symmetric mesh only one half, which two nodes show, one of them mirrored.
import { MeshoptEncoder } from "meshoptimizer/encoder";
import { creasedNormals } from "./normals.js";

const STEPS = 8191; // of the longest side: .2 mm of a figure of 1.7 m

const pad = (bytes, fill = 0) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);

/**
 * uv: three [u, v] a triangle; png: the picture's bytes. half: vertices with x >= 0 alone, those
 * on x = 0 exactly there. flat: without normals, for triangles so small that nobody sees them. Returns the file's bytes.
 */
export async function encodePackedGlb({ name, vertices, triangles, uv, png, half, roughness, flat = false }) {
  await MeshoptEncoder.ready;
  const { corners, indices } = join(triangles, uv);
  const order = Uint32Array.from(indices); // becomes the order that packs best, over the vertices' new numbers
  const [remap, joined] = MeshoptEncoder.reorderMesh(order, true, true);
  const before = new Array(joined);
  corners.forEach((c, i) => (before[remap[i]] = c));
  const creased = flat ? null : creasedNormals({ points: vertices, indices: order, pointOf: before.map(({ v }) => v), half });
  const ordered = creased ? creased.source.map((i) => before[i]) : before;
  const count = ordered.length;

  const low = [0, 1, 2].map((k) => (half && k === 0 ? 0 : vertices.reduce((m, v) => Math.min(m, v[k]), Infinity)));
  const step = Math.max(...[0, 1, 2].map((k) => vertices.reduce((m, v) => Math.max(m, v[k] - low[k]), 0))) / STEPS;
  const places = new Int16Array(4 * count);
  ordered.forEach(({ v }, i) =>
    places.set(
      vertices[v].map((x, k) => Math.round((x - low[k]) / step)),
      4 * i,
    ),
  );
  const bound = (pick) => [0, 1, 2].map((k) => places.reduce((m, x, i) => (i % 4 === k ? pick(m, x) : m), places[k]));

  const blocks = [
    {
      bytes: places,
      stride: 8,
      accessor: { componentType: 5122, type: "VEC3", min: bound(Math.min), max: bound(Math.max) },
      as: "POSITION",
    },
  ];
  blocks.push({
    bytes: Uint16Array.from(ordered.flatMap((c) => c.st)),
    stride: 4,
    accessor: { componentType: 5123, normalized: true, type: "VEC2" },
    as: "TEXCOORD_0",
  });
  blocks.push({ bytes: creased.normals, stride: 4, accessor: { componentType: 5120, normalized: true, type: "VEC3" }, as: "NORMAL" });
  const index = count > 65535 ? Uint32Array : Uint16Array;
  blocks.push({
    bytes: creased ? Uint32Array.from(creased.indices) : order,
    stride: index.BYTES_PER_ELEMENT,
    accessor: { componentType: index === Uint32Array ? 5125 : 5123, type: "SCALAR" },
  });

  let [packedAt, plainAt] = [0, 0];
  const binary = [];
  const bufferViews = blocks.map(({ bytes, stride, as }) => {
    const n = as ? count : indices.length;
    const source = new Uint8Array(as ? bytes.buffer : index.from(bytes).buffer);
    const mode = as ? "ATTRIBUTES" : "TRIANGLES";
    const packed = MeshoptEncoder.encodeGltfBuffer(source, n, stride, mode, 0);
    const view = {
      buffer: 1,
      byteOffset: plainAt,
      byteLength: n * stride,
      ...(as && { byteStride: stride }),
      target: as ? 34962 : 34963,
      extensions: {
        EXT_meshopt_compression: { buffer: 0, byteOffset: packedAt, byteLength: packed.length, byteStride: stride, count: n, mode },
      },
    };
    const padded = pad(Buffer.from(packed));
    binary.push(padded);
    packedAt += padded.length;
    plainAt += Math.ceil((n * stride) / 4) * 4;
    return view;
  });
  bufferViews.push({ buffer: 0, byteOffset: packedAt, byteLength: png.length });
  binary.push(pad(png));
  packedAt += binary.at(-1).length;
  const node = (x) => ({ name, mesh: 0, translation: low, scale: [x * step, step, step] });
  const used = ["EXT_meshopt_compression", "KHR_mesh_quantization"];
  return glb(
    {
      asset: { version: "2.0", generator: "rigless authoring" },
      extensionsUsed: used,
      extensionsRequired: used,
      scene: 0,
      scenes: [{ nodes: half ? [0, 1] : [0] }],
      nodes: half ? [node(1), node(-1)] : [node(1)],
      meshes: [
        {
          name,
          primitives: [
            {
              attributes: Object.fromEntries(blocks.flatMap((b, i) => (b.as ? [[b.as, i]] : []))),
              indices: blocks.length - 1,
              material: 0,
            },
          ],
        },
      ],
      materials: [{ name, pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: roughness } }],
      textures: [{ source: 0, sampler: 0 }],
      samplers: [{ magFilter: 9729, minFilter: 9987, wrapS: 33071, wrapT: 33071 }],
      images: [{ name, mimeType: "image/png", bufferView: blocks.length }],
      accessors: blocks.map(({ accessor, as }, i) => ({ bufferView: i, count: as ? count : indices.length, ...accessor })),
      bufferViews,
      buffers: [{ byteLength: packedAt }, { byteLength: plainAt, extensions: { EXT_meshopt_compression: { fallback: true } } }],
    },
    Buffer.concat(binary),
  );
}

/** Corners with one vertex and one place in the picture are one; places in the picture on a grid of 4096. */
function join(triangles, uv) {
  const seen = new Map();
  const corners = [];
  const indices = triangles.flatMap((t, f) =>
    t.map((v, k) => {
      const st = uv[f][k].map((x) => Math.min(65535, Math.round(x * 4096) * 16));
      const key = [v, ...st].join();
      if (!seen.has(key)) seen.set(key, corners.push({ v, st }) - 1);
      return seen.get(key);
    }),
  );
  return { corners, indices };
}

function glb(json, binary) {
  const text = pad(Buffer.from(JSON.stringify(json)), 0x20);
  const header = Buffer.alloc(20);
  header.write("glTF", 0, "latin1");
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(28 + text.length + binary.length, 8);
  header.writeUInt32LE(text.length, 12);
  header.write("JSON", 16, "latin1");
  const head = Buffer.alloc(8);
  head.writeUInt32LE(binary.length, 0);
  head.write("BIN\0", 4, "latin1");
  return Buffer.concat([header, text, head, binary]);
}
