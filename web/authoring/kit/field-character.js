// From a field and paint to a character's file.
import { reportMesh } from "./mesh-report.js";
import { encodePackedGlb } from "./packed-glb.js";
import { encodePng } from "./png.js";
import { polygonise } from "./polygonise.js";
import { mirrorMesh, remesh } from "./remesh.js";
import { gradient } from "./sdf.js";
import { makeSkin } from "./skin.js";
import { normalize } from "./vec3.js";

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

/** How open the surface is at a place, 0 to 1: how far the field grows along the normal, against how far it could. */
function opennessOf(field, p, n) {
  const reach = [0.012, 0.03, 0.07];
  return reach.reduce((sum, r) => sum + Math.min(1, Math.max(0, field(...p.map((v, k) => v + r * n[k])) / r)), 0) / reach.length;
}

const SHADES = 32;

/**
 * A heavy mesh of one colour and its shades, as a scanner gives it: shade(p, normal, openness) is each vertex's place on a ramp from 0 to 1, and
 * ramp(t) the colour there. One number packs better than three.
 */
export async function makeScan({ name, field, box, step, target, size, shade, ramp, roughness = 0.9 }) {
  const mesh = remesh(polygonise(field, box, step), field, { target, size, rounds: 9 });
  const u = mesh.vertices.map((p) => {
    const n = normalize(gradient(field, p, 2e-3));
    return (0.5 + Math.round(shade(p, n, opennessOf(field, p, n)) * (SHADES - 1))) / SHADES;
  });
  const rgb = Uint8Array.from({ length: SHADES * 3 }, (_, i) => Math.round(ramp(Math.floor(i / 3) / (SHADES - 1))[i % 3]));
  const png = encodePng(SHADES, 1, rgb);
  const glb = await encodePackedGlb({
    name,
    ...mesh,
    uv: mesh.triangles.map((t) => t.map((v) => [u[v], 0.5])),
    png,
    roughness,
    flat: true,
  });
  return { glb, png, ...mesh, report: reportMesh(mesh.vertices, mesh.triangles) };
}
