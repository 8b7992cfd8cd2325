// Parts of the model that keep their shape: saying, sizing and forgetting them.

import type { Command } from "./store";
import type { StiffPart } from "./types";

/** A new part, or another size for the one that has its id. */
export const setStiff =
  (part: StiffPart): Command =>
  (document) => {
    const { stiff = [] } = document;
    const known = stiff.some(({ id }) => id === part.id);
    return { ...document, stiff: known ? stiff.map((one) => (one.id === part.id ? part : one)) : [...stiff, part] };
  };

export const removeStiff =
  (id: string): Command =>
  (document) => {
    const { stiff = [], ...others } = document;
    const left = stiff.filter((part) => part.id !== id);
    if (left.length === stiff.length) return document;
    return left.length > 0 ? { ...others, stiff: left } : others;
  };
