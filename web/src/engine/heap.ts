// The memory of a module. The only file that makes views of it: each is made, used and dropped at once, because it dies when
// the heap grows.

import type { Integers, Pointer, Row } from "./abi";
import { outOfMemory } from "./messages";

type Lendable = Float32Array | Float64Array | Integers | Uint8Array | null;
/** The pointer to each array, 0 to one that is not there. */
type Lent<Arrays> = { [K in keyof Arrays]: Pointer<NonNullable<Arrays[K]>> };

interface Memory {
  memory: WebAssembly.Memory;
  alloc(bytes: number): Pointer;
  release(at: Pointer): void;
}

export class Heap {
  constructor(readonly module: Memory) {}

  /** Copies arrays in for the time of one call. */
  lend<Arrays extends Lendable[], T>(arrays: [...Arrays], use: (pointers: Lent<Arrays>) => T): T {
    const pointers: Pointer[] = [];
    try {
      for (const array of arrays) {
        if (!array) {
          pointers.push(0);
          continue;
        }
        const at = this.module.alloc(Math.max(array.byteLength, 1));
        if (at === 0) throw outOfMemory();
        pointers.push(at);
        const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
        new Uint8Array(this.module.memory.buffer, at, array.byteLength).set(bytes);
      }
      return use(pointers as Lent<Arrays>);
    } finally {
      for (const at of pointers) this.module.release(at);
    }
  }

  /** The same for structs, each as the doubles that `write` makes of it. */
  lendAll<T, R>(write: (one: T) => number[], all: readonly T[], use: (at: Pointer<T>) => R): R {
    return this.lend([Float64Array.from(all.flatMap(write))], ([at]) => use(at as Pointer as Pointer<T>));
  }

  /** What the core answers in a struct. */
  read<T>(row: Row<T>, at: Pointer<T>): T {
    return row.read(new Float64Array(this.module.memory.buffer, at, row.doubles));
  }

  floats(at: Pointer<Float32Array>, length: number): Float32Array {
    return new Float32Array(this.module.memory.buffer, at, length).slice();
  }

  /** Of doubles. */
  narrowed(at: Pointer<Float64Array>, length: number): Float32Array {
    return new Float32Array(new Float64Array(this.module.memory.buffer, at, length));
  }

  integers(at: Pointer<Integers>, length: number): Int32Array {
    return new Int32Array(this.module.memory.buffer, at, length).slice();
  }

  bytes(at: Pointer<Uint8Array>, length: number): Uint8Array {
    return new Uint8Array(this.module.memory.buffer, at, length).slice();
  }

  text(at: Pointer<Uint8Array>, bytes: number): string {
    return new TextDecoder().decode(new Uint8Array(this.module.memory.buffer, at, bytes));
  }
}
