// A model in hand with its limbs told apart. What knows the names of joints is loaded with the first model that has some.

import { limbParts } from "../sync/limb-parts";
import { jointsOf } from "./gltf/joints";
import { movedBy } from "./gltf/moved-by";
import type { Model } from "./model";

export function parted(model: Model): Model {
  return { ...model, parts: limbParts(model.positions, model.joints, movedBy(model.document, model, jointsOf(model.document, model))) };
}
