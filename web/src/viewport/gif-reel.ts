// A film as a GIF, for browsers that encode no video.

import { applyPalette, GIFEncoder, quantize } from "gifenc";
import type { Reel } from "./reels";

export class GifReel implements Reel {
  private readonly gif = GIFEncoder();
  private readonly context: CanvasRenderingContext2D;
  private readonly samples: Uint8ClampedArray[] = [];
  private palette: number[][] | null = null;
  private frames = 0;

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly fps: number,
  ) {
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width, height });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("This browser reads no pictures.");
    this.context = context;
  }

  /** Of what the palette is made: one for all frames, so that colours do not flicker. */
  sample(canvas: HTMLCanvasElement): void {
    this.samples.push(this.pixels(canvas));
  }

  async add(canvas: HTMLCanvasElement): Promise<void> {
    const { gif, width, height, fps } = this;
    const pixels = this.pixels(canvas);
    const first = this.palette === null;
    this.palette ??= this.mixed();
    const time = (frame: number): number => 10 * Math.round((100 * frame) / fps); // a GIF counts hundredths of a second
    const delay = time(this.frames + 1) - time(this.frames++);
    gif.writeFrame(applyPalette(pixels, this.palette), width, height, { ...(first && { palette: this.palette }), delay });
  }

  async finish(): Promise<Uint8Array<ArrayBuffer>> {
    this.gif.finish();
    return new Uint8Array(this.gif.bytes());
  }

  async cancel(): Promise<void> {}

  private mixed(): number[][] {
    const all = new Uint8ClampedArray(this.samples.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const pixels of this.samples.splice(0)) {
      all.set(pixels, at);
      at += pixels.length;
    }
    return quantize(all, 256);
  }

  private pixels(canvas: HTMLCanvasElement): Uint8ClampedArray {
    const { context, width, height } = this;
    context.drawImage(canvas, 0, 0);
    return context.getImageData(0, 0, width, height).data;
  }
}
