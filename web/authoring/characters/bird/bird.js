import { makeSymmetric } from "../../kit/field-character.js";
import { paint, zone } from "./paint.js";
import { BOX, field, size } from "./shape.js";

export const make = () => makeSymmetric({ name: "Bird", field, box: BOX, step: 0.016, target: 3400, size, paint, zone, picture: 448 });

export { POINTS, POSES, SETTINGS } from "./project.js";
