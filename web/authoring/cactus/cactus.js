// The cactus's file.
import { encodeGlb } from "../kit/glb.js";
import { reportMesh } from "../kit/mesh-report.js";
import { encodePng } from "../kit/png.js";
import { paintCactus } from "./paint.js";
import { buildCactus } from "./shape.js";

/** Gives { glb, png, report, vertices }. */
export function make() {
  const cactus = buildCactus();
  const triangles = cactus.faces.map((f) => f.v);
  const skin = paintCactus(cactus);
  const png = encodePng(skin.size, skin.size, skin.rgb);
  const glb = encodeGlb({ name: "Cactus", vertices: cactus.vertices, triangles, uv: skin.uv, png, roughness: 0.75 });
  return { glb, png, report: reportMesh(cactus.vertices, triangles), vertices: cactus.vertices };
}

export { POINTS, POSES, SETTINGS } from "./project.js";
