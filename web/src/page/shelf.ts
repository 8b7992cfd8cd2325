// What the browser keeps between visits: small projects, and large files once each, by their content.

import { type DBSchema, type IDBPDatabase, openDB } from "idb";
import type { KeptProject, KeptWork, ShelfPort } from "../app/ports";
import type { MotionInput } from "../engine/types";

/** A project whose files lie beside it, each by its content's key. */
type Stored = Omit<KeptWork, "models" | "motions" | "song"> & {
  readonly song?: { name: string; muted: boolean; content: string } | null;
  readonly models: readonly (readonly { name: string; content: string }[])[];
  readonly motions: readonly { files: readonly string[]; content: string }[];
};

interface Shelves extends DBSchema {
  /** What a list shows, so that it need not read the projects. */
  cards: { key: string; value: KeptProject };
  projects: { key: string; value: Stored };
  contents: { key: string; value: Uint8Array | MotionInput };
}

export async function openShelf(): Promise<ShelfPort> {
  const database = await openDB<Shelves>("rigless", 1, {
    upgrade(fresh) {
      fresh.createObjectStore("cards", { keyPath: "id" });
      fresh.createObjectStore("projects", { keyPath: "id" });
      fresh.createObjectStore("contents");
    },
    blocking: () => database.close(),
  });
  return new Shelf(database);
}

class Shelf implements ShelfPort {
  private readonly keys = new WeakMap<object, Promise<string>>();
  private letGo: (() => void) | null = null;
  private asked = false;

  constructor(private readonly database: IDBPDatabase<Shelves>) {}

  async list(): Promise<readonly KeptProject[]> {
    const all = await this.database.getAll("cards");
    return all.sort((a, b) => b.changed - a.changed);
  }

  async load(id: string): Promise<KeptWork | null> {
    const stored = await this.database.get("projects", id);
    if (!stored) return null;
    const content = async <T extends Uint8Array | MotionInput>(key: string): Promise<T> => {
      const value = (await this.database.get("contents", key)) as T | undefined;
      if (value === undefined) throw new Error(`A file of ${stored.name} is gone.`);
      this.keys.set(value, Promise.resolve(key));
      return value;
    };
    const model = (files: Stored["models"][number]) =>
      Promise.all(files.map(async ({ name, content: key }) => ({ name, bytes: await content<Uint8Array>(key) })));
    const motion = async ({ files, content: key }: Stored["motions"][number]) => ({ files, input: await content<MotionInput>(key) });
    const { song: sung, models, motions } = stored;
    const song = sung ? { name: sung.name, muted: sung.muted, bytes: await content<Uint8Array>(sung.content) } : null;
    return { ...stored, models: await Promise.all(models.map(model)), motions: await Promise.all(motions.map(motion)), song };
  }

  async put(work: KeptWork): Promise<void> {
    const values = new Map<string, Uint8Array | MotionInput>();
    const keyOf = async (value: Uint8Array | MotionInput): Promise<string> => {
      const key = await this.keyOf(value);
      values.set(key, value);
      return key;
    };
    const model = (files: KeptWork["models"][number]) =>
      Promise.all(files.map(async ({ name, bytes }) => ({ name, content: await keyOf(bytes) })));
    const { song } = work;
    const stored: Stored = {
      ...work,
      song: song ? { name: song.name, muted: song.muted, content: await keyOf(song.bytes) } : null,
      models: await Promise.all(work.models.map(model)),
      motions: await Promise.all(work.motions.map(async ({ files, input }) => ({ files, content: await keyOf(input) }))),
    };
    const { database } = this;
    const transaction = database.transaction(["cards", "projects", "contents"], "readwrite");
    const contents = transaction.objectStore("contents");
    const { id, name, changed, picture } = work;
    const write = async (): Promise<void> => {
      const known = new Set(await contents.getAllKeys());
      for (const [key, value] of values) if (!known.has(key)) await contents.put(value, key);
      await transaction.objectStore("projects").put(stored);
      await transaction.objectStore("cards").put({ id, name, changed, picture });
    };
    await Promise.all([write(), transaction.done]);
    if (this.asked) return;
    this.asked = true;
    void navigator.storage?.persist?.();
  }

  async remove(id: string): Promise<void> {
    const transaction = this.database.transaction(["cards", "projects", "contents"], "readwrite");
    const projects = transaction.objectStore("projects");
    const contents = transaction.objectStore("contents");
    const write = async (): Promise<void> => {
      await transaction.objectStore("cards").delete(id);
      await projects.delete(id);
      const needed = new Set((await projects.getAll()).flatMap(contentsOf));
      for (const key of await contents.getAllKeys()) if (!needed.has(key)) await contents.delete(key);
    };
    await Promise.all([write(), transaction.done]);
  }

  async begin(): Promise<string> {
    const id = crypto.randomUUID();
    await this.claim(id);
    return id;
  }

  async claim(id: string): Promise<boolean> {
    this.release();
    // A page that is reloaded may not have let go yet.
    return (await this.hold(id)) || (await new Promise((resolve) => setTimeout(resolve, 200)).then(() => this.hold(id)));
  }

  release(): void {
    this.letGo?.();
    this.letGo = null;
  }

  private hold(id: string): Promise<boolean> {
    if (!("locks" in navigator)) return Promise.resolve(true);
    return new Promise((resolve) => {
      void navigator.locks.request(`rigless ${id}`, { ifAvailable: true }, (lock) => {
        resolve(lock !== null);
        if (lock) return new Promise<void>((done) => (this.letGo = done));
        return undefined;
      });
    });
  }

  private keyOf(value: Uint8Array | MotionInput): Promise<string> {
    let key = this.keys.get(value);
    if (!key) {
      key = digest(value);
      this.keys.set(value, key);
    }
    return key;
  }
}

function contentsOf({ models, motions, song }: Stored): string[] {
  return [...models.flat(), ...motions, ...(song ? [song] : [])].map(({ content }) => content);
}

async function digest(value: Uint8Array | MotionInput): Promise<string> {
  const bytes = value instanceof Uint8Array ? value : new TextEncoder().encode(JSON.stringify(value));
  const hash = await crypto.subtle.digest("SHA-256", bytes as Uint8Array<ArrayBuffer>);
  return Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
