// From a field and paint to a character's file.
import { reportMesh } from "./mesh-report.js";
import { encodePackedGlb } from "./packed-glb.js";
import { polygonise } from "./polygonise.js";
import { mirrorMesh, remesh } from "./remesh.js";
import { makeSkin } from "./skin.js";

/**
 * A symmetric character: field, box and step as for polygonise; target vertices and size as for remesh; paint and zone as for makeSkin, with
 * `picture` texels a side. Both sides share the picture. Gives { glb, vertices, triangles, png, report }.
 */
export async function makeSymmetric({ name, field, box, step, target, size, paint, zone, picture, roughness = 0.75 }) {
  const half = remesh(polygonise(field, box, step, true), field, { target: target / 2, size });
  const { uv, png } = makeSkin(half, paint, { size: picture, zone });
  const glb = await encodePackedGlb({ name, ...half, uv, png, half: true, roughness });
  const whole = mirrorMesh(half);
  return { glb, png, ...whole, report: reportMesh(whole.vertices, whole.triangles) };
}
