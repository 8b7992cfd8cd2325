import { makeSymmetric } from "../../kit/field-character.js";
import { paint, zone } from "./paint.js";
import { BOX, field, size } from "./shape.js";

export const make = () => makeSymmetric({ name: "Lamp", field, box: BOX, step: 0.014, target: 3200, size, paint, zone, picture: 320 });

export { POINTS, POSES, SETTINGS } from "./project.js";
