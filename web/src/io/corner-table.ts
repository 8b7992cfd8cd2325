/** Numbers different triples of whole numbers in the order in which they come: an open-addressing hash table that grows. */
export class CornerTable {
  size = 0;
  private slots = new Int32Array(1024).fill(-1);
  /** size x 3. */
  private triples = new Int32Array(3 * 512);

  /** The triple's number; `size` before the call if it is new. */
  put(a: number, b: number, c: number): number {
    if (2 * this.size >= this.slots.length) this.grow();
    const { slots, triples } = this;
    for (let at = hash(a, b, c) & (slots.length - 1); ; at = (at + 1) & (slots.length - 1)) {
      const n = slots[at];
      if (n < 0) {
        triples[3 * this.size] = a;
        triples[3 * this.size + 1] = b;
        triples[3 * this.size + 2] = c;
        slots[at] = this.size;
        return this.size++;
      }
      if (triples[3 * n] === a && triples[3 * n + 1] === b && triples[3 * n + 2] === c) return n;
    }
  }

  /** One of the three of every triple. */
  column(which: 0 | 1 | 2): Int32Array {
    return Int32Array.from({ length: this.size }, (_, n) => this.triples[3 * n + which]);
  }

  private grow(): void {
    const { triples } = this;
    this.triples = new Int32Array(2 * triples.length);
    this.triples.set(triples);
    this.slots = new Int32Array(2 * this.slots.length).fill(-1);
    for (let n = 0; n < this.size; n++) {
      let at = hash(triples[3 * n], triples[3 * n + 1], triples[3 * n + 2]) & (this.slots.length - 1);
      while (this.slots[at] >= 0) at = (at + 1) & (this.slots.length - 1);
      this.slots[at] = n;
    }
  }
}

function hash(a: number, b: number, c: number): number {
  let h = Math.imul(a, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15) ^ b, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13) ^ c, 0xc2b2ae35);
  return h ^ (h >>> 16);
}
