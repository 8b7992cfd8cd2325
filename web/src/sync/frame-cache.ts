import type { Frame } from "../engine/types";

/** Deformed frames of the present dance. After a new solve the old ones stay until new ones replace them. */
export class FrameCache {
  private frames: (Frame | undefined)[] = [];
  private fresh = new Uint8Array(0);
  private missing = 0;

  get length(): number {
    return this.frames.length;
  }

  get staleCount(): number {
    return this.missing;
  }

  /** Forgets everything, e.g. because the mesh changed. */
  clear(): void {
    this.resize(0);
  }

  /** Every frame is to be made again; those of the same length of dance stay to be shown. */
  expire(length: number): void {
    if (length !== this.frames.length) this.resize(length);
    this.fresh.fill(0);
    this.missing = length;
  }

  put(index: number, frame: Frame): void {
    if (index >= this.frames.length) return;
    this.frames[index] = frame;
    if (this.fresh[index] === 0) this.missing--;
    this.fresh[index] = 1;
  }

  at(index: number): Frame | undefined {
    return this.frames[index];
  }

  isFresh(index: number): boolean {
    return this.fresh[index] === 1;
  }

  /** The frame itself, or the nearest one that there is. */
  nearest(index: number): Frame | undefined {
    for (let d = 0; d < this.frames.length; d++) {
      const found = this.frames[index - d] ?? this.frames[index + d];
      if (found) return found;
    }
    return undefined;
  }

  /** Frames still to be made, in the order in which a playhead at `from` meets them. */
  todo(from: number): number[] {
    const n = this.frames.length;
    const order: number[] = [];
    for (let k = 0; k < n; k++) {
      const index = (from + k) % n;
      if (this.fresh[index] === 0) order.push(index);
    }
    return order;
  }

  private resize(length: number): void {
    this.frames = new Array<Frame | undefined>(length).fill(undefined);
    this.fresh = new Uint8Array(length);
    this.missing = length;
  }
}
