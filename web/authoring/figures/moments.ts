// Moments of a figure side by side, lit and seen as on the page's stage.

import { Box3, type Group, NeutralToneMapping, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { drawnModel } from "../../src/app/drawn-model";
import type { ProjectDocument } from "../../src/document/types";
import type { Model } from "../../src/io/model";
import type { Workspace } from "../../src/sync/workspace";
import { AZIMUTH, FIELD_OF_VIEW } from "../../src/viewport/framing";
import { Lights } from "../../src/viewport/lights";
import { loadLook } from "../../src/viewport/look";
import { ModelFigure } from "../../src/viewport/model-figure";
import { VertexBody } from "../../src/viewport/vertex-body";

/** One figure at any frame. */
export interface Figure {
  group: Group;
  frames: number;
  /** N x 3 world at a frame; the same places each time. */
  places: (frame: number) => Float32Array;
  show: (places: Float32Array) => void;
}

export async function theModel(model: Model, document: ProjectDocument, workspace: Workspace): Promise<Figure> {
  const drawn = drawnModel(model, document.mesh, null);
  const vertices = await workspace.vertexFrames({});
  const figure = new ModelFigure(drawn, new VertexBody(drawn));
  figure.dress(await loadLook(drawn.document, drawn.instances));
  figure.show();
  return {
    group: figure.group,
    frames: vertices.length,
    places: (frame) => vertices[frame]!.positions,
    show: (places) => figure.setShape(places),
  };
}

/** One square per moment on a clear ground. */
export function drawMoments(group: Group, show: Figure["show"], moments: readonly Float32Array[], pixels: number): HTMLCanvasElement {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, stencil: true });
  renderer.toneMapping = NeutralToneMapping;
  renderer.setSize(4 * pixels, 4 * pixels, false); // finer, then averaged
  const lights = new Lights();
  lights.setDark(false);
  const scene = new Scene();
  scene.add(lights.group, group);
  const camera = aimedAt(moments);
  const canvas = document.createElement("canvas");
  canvas.width = moments.length * pixels;
  canvas.height = pixels;
  const context = canvas.getContext("2d")!;
  context.imageSmoothingQuality = "high";
  moments.forEach((moment, k) => {
    show(moment);
    renderer.render(scene, camera);
    context.drawImage(renderer.domElement, k * pixels, 0, pixels, pixels);
  });
  return canvas;
}

/** Without its travel over the ground. */
export function onTheSpot(places: Float32Array): Float32Array {
  const [x, z] = [0, 2].map((axis) => mean(places, axis));
  return places.map((value, i) => value - (i % 3 === 0 ? x! : i % 3 === 2 ? z! : 0));
}

function mean(places: Float32Array, axis: number): number {
  let sum = 0;
  for (let i = axis; i < places.length; i += 3) sum += places[i]!;
  return (3 * sum) / places.length;
}

/** From the stage's side, so that every moment fits. */
function aimedAt(moments: readonly Float32Array[]): PerspectiveCamera {
  const box = new Box3();
  for (const moment of moments) box.union(new Box3().setFromArray(moment));
  const size = box.getSize(new Vector3());
  const half = 0.5 * Math.max(size.y + 0.16, size.x + 0.12, 0.8 * size.z + 0.12);
  const centre = box.getCenter(new Vector3());
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 50);
  const distance = half / Math.tan((FIELD_OF_VIEW * Math.PI) / 360) + 0.4 * size.z;
  camera.position.setFromSphericalCoords(distance, Math.PI / 2 - 0.1, AZIMUTH + 0.4).add(centre);
  camera.lookAt(centre);
  return camera;
}
