import { makeSymmetric } from "../../kit/field-character.js";
import { paint, zone } from "./paint.js";
import { BOX, field, size } from "./shape.js";

export const make = () => makeSymmetric({ name: "Puppy", field, box: BOX, step: 0.018, target: 4400, size, paint, zone, picture: 448 });

export { POINTS, POSES, SETTINGS } from "./project.js";
