// KTX2 pictures, decoded by a worker that is started with the first of them.

const worker = new Worker(new URL("./ktx2-worker.ts", import.meta.url), { type: "module" });
const waiting = new Map<number, (image: ImageData | null) => void>();
let asked = 0;

worker.addEventListener("message", ({ data: { id, image } }: MessageEvent<{ id: number; image: ImageData | null }>) => {
  waiting.get(id)?.(image);
  waiting.delete(id);
});
worker.addEventListener("error", () => {
  for (const answer of waiting.values()) answer(null);
  waiting.clear();
});

/** Errors: what the transcoder cannot make sense of. */
export async function decodeKtx2(bytes: Uint8Array): Promise<ImageData> {
  const image = await new Promise<ImageData | null>((resolve) => {
    waiting.set(++asked, resolve);
    worker.postMessage({ id: asked, bytes });
  });
  if (!image) throw new Error("This KTX2 picture cannot be decoded.");
  return image;
}
