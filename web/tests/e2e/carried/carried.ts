// A character's dance by the real engine, its vertices as the core carries them and as the graphics card does.

import {
  BufferGeometry,
  Camera,
  FloatType,
  Mesh,
  MeshStandardMaterial,
  NearestFilter,
  PerspectiveCamera,
  PlaneGeometry,
  Points,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  VSMShadowMap,
  WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import { drawnModel } from "../../../src/app/drawn-model";
import { parseProject } from "../../../src/document/project";
import type { ProjectDocument } from "../../../src/document/types";
import { createBrowserEngine } from "../../../src/engine/browser";
import { readModel } from "../../../src/io/read-model";
import { Workspace } from "../../../src/sync/workspace";
import { carryVertices } from "../../../src/util/solid-cells";
import type { Body } from "../../../src/viewport/body";
import { CarriedBody } from "../../../src/viewport/carried-body";
import { Lights } from "../../../src/viewport/lights";
import { VertexBody } from "../../../src/viewport/vertex-body";

/** Of all vertices in some frames of a dance. */
export interface Carried {
  vertices: number;
  nodes: number;
  /** Numbers of one frame. */
  numbers: number;
  /** How far the card's places are from the core's, at most, and how far those are from rest; in metres. */
  apart: number;
  moved: number;
  /** Of some vertices, in degrees: how far the card's normals are from those that the map's gradient turns, and these from rest. */
  tilted: number;
  turned: number;
  /** Share of a picture, in the sun and with its shadow, that is seen to differ from that of the core's vertices; and from rest. */
  odd: number;
  other: number;
}

declare global {
  interface Window {
    carried: (character: string, motion: string, frames: number[]) => Promise<Carried>;
  }
}

window.carried = async (character, motion, frames) => {
  const folder = `/assets/characters/${character}/`;
  const { document: parsed } = parseProject(await (await fetch(`${folder}project.json`)).text(), "project.json");
  const name = `${character}.glb`;
  const model = await readModel([{ name, bytes: new Uint8Array(await (await fetch(folder + name)).arrayBuffer()) }]);
  let document: ProjectDocument = parsed;
  const workspace = new Workspace(() => document, createBrowserEngine);
  const file = workspace.library.addModel(name, model);
  const text = await (await fetch(`/assets/motions/${motion}`)).text();
  const files = workspace.library.addMotion([motion], { name: motion, text });
  document = { ...parsed, mesh: { ...parsed.mesh, file, solve: "solid" }, motion: { files } };
  const core = await workspace.vertexFrames({});
  await workspace.sync();
  const solid = workspace.report?.solid;
  if (!solid) throw new Error("No solid was solved.");

  const drawn = drawnModel(model, document.mesh, solid);
  const body = new CarriedBody(drawn, solid);
  const renderer = new WebGLRenderer();
  const found: Carried = {
    vertices: drawn.rest.length / 3,
    nodes: solid.nodes.length / 3,
    numbers: workspace.cache.at(0)!.shape.length,
    apart: 0,
    moved: 0,
    tilted: 0,
    turned: 0,
    odd: 0,
    other: 0,
  };
  for (const frame of frames) {
    const maps = workspace.cache.at(frame)!.shape;
    body.write(maps);
    const { positions } = core[frame]!;
    drawn.instances.forEach(({ first, count, flat }, i) => {
      const places = drawnOn(renderer, body, i, count, "transformed");
      const normals = flat ? null : drawnOn(renderer, body, i, count, "objectNormal");
      for (let k = 0; k < count; k++) {
        const v = drawn.toVertex[first + k]!;
        const place = positions.subarray(3 * v, 3 * v + 3);
        found.apart = Math.max(found.apart, distance(places.subarray(4 * k), place));
        found.moved = Math.max(found.moved, distance(drawn.rest.subarray(3 * v), place));
        if (!normals || k % 8 > 0) continue;
        const rest = drawn.normals.subarray(3 * (first + k), 3 * (first + k) + 3);
        const turned = turnedNormal(v, rest, maps);
        found.tilted = Math.max(found.tilted, degrees(normals.subarray(4 * k), turned));
        found.turned = Math.max(found.turned, degrees(rest, turned));
      }
    });
  }
  workspace.close();
  const last = frames.at(-1)!;
  const picture = inTheSun(body, workspace.cache.at(last)!.shape);
  const told = new VertexBody({ ...drawn, solid: null });
  found.odd = differing(picture, inTheSun(told, core[last]!.positions));
  found.other = differing(picture, inTheSun(told, told.rest));
  return found;

  /** By differences of where the core's formula carries what is around the vertex; it and they lie in one element. */
  function turnedNormal(v: number, normal: ArrayLike<number>, maps: Float32Array): Float64Array {
    const step = 1e-3 * solid!.cell;
    const columns = [0, 1, 2].map((axis) => {
      const [ahead, behind] = [1, -1].map((way) => {
        const near = drawn.rest.slice(3 * v, 3 * v + 3);
        near[axis] = clamped(v, axis, near[axis]! + way * step);
        const out = new Float32Array(3);
        carryVertices({ ...solid!, elementOf: solid!.elementOf.slice(v, v + 1) }, near, maps, [0], out);
        return { at: near[axis]!, out };
      });
      return [0, 1, 2].map((k) => (ahead!.out[k]! - behind!.out[k]!) / (ahead!.at - behind!.at));
    });
    const cofactors = [0, 1, 2].map((a) => cross(columns[(a + 1) % 3]!, columns[(a + 2) % 3]!));
    return Float64Array.from([0, 1, 2], (k) => cofactors.reduce((sum, column, a) => sum + column[k]! * normal[a]!, 0));
  }

  function clamped(v: number, axis: number, x: number): number {
    const low = solid!.nodes[3 * solid!.elements[8 * solid!.elementOf[v]!]! + axis]!;
    return Math.min(Math.max(x, low), low + solid!.cell);
  }
};

/** Count x 4: what the vertex shader has made of a variable of three's, one pixel for each vertex. */
function drawnOn(renderer: WebGLRenderer, body: CarriedBody, instance: number, count: number, variable: string): Float32Array {
  const width = 256;
  const height = Math.ceil(count / width);
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(body.geometries[instance]!.attributes)) geometry.setAttribute(name, attribute);
  const material = new ShaderMaterial({
    vertexShader: `
      varying vec3 value;
      void main() {
        #include <beginnormal_vertex>
        #include <begin_vertex>
        value = ${variable};
        vec2 pixel = vec2(gl_VertexID % ${width}, gl_VertexID / ${width}) + 0.5;
        gl_Position = vec4(2.0 * pixel / vec2(${width}, ${height}) - 1.0, 0.0, 1.0);
        gl_PointSize = 1.0;
      }`,
    fragmentShader: "varying vec3 value; void main() { gl_FragColor = vec4(value, 1.0); }",
    depthTest: false,
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  body.dress(points as unknown as Mesh);
  const target = new WebGLRenderTarget(width, height, {
    type: FloatType,
    format: RGBAFormat,
    depthBuffer: false,
    minFilter: NearestFilter,
  });
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(new Scene().add(points), new Camera());
  const out = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, out);
  target.dispose();
  material.dispose();
  return out;
}

/** The pixels of a shape on a floor that catches its shadow. */
function inTheSun(body: Body, shape: Float32Array): Uint8Array {
  const [width, height] = [400, 320];
  const renderer = new WebGLRenderer();
  renderer.setSize(width, height, false);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = VSMShadowMap;
  const lights = new Lights();
  lights.setDark(false);
  lights.setShadow({ shadowMap: 512, blurSamples: 6, maxPixelRatio: 1 });
  lights.fitShadow(4, 2.4, 3);
  const floor = new Mesh(new PlaneGeometry(6, 6).rotateX(-Math.PI / 2), new MeshStandardMaterial());
  floor.receiveShadow = true;
  const scene = new Scene().add(lights.group, floor);
  for (const geometry of body.geometries) {
    const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: "#cc9966" }));
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    body.dress(mesh);
    scene.add(mesh);
  }
  body.write(shape);
  const camera = new PerspectiveCamera(36, width / height, 0.1, 50);
  camera.position.set(1, 2.2, 5);
  camera.lookAt(0, 0.7, 0);
  renderer.render(scene, camera);
  const pixels = new Uint8Array(4 * width * height);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

function differing(a: Uint8Array, b: Uint8Array): number {
  return a.filter((value, i) => Math.abs(value - b[i]!) > 12).length / a.length;
}

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}

function cross(a: ArrayLike<number>, b: ArrayLike<number>): number[] {
  return [0, 1, 2].map((k) => a[(k + 1) % 3]! * b[(k + 2) % 3]! - a[(k + 2) % 3]! * b[(k + 1) % 3]!);
}

/** Between two directions; exact where they are near. */
function degrees(a: ArrayLike<number>, b: ArrayLike<number>): number {
  const dot = a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
  return (Math.atan2(Math.hypot(...cross(a, b)), dot) * 180) / Math.PI;
}
