// Meshes as OBJ and GLB files.

const digits = (x) => String(+x.toFixed(6));

/** Every part an object of its own; doubles keep their digits. */
export function objText({ positions, faces, parts }) {
  const lines = [];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${digits(positions[i])} ${digits(positions[i + 1])} ${digits(positions[i + 2])}`);
  for (const { name, first, count } of parts) {
    lines.push(`o ${name}`);
    for (let f = first; f < first + count; f++) lines.push(`f ${faces[3 * f] + 1} ${faces[3 * f + 1] + 1} ${faces[3 * f + 2] + 1}`);
  }
  return `${lines.join("\n")}\n`;
}

const align = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);

/** A node per part; parts with a `material` are drawn with that of `materials`: { color: [r, g, b], png }. */
export function glbBytes({ name, positions, faces, parts, materials = [] }) {
  const blocks = [];
  const accessors = [];
  const views = [];
  let offset = 0;
  const view = (array, target) => {
    const bytes = align(Buffer.from(array.buffer, array.byteOffset, array.byteLength), 0);
    views.push({ buffer: 0, byteOffset: offset, byteLength: array.byteLength, ...(target ? { target } : {}) });
    blocks.push(bytes);
    offset += bytes.length;
    return views.length - 1;
  };
  const accessor = (array, componentType, type, count, extra = {}) =>
    accessors.push({ bufferView: view(array, type === "SCALAR" ? 34963 : 34962), componentType, type, count, ...extra }) - 1;
  const pictured = materials.some(({ png }) => png);
  const meshes = parts.map((part) => primitiveOf(part, { positions, faces, accessor, pictured }));
  const images = materials.flatMap(({ png }) => (png ? [{ bufferView: view(png), mimeType: "image/png" }] : []));
  let picture = 0;
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ name, nodes: parts.map((_, n) => n) }],
    nodes: parts.map((part, n) => ({ name: part.name, mesh: n })),
    meshes,
    accessors,
    bufferViews: views,
    buffers: [{ byteLength: offset }],
    ...(materials.length > 0 && {
      materials: materials.map(({ color, png }) => ({
        pbrMetallicRoughness: {
          metallicFactor: 0,
          ...(color && { baseColorFactor: [...color, 1] }),
          ...(png && { baseColorTexture: { index: picture++ } }),
        },
      })),
    }),
    ...(images.length > 0 && {
      images,
      samplers: [{ magFilter: 9728, minFilter: 9728 }],
      textures: images.map((_, n) => ({ source: n, sampler: 0 })),
    }),
  };
  const text = align(Buffer.from(JSON.stringify(json)), 0x20);
  const head = (length, type) => {
    const out = Buffer.alloc(8);
    out.writeUInt32LE(length, 0);
    out.writeUInt32LE(type, 4);
    return out;
  };
  const file = Buffer.alloc(12);
  file.writeUInt32LE(0x46546c67, 0);
  file.writeUInt32LE(2, 4);
  file.writeUInt32LE(12 + 8 + text.length + 8 + offset, 8);
  return Buffer.concat([file, head(text.length, 0x4e4f534a), text, head(offset, 0x004e4942), ...blocks]);
}

function primitiveOf({ name, first, count, material }, { positions, faces, accessor, pictured }) {
  const own = new Map();
  const index = new Uint32Array(3 * count);
  for (let i = 0; i < index.length; i++) {
    const v = faces[3 * first + i];
    if (!own.has(v)) own.set(v, own.size);
    index[i] = own.get(v);
  }
  const places = new Float32Array(3 * own.size);
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const [v, n] of own)
    for (let k = 0; k < 3; k++) {
      places[3 * n + k] = positions[3 * v + k];
      low[k] = Math.min(low[k], places[3 * n + k]);
      high[k] = Math.max(high[k], places[3 * n + k]);
    }
  const attributes = { POSITION: accessor(places, 5126, "VEC3", own.size, { min: low, max: high }) };
  if (pictured) {
    const uv = new Float32Array(2 * own.size);
    for (let n = 0; n < own.size; n++) uv.set([places[3 * n] * 2, places[3 * n + 1] * 2], 2 * n);
    attributes.TEXCOORD_0 = accessor(uv, 5126, "VEC2", own.size);
  }
  const indices = accessor(index, 5125, "SCALAR", index.length);
  return { name, primitives: [{ attributes, indices, ...(material === undefined ? {} : { material }) }] };
}
