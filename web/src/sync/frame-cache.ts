import type { ShapedFrame } from "../engine/types";

/** What kept frames hold at most, together. */
const MOST_BYTES = 100e6;

/**
 * Deformed frames of the present dance: all of them, or those around the playhead where the dance is long. After a new solve the
 * old ones stay until new ones replace them.
 */
export class FrameCache {
  private frames: (ShapedFrame | undefined)[] = [];
  private fresh = new Uint8Array(0);
  private missing = 0;
  /** How many are kept. */
  private most = Infinity;
  private playhead = 0;

  constructor(private readonly mostBytes = MOST_BYTES) {}

  get length(): number {
    return this.frames.length;
  }

  /** Frames still to be made, of those that are kept here. */
  get staleCount(): number {
    return this.missing;
  }

  /** Forgets everything, e.g. because the mesh changed. */
  clear(): void {
    this.resize(0);
    this.most = Infinity;
  }

  /** Every frame is to be made again; those of the same length of dance stay to be shown. */
  expire(length: number): void {
    if (length !== this.frames.length) this.resize(length);
    this.fresh.fill(0);
    this.keepAround();
  }

  put(index: number, frame: ShapedFrame): void {
    if (this.most === Infinity) {
      this.most = Math.max(1, Math.floor(this.mostBytes / frame.shape.byteLength));
      this.keepAround();
    }
    if (index >= this.frames.length || !this.keeps(index)) return;
    this.frames[index] = frame;
    if (this.fresh[index] === 0) this.missing--;
    this.fresh[index] = 1;
  }

  at(index: number): ShapedFrame | undefined {
    return this.frames[index];
  }

  isFresh(index: number): boolean {
    return this.fresh[index] === 1;
  }

  /** The frame itself, or the nearest one that there is. */
  nearest(index: number): ShapedFrame | undefined {
    for (let d = 0; d < this.frames.length; d++) {
      const found = this.frames[index - d] ?? this.frames[index + d];
      if (found) return found;
    }
    return undefined;
  }

  /** The playhead is here now; answers whether it is time to make more frames. */
  follow(index: number): boolean {
    this.playhead = index;
    if (this.most < this.length) this.keepAround();
    return this.length > 0 && (!this.isFresh(index) || 8 * this.missing > Math.min(this.most, this.length));
  }

  /** Frames still to be made, in the order in which a playhead at `from` meets them. */
  todo(from: number): number[] {
    const n = this.frames.length;
    const order: number[] = [];
    for (let k = 0; k < n; k++) {
      const index = (from + k) % n;
      if (this.fresh[index] === 0 && this.keeps(index)) order.push(index);
    }
    return order;
  }

  /** Three quarters of what is kept lie before the playhead, around the end. */
  private keeps(index: number): boolean {
    const n = this.frames.length;
    return this.most >= n || (index - this.playhead + (this.most >> 2) + n) % n < this.most;
  }

  private keepAround(): void {
    this.missing = 0;
    for (let index = 0; index < this.frames.length; index++) {
      if (!this.keeps(index)) {
        this.frames[index] = undefined;
        this.fresh[index] = 0;
      } else if (this.fresh[index] === 0) this.missing++;
    }
  }

  private resize(length: number): void {
    this.frames = new Array<ShapedFrame | undefined>(length).fill(undefined);
    this.fresh = new Uint8Array(length);
    this.missing = length;
  }
}
