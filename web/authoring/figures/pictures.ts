// Draws one moment after another of a character or of the mannequin, as the page would, into one strip.

import { Box3, Group, NeutralToneMapping, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { parseProject } from "../../src/document/project";
import type { ProjectDocument } from "../../src/document/types";
import { createBrowserEngine } from "../../src/engine/browser";
import { readModel } from "../../src/io/read-model";
import type { Model } from "../../src/io/model";
import { toStage } from "../../src/document/stage";
import { stageFor } from "../../src/sync/prepare";
import { Workspace } from "../../src/sync/workspace";
import { AZIMUTH, FIELD_OF_VIEW } from "../../src/viewport/framing";
import { Lights } from "../../src/viewport/lights";
import { Mannequin } from "../../src/viewport/mannequin";
import { ModelFigure } from "../../src/viewport/model-figure";

const FRAMES = 8;
const PIXELS = 104;
/** A strip is at most so large. */
const BYTES = 8000;

interface Performance {
  /** Folder that the project lies in. */
  folder: string;
  project: string;
  motion: string;
  who: "model" | "human";
}

declare global {
  interface Window {
    /** A strip of FRAMES squares on a clear ground, as a data URL. */
    draw: (performance: Performance) => Promise<string>;
  }
}

/** One figure at any frame. */
interface Figure {
  group: Group;
  frames: number;
  /** N x 3 world at a frame; the same places each time. */
  places: (frame: number) => Float32Array;
  show: (places: Float32Array) => void;
}

window.draw = async ({ folder, project, motion, who }) => {
  const { document: parsed } = parseProject(await (await fetch(folder + project)).text(), project);
  const bytes = new Uint8Array(await (await fetch(folder + parsed.mesh.file)).arrayBuffer());
  const model = await readModel([{ name: parsed.mesh.file, bytes }]);
  let present: ProjectDocument = parsed;
  const workspace = new Workspace(() => present, createBrowserEngine);
  const file = workspace.library.addModel(parsed.mesh.file, model);
  const files = workspace.library.addMotion(["m.bvh"], { format: "bvh", name: "m.bvh", text: await (await fetch(motion)).text() });
  present = { ...parsed, mesh: { ...parsed.mesh, file }, motion: { files } };
  await workspace.sync();
  const figure = who === "model" ? await theModel(model, present, workspace) : theHuman(workspace);
  const strip = drawStrip(figure);
  workspace.close();
  return strip;
};

async function theModel(model: Model, document: ProjectDocument, workspace: Workspace): Promise<Figure> {
  const { drawn } = model;
  const texture = drawn.texture && await createImageBitmap(new Blob([drawn.texture.bytes.slice()], { type: drawn.texture.mime }), { premultiplyAlpha: "none", colorSpaceConversion: "none" });
  const figure = new ModelFigure({ ...drawn, positions: toStage(stageFor(model, document.mesh), drawn.positions), faces: model.faces, texture });
  return {
    group: figure.group,
    frames: workspace.cache.length,
    places: (frame) => workspace.cache.at(frame)!.positions,
    show: (places) => figure.setVertices(places),
  };
}

function theHuman({ motion }: Workspace): Figure {
  const { joints, positions, frames } = motion!;
  const figure = new Mannequin({ names: joints.map((joint) => joint.name), parents: Int32Array.from(joints, (joint) => joint.parent) });
  const size = 3 * joints.length;
  return {
    group: figure.group,
    frames,
    places: (frame) => positions.subarray(size * frame, size * (frame + 1)),
    show: (places) => figure.setPose(places),
  };
}

function drawStrip({ group, frames, places, show }: Figure): string {
  const first = mostTelling(frames, places);
  const moments = Array.from({ length: FRAMES }, (_, k) => onTheSpot(places((first + Math.round((k * frames) / FRAMES)) % frames)));
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, stencil: true });
  renderer.toneMapping = NeutralToneMapping;
  renderer.setSize(4 * PIXELS, 4 * PIXELS, false); // finer, then averaged
  const lights = new Lights();
  lights.setDark(false);
  const scene = new Scene();
  scene.add(lights.group, group);
  const camera = aimedAt(moments);
  const canvas = document.createElement("canvas");
  canvas.width = FRAMES * PIXELS;
  canvas.height = PIXELS;
  const context = canvas.getContext("2d")!;
  context.imageSmoothingQuality = "high";
  moments.forEach((moment, k) => {
    show(moment);
    renderer.render(scene, camera);
    context.drawImage(renderer.domElement, k * PIXELS, 0, PIXELS, PIXELS);
  });
  coarsenEdges(context);
  return lightEnough(canvas);
}

/** WebP keeps how clear each pixel is without loss, and as many bytes as for all else: nine steps look the same. */
function coarsenEdges(context: CanvasRenderingContext2D): void {
  const image = context.getImageData(0, 0, context.canvas.width, context.canvas.height);
  for (let i = 3; i < image.data.length; i += 4) image.data[i] = (Math.round((image.data[i]! * 8) / 255) * 255) / 8;
  context.putImageData(image, 0, 0);
}

/** As good as the bytes allow. */
function lightEnough(canvas: HTMLCanvasElement): string {
  for (let quality = 0.86; quality > 0.2; quality -= 0.04) {
    const url = canvas.toDataURL("image/webp", quality);
    if (0.75 * url.length <= BYTES) return url;
  }
  throw new Error(`The strip takes more than ${BYTES} bytes.`);
}

/** Without its travel over the ground. */
function onTheSpot(places: Float32Array): Float32Array {
  const [x, z] = [0, 2].map((axis) => mean(places, axis));
  return places.map((value, i) => value - (i % 3 === 0 ? x! : i % 3 === 2 ? z! : 0));
}

function mean(places: Float32Array, axis: number): number {
  let sum = 0;
  for (let i = axis; i < places.length; i += 3) sum += places[i]!;
  return (3 * sum) / places.length;
}

/** The frame that differs most from the mean of all: it stands for the motion while nothing moves. */
function mostTelling(frames: number, places: (frame: number) => Float32Array): number {
  const all = Array.from({ length: frames }, (_, frame) => onTheSpot(places(frame)));
  const middle = all[0]!.map((_, i) => all.reduce((sum, one) => sum + one[i]!, 0) / frames);
  const strangeness = all.map((one) => one.reduce((sum, value, i) => sum + (value - middle[i]!) ** 2, 0));
  return strangeness.indexOf(Math.max(...strangeness));
}

/** From the stage's side, so that every moment fits. */
function aimedAt(moments: readonly Float32Array[]): PerspectiveCamera {
  const box = new Box3();
  for (const moment of moments) box.union(new Box3().setFromArray(moment));
  const size = box.getSize(new Vector3());
  const half = 0.5 * Math.max(size.y + 0.25, size.x + 0.2, 0.8 * size.z + 0.2);
  const centre = box.getCenter(new Vector3());
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 50);
  const distance = half / Math.tan((FIELD_OF_VIEW * Math.PI) / 360) + 0.4 * size.z;
  camera.position.setFromSphericalCoords(distance, Math.PI / 2 - 0.1, AZIMUTH + 0.4).add(centre);
  camera.lookAt(centre);
  return camera;
}
