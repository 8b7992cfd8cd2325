// A model in hand: the file's own document, and the views on it that are drawn and solved.

import type { GltfDocument } from "../gltf/document";
import type { NamedJoint } from "../sync/named-body";
import { jointsOf } from "./gltf/joints";
import { viewOf, type View } from "./gltf/view";

export interface Model extends View {
  /** File name without folders. */
  readonly name: string;
  readonly document: GltfDocument;
  /** What the file calls its joints, or its parts; none where it names nothing. */
  readonly joints: readonly NamedJoint[];
  /** V: which of its limbs a vertex is of, as in limbParts; null where its joints do not say, and before `parted`. */
  readonly parts: Int32Array | null;
  /** What was worked around, in plain words. */
  readonly notes: readonly string[];
}

/** Errors (ModelError): as viewOf. */
export function modelOf(name: string, document: GltfDocument, notes: string[]): Model {
  const view = viewOf(name, document, notes);
  return { name, document, ...view, joints: jointsOf(document, view).joints, parts: null, notes };
}
