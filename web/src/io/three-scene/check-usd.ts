// What three's loader of USD believes is checked where it comes by: between its parser and its composer, and as it reads a crate,
// the binary kind of USD.

import { USDComposer } from "three/examples/jsm/loaders/usd/USDComposer.js";
import { USDCParser } from "three/examples/jsm/loaders/usd/USDCParser.js";

import { ModelError } from "../named-file";

interface Layer {
  readonly specsByPath: Readonly<Record<string, { readonly fields?: Readonly<Record<string, unknown>> } | undefined>>;
}

interface CrateReader {
  readonly buffer: ArrayBuffer;
  readUint64(): number;
}

/** Runs the loader's `parse`. Errors (ModelError): counts that the file cannot hold; the loader's own. */
export function withCheckedUsd<T>(name: string, parse: () => T): T {
  const composer = USDComposer.prototype as unknown as { compose(layer: Layer, assets?: object, ...rest: unknown[]): unknown };
  const { compose } = composer;
  composer.compose = function (layer, assets = {}, ...rest) {
    checkLayer(name, layer);
    for (const other of Object.values(assets)) if (isLayer(other)) checkLayer(name, other);
    return compose.call(this, layer, assets, ...rest);
  };
  const crate = USDCParser.prototype as unknown as { reader: CrateReader; _getFieldsForSpec(spec: unknown): unknown };
  const { _getFieldsForSpec } = crate;
  const readers = new WeakMap<object, BoundedReader>();
  Object.defineProperty(crate, "reader", {
    configurable: true,
    get(this: object) {
      return readers.get(this)?.reader;
    },
    set(this: object, reader: CrateReader) {
      readers.set(this, new BoundedReader(name, reader));
    },
  });
  crate._getFieldsForSpec = function (spec) {
    readers.get(this)?.tablesEnd();
    return _getFieldsForSpec.call(this, spec);
  };
  try {
    return parse();
  } finally {
    composer.compose = compose;
    crate._getFieldsForSpec = _getFieldsForSpec;
    Reflect.deleteProperty(crate, "reader");
  }
}

/** Packed numbers may be more than the bytes that hold them, but not by this much. */
const PACKED = 16;
const LEAST = 1e6;
/** Behind the tables, what is above is no count but the kind and the place of a value. */
const KINDS = 2 ** 48;

class BoundedReader {
  private tables = true;

  constructor(
    name: string,
    readonly reader: CrateReader,
  ) {
    const most = PACKED * reader.buffer.byteLength + LEAST;
    const readUint64 = reader.readUint64.bind(reader);
    reader.readUint64 = () => {
      const value = readUint64();
      if (value > most && (this.tables || value < KINDS)) throw tooMuch(name);
      return value;
    };
  }

  tablesEnd(): void {
    this.tables = false;
  }
}

function isLayer(value: unknown): value is Layer {
  return typeof value === "object" && value !== null && "specsByPath" in value;
}

function checkLayer(name: string, { specsByPath }: Layer): void {
  for (const path of Object.keys(specsByPath)) {
    if (!path.endsWith(".faceVertexCounts")) continue;
    const counts = lengths(specsByPath[path]?.fields?.default);
    const indices = specsByPath[path.replace("Counts", "Indices")]?.fields?.default;
    const corners = counts.reduce((sum, n) => sum + Math.max(n, 0), 0);
    if (!(corners <= lengths(indices).length)) throw tooMuch(name);
  }
}

function lengths(value: unknown): number[] {
  return Array.isArray(value) || ArrayBuffer.isView(value) ? Array.from(value as unknown as ArrayLike<number>, Number) : [];
}

function tooMuch(name: string): ModelError {
  return new ModelError(`${name} promises more than it holds: it is broken. Save it once more, or as GLB.`);
}
