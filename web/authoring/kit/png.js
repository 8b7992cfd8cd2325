// A PNG writer for drawings of few colours with a palette of at most 256.
import { deflateSync } from "node:zlib";

const crcTable = Int32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});
function crc32(bytes) {
  let c = -1;
  for (const b of bytes) c = (c >>> 8) ^ crcTable[(c ^ b) & 255];
  return (c ^ -1) >>> 0;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

/** Median cut: splits the box with the largest spread until there are `limit`; gives the colours and a lookup. */
function makePalette(counts, limit) {
  const entries = [...counts].map(([key, n]) => ({ key, rgb: [key >> 16, (key >> 8) & 255, key & 255], n }));
  const boxes = [entries];
  const spread = (box) => {
    const ranges = [0, 1, 2].map((k) => Math.max(...box.map((e) => e.rgb[k])) - Math.min(...box.map((e) => e.rgb[k])));
    const channel = ranges.indexOf(Math.max(...ranges));
    return { channel, size: ranges[channel] * Math.cbrt(box.reduce((s, e) => s + e.n, 0)) };
  };
  while (boxes.length < Math.min(limit, entries.length)) {
    const sized = boxes.map((box) => (box.length > 1 ? spread(box).size : -1));
    const pick = sized.indexOf(Math.max(...sized));
    const box = boxes[pick];
    const { channel } = spread(box);
    box.sort((a, b) => a.rgb[channel] - b.rgb[channel] || a.key - b.key);
    const low = box[0].rgb[channel];
    const middle = (low + box.at(-1).rgb[channel]) / 2;
    const cut = Math.max(
      1,
      box.findIndex((e) => e.rgb[channel] > middle),
    );
    boxes.splice(pick, 1, box.slice(0, cut), box.slice(cut));
  }
  boxes.sort((a, b) => b.reduce((s, e) => s + e.n, 0) - a.reduce((s, e) => s + e.n, 0));
  const lookup = new Map();
  const colours = boxes.map((box, i) => {
    const total = box.reduce((s, e) => s + e.n, 0);
    for (const e of box) lookup.set(e.key, i);
    return [0, 1, 2].map((k) => Math.round(box.reduce((s, e) => s + e.rgb[k] * e.n, 0) / total));
  });
  return { colours, lookup };
}

/** rgb: width x height x 3 bytes. */
export function encodePng(width, height, rgb) {
  const counts = new Map();
  const key = (i) => (rgb[3 * i] << 16) | (rgb[3 * i + 1] << 8) | rgb[3 * i + 2];
  for (let i = 0; i < width * height; i++) counts.set(key(i), (counts.get(key(i)) ?? 0) + 1);
  const { colours, lookup } = makePalette(counts, 256);
  const rows = Buffer.alloc(height * (width + 1)); // filter 0: indices do not add up
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) rows[y * (width + 1) + 1 + x] = lookup.get(key(y * width + x));
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 3, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk("IHDR", header),
    chunk("PLTE", Buffer.from(colours.flat())),
    chunk("IDAT", deflateSync(rows, { level: 9, memLevel: 9 })),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}
