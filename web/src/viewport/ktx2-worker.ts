// Decodes KTX2 by the transcoder of Basis Universal. It makes functions out of text, which the page's policy forbids and a worker
// of its own file may do.

import wasm from "three/examples/jsm/libs/basis/basis_transcoder.wasm?url";
import script from "three/examples/jsm/libs/basis/basis_transcoder.js?raw";

interface Ktx2File {
  isValid(): boolean;
  getWidth(): number;
  getHeight(): number;
  startTranscoding(): number;
  getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number;
  transcodeImage(out: Uint8Array, level: number, layer: number, face: number, format: number, ...flags: number[]): number;
  close(): void;
  delete(): void;
}

interface Basis {
  initializeBasis(): void;
  KTX2File: new (bytes: Uint8Array) => Ktx2File;
}

/** Its number for plain RGBA. */
const RGBA32 = 13;

const basis = (async (): Promise<Basis> => {
  const wasmBinary = await (await fetch(wasm)).arrayBuffer();
  const make = new Function(`${script}; return BASIS;`)() as (options: object) => Promise<Basis>;
  const module = await make({ wasmBinary });
  module.initializeBasis();
  return module;
})();

addEventListener("message", ({ data: { id, bytes } }: MessageEvent<{ id: number; bytes: Uint8Array }>) => {
  void decode(bytes)
    .catch(() => null)
    .then((image) => postMessage({ id, image }, { transfer: image ? [image.data.buffer] : [] }));
});

async function decode(bytes: Uint8Array): Promise<ImageData | null> {
  const { KTX2File } = await basis;
  const file = new KTX2File(bytes);
  try {
    if (!file.isValid() || !file.startTranscoding()) return null;
    const [width, height] = [file.getWidth(), file.getHeight()];
    const rgba = new Uint8Array(file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32));
    if (!file.transcodeImage(rgba, 0, 0, 0, RGBA32, 0, -1, -1)) return null;
    return new ImageData(new Uint8ClampedArray(rgba.buffer), width, height);
  } finally {
    file.close();
    file.delete();
  }
}
