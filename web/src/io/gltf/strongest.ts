/** An attribute of our own: which joint moves a vertex most, without its weights. It is not written. */
export const STRONGEST = "_JOINT";
