// The model: one shape, its clay or its own colours, and the ghost behind it.

import {
  BufferAttribute,
  DoubleSide,
  Group,
  Mesh,
  MeshStandardMaterial,
  RepeatWrapping,
  ReplaceStencilOp,
  SRGBColorSpace,
  Texture,
} from "three";
import { Ghost } from "./ghost";
import { buildTopology, type Topology } from "./normals";
import { Shape } from "./shape";
import type { Theme } from "./theme";
import type { DrawnModel } from "../stage/port";

const CLAY = "#e4d2bf";

export class ModelFigure {
  readonly group = new Group();
  readonly material: MeshStandardMaterial;
  /** V x 3, rest, stage metres. */
  readonly rest: Float32Array;
  /** V x 3, what is drawn now. */
  vertices: Float32Array;
  private readonly topology: Topology;
  private readonly shape: Shape;
  private ghost: Ghost | null = null;
  private readonly texture: Texture | null;

  constructor(readonly model: DrawnModel) {
    this.topology = buildTopology(model.positions, model.index, model.toVertex);
    this.rest = restVertices(model);
    this.vertices = this.rest;
    this.texture = model.texture && model.uvs ? pictureTexture(model.texture) : null;
    this.material = new MeshStandardMaterial({
      color: this.texture || model.colors ? "#ffffff" : CLAY,
      map: this.texture,
      vertexColors: model.colors !== null,
      roughness: 0.8,
      metalness: 0,
      side: DoubleSide,
      stencilWrite: true, // marks its pixels, so that the ghost stays behind
      stencilRef: 1,
      stencilZPass: ReplaceStencilOp,
    });
    this.shape = this.newShape();
    this.shape.write(this.rest);
    const mesh = new Mesh(this.shape.geometry, this.material);
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    this.group.add(mesh);
  }

  setVertices(vertices: Float32Array): void {
    this.vertices = vertices;
    this.shape.write(vertices);
  }

  setGhost(vertices: Float32Array | null, theme: Theme): void {
    if (vertices && !this.ghost) {
      this.ghost = new Ghost(new Shape(this.topology));
      this.ghost.setTheme(theme);
      this.group.add(this.ghost.group);
    }
    if (this.ghost) {
      this.ghost.group.visible = vertices !== null;
      if (vertices) this.ghost.shape.write(vertices);
    }
  }

  setTheme(theme: Theme): void {
    this.ghost?.setTheme(theme);
  }

  setViewSize(width: number, height: number): void {
    this.ghost?.setViewSize(width, height);
  }

  /** A second surface with the model's colours, for thumbnails. */
  newShape(): Shape {
    const shape = new Shape(this.topology);
    const { colors, uvs } = this.model;
    if (colors) shape.geometry.setAttribute("color", pick(colors, 3, this.topology.source));
    if (uvs) shape.geometry.setAttribute("uv", pick(uvs, 2, this.topology.source));
    return shape;
  }

  dispose(): void {
    this.shape.dispose();
    this.ghost?.dispose();
    this.material.dispose();
    this.texture?.dispose();
  }
}

function restVertices(model: DrawnModel): Float32Array {
  const count = model.toVertex.reduce((most, v) => Math.max(most, v), -1) + 1;
  const rest = new Float32Array(3 * count);
  model.toVertex.forEach((v, r) => rest.set(model.positions.subarray(3 * r, 3 * r + 3), 3 * v));
  return rest;
}

function pick(values: Float32Array, size: number, source: Uint32Array): BufferAttribute {
  const out = new Float32Array(size * source.length);
  source.forEach((r, i) => out.set(values.subarray(size * r, size * (r + 1)), size * i));
  return new BufferAttribute(out, size);
}

/** glTF's convention: v = 0 is the top row, so nothing is flipped. */
function pictureTexture(picture: ImageBitmap): Texture {
  const texture = new Texture(picture);
  texture.colorSpace = SRGBColorSpace;
  texture.flipY = false;
  texture.anisotropy = 4;
  texture.wrapS = texture.wrapT = RepeatWrapping; // glTF's default
  texture.needsUpdate = true;
  return texture;
}
