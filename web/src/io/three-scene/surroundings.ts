// What three.js's loaders expect around them and neither a worker nor Node has. It is there while a loader parses, which is one
// call without a wait, and gone after it: nobody else sees it.

import { parseXml, type XmlDocument } from "./xml";

/** Stands for a Blob: its bytes can be had at once. */
class KeptBlob {
  readonly bytes: Uint8Array;

  constructor([part]: readonly (Uint8Array | ArrayBuffer | undefined)[]) {
    this.bytes = part instanceof ArrayBuffer ? new Uint8Array(part) : (part ?? new Uint8Array(0));
  }
}

/** Stands for an <img>: what it would have shown is kept instead. */
export class LoadedPicture {
  /** A path, or the data: or blob: address of bytes that the file holds. */
  private address = "";
  /** Of what the file itself holds; null for what lies beside it. */
  bytes: Uint8Array | null = null;
  private loaded: (() => void) | null = null;

  constructor(private readonly blobs: ReadonlyMap<string, KeptBlob>) {}

  addEventListener(type: string, listener: () => void): void {
    if (type === "load") this.loaded = listener;
  }

  removeEventListener(): void {}

  get src(): string {
    return this.address;
  }

  set src(address: string) {
    this.address = address;
    this.bytes = address.startsWith("data:") ? bytesOf(address) : (this.blobs.get(address)?.bytes ?? null);
    this.loaded?.call(this);
  }
}

/**
 * Runs a loader's `parse`. Its pictures come as LoadedPicture at once, its XML is read by ours, it fetches nothing, and what it
 * tells the console is not shown. `check` sees XML before the loader does; errors: its own, the loader's, and those of parseXml.
 */
export function inSurroundings<T>(name: string, parse: () => T, check: (document: XmlDocument) => void = () => {}): T {
  const blobs = new Map<string, KeptBlob>();
  const silent = (): void => {};
  const globals: Record<string, unknown> = {
    document: { createElementNS: () => new LoadedPicture(blobs) },
    window: { innerWidth: 1, innerHeight: 1 },
    DOMParser: class {
      parseFromString(text: string): XmlDocument {
        const document = parseXml(name, text);
        check(document);
        return document;
      }
    },
    fetch: () => new Promise(silent),
    Request: class {},
    Blob: KeptBlob,
    console: { ...console, log: silent, debug: silent, info: silent, warn: silent, error: silent },
  };
  const restore = [
    ...Object.entries(globals).map(([key, value]) => replaced(globalThis, key, value)),
    replaced(URL, "createObjectURL", (blob: KeptBlob) => {
      const address = `blob:${blobs.size}`;
      blobs.set(address, blob);
      return address;
    }),
    replaced(URL, "revokeObjectURL", silent),
  ];
  try {
    return parse();
  } finally {
    for (const back of restore) back();
  }
}

/** Sets a property; what is given back puts it as it was. */
function replaced(owner: object, key: string, value: unknown): () => void {
  const before = Object.getOwnPropertyDescriptor(owner, key);
  Object.defineProperty(owner, key, { value, configurable: true, writable: true, enumerable: before?.enumerable ?? true });
  return () => {
    if (before) Object.defineProperty(owner, key, before);
    else Reflect.deleteProperty(owner, key);
  };
}

/** Of a data: address in base 64; none where it is broken. */
function bytesOf(address: string): Uint8Array | null {
  try {
    return Uint8Array.from(atob(address.slice(address.indexOf(",") + 1)), (letter) => letter.charCodeAt(0));
  } catch {
    return null;
  }
}
