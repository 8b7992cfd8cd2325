import type { MemoryPort } from "../app/ports";

/** A page that may store nothing remembers nothing. */
function remembered(storage: () => Storage, key: string): { get: () => string | null; set: (value: string | null) => void } {
  return {
    get: () => {
      try {
        return storage().getItem(key);
      } catch {
        return null;
      }
    },
    set: (value) => {
      try {
        if (value === null) storage().removeItem(key);
        else storage().setItem(key, value);
      } catch {
        // Then it is not remembered.
      }
    },
  };
}

const project = remembered(() => sessionStorage, "rigless project");
const opening = remembered(() => localStorage, "rigless opening");
const kept = remembered(() => localStorage, "rigless kept");

export const memory: MemoryPort = {
  get project() {
    return project.get();
  },
  set project(id) {
    project.set(id);
  },
  get opening() {
    return opening.get();
  },
  set opening(id) {
    opening.set(id);
  },
  get kept() {
    return kept.get() !== null;
  },
  set kept(is) {
    kept.set(is ? "yes" : null);
  },
};
