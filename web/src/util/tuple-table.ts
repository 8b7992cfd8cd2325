/** Numbers different tuples of integers in the order in which they come: an open-addressing hash table. */
export class TupleTable {
  size = 0;
  private readonly slots: Int32Array;
  private readonly tuples: Int32Array;

  constructor(
    capacity: number,
    private readonly width: number,
  ) {
    let slots = 16;
    while (slots < 2 * capacity) slots *= 2;
    this.slots = new Int32Array(slots).fill(-1);
    this.tuples = new Int32Array(capacity * width);
  }

  /** The tuple's number; `size` before the call if it is new. */
  put(tuple: ArrayLike<number>): number {
    const { slots, tuples, width } = this;
    let hash = 0;
    for (let k = 0; k < width; k++) hash = Math.imul(hash ^ tuple[k], 0x9e3779b1) ^ (hash >>> 15);
    for (let at = (hash ^ (hash >>> 16)) & (slots.length - 1); ; at = (at + 1) & (slots.length - 1)) {
      const n = slots[at];
      if (n < 0) {
        tuples.set(tuple, this.size * width);
        slots[at] = this.size;
        return this.size++;
      }
      let same = true;
      for (let k = 0; k < width && same; k++) same = tuples[n * width + k] === tuple[k];
      if (same) return n;
    }
  }
}
