// BMP, which Node cannot show and glTF does not hold.

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Top row first. */
  readonly rgba: Uint8Array;
}

/** Null for what is packed, older than Windows 3 or cut short. */
export function readBmp(bytes: Uint8Array): Pixels | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 54 || view.getUint32(14, true) < 40) return null;
  const [start, header] = [view.getUint32(10, true), view.getUint32(14, true)];
  const [width, signed] = [view.getInt32(18, true), view.getInt32(22, true)];
  const height = Math.abs(signed);
  const [bits, packing] = [view.getUint16(28, true), view.getUint32(30, true)];
  const stride = 4 * Math.ceil((width * bits) / 32);
  const plain = packing === 0 ? [1, 4, 8, 24, 32].includes(bits) : packing === 3 && bits === 32;
  if (!plain || width < 1 || height < 1 || start + stride * height > bytes.length) return null;
  const rgba = new Uint8Array(4 * width * height);
  const masks = packing === 3 ? [0, 4, 8].map((at) => Math.clz32(view.getUint32(54 + at, true)) >> 3) : [1, 2, 3];
  const palette = 14 + header;
  let seen = 0; // many leave alpha at zero and mean nothing by it
  for (let y = 0; y < height; y++) {
    const row = start + stride * (signed < 0 ? y : height - 1 - y);
    for (let x = 0; x < width; x++) {
      const to = 4 * (width * y + x);
      if (bits === 32) {
        for (let k = 0; k < 3; k++) rgba[to + k] = bytes[row + 4 * x + 3 - masks[k]];
        seen |= rgba[to + 3] = bytes[row + 4 * x + 3];
        continue;
      }
      const at =
        bits === 24 ? row + 3 * x : palette + 4 * ((bytes[row + ((bits * x) >> 3)] >> (8 - bits - ((bits * x) & 7))) & ((1 << bits) - 1));
      for (let k = 0; k < 3; k++) rgba[to + k] = bytes[at + 2 - k];
      rgba[to + 3] = 255;
    }
  }
  if (bits === 32 && seen === 0) for (let i = 3; i < rgba.length; i += 4) rgba[i] = 255;
  return { width, height, rgba };
}
