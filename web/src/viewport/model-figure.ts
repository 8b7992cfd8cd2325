// The model: a mesh for each instance of its document, and the ghost behind it.

import { BufferAttribute, Group, type InterleavedBufferAttribute, Mesh, MeshStandardMaterial } from "three";
import { bindNormals, type NormalBinding } from "../gltf/surface-normals";
import type { DrawnModel } from "../stage/port";
import { Ghost } from "./ghost";
import type { Look } from "./look";
import { Shape } from "./shape";
import type { Theme } from "./theme";

const CLAY = "#e4d2bf";

export class ModelFigure {
  readonly group = new Group();
  /** By instance of the model: its render vertices begin at the instance's `first`. Not seen before they have a look. */
  readonly meshes: readonly Mesh[];
  /** V x 3, rest, stage metres. */
  readonly rest: Float32Array;
  /** V x 3, what is drawn now. */
  vertices: Float32Array;
  private readonly normals: NormalBinding;
  private readonly shape: Shape;
  private readonly bodies = new Group();
  private ghost: Ghost | null = null;
  private look: Look | null = null;

  constructor(readonly model: DrawnModel) {
    this.rest = restVertices(model);
    this.vertices = this.rest;
    this.normals = bindNormals(this.rest, model);
    this.shape = new Shape(model, this.normals);
    this.meshes = this.shape.geometries.map((geometry) => {
      const mesh = new Mesh(geometry);
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      return mesh;
    });
    this.bodies.visible = false;
    this.bodies.add(...this.meshes);
    this.group.add(this.bodies);
  }

  /** Shows the model as its file says; as clay where nobody could tell how it looks. */
  dress(look: Look | null): void {
    this.look = look;
    const clay = look ? null : new MeshStandardMaterial({ color: CLAY, roughness: 0.8, metalness: 0, side: 2 });
    this.meshes.forEach((mesh, i) => {
      mesh.material = look?.materials[i] ?? clay ?? mesh.material;
      this.lay(mesh, i);
    });
    this.bodies.visible = true;
  }

  setVertices(vertices: Float32Array): void {
    this.vertices = vertices;
    this.shape.write(vertices);
  }

  setGhost(vertices: Float32Array | null, theme: Theme): void {
    if (vertices && !this.ghost) {
      this.ghost = new Ghost(this.model.faces);
      this.ghost.setTheme(theme);
      this.group.add(this.ghost.group);
    }
    if (this.ghost) {
      this.ghost.group.visible = vertices !== null;
      if (vertices) this.ghost.write(vertices);
    }
  }

  setTheme(theme: Theme): void {
    this.ghost?.setTheme(theme);
  }

  setViewSize(width: number, height: number): void {
    this.ghost?.setViewSize(width, height);
  }

  /** A second surface that looks as the first does now, for thumbnails. */
  copy(): { shape: Shape; meshes: Mesh[] } {
    const shape = new Shape(this.model, this.normals);
    const meshes = shape.geometries.map((geometry, i) => {
      const mesh = this.lay(new Mesh(geometry, this.meshes[i]!.material), i);
      mesh.frustumCulled = false;
      return mesh;
    });
    return { shape, meshes };
  }

  dispose(): void {
    this.shape.dispose();
    this.ghost?.dispose();
    this.look?.dispose();
  }

  /** Lays colours and pictures' places on a mesh's vertices. */
  private lay(mesh: Mesh, instance: number): Mesh {
    const { vertices } = this.model.instances[instance]!;
    for (const [name, attribute] of Object.entries(this.look?.attributes[instance] ?? {})) {
      mesh.geometry.setAttribute(name, vertices ? picked(attribute, vertices) : attribute);
    }
    return mesh;
  }
}

function restVertices(model: DrawnModel): Float32Array {
  const count = model.toVertex.reduce((most, v) => Math.max(most, v), -1) + 1;
  const rest = new Float32Array(3 * count);
  model.toVertex.forEach((v, r) => rest.set(model.positions.subarray(3 * r, 3 * r + 3), 3 * v));
  return rest;
}

/** An attribute of some of the vertices. */
function picked(attribute: BufferAttribute | InterleavedBufferAttribute, vertices: Uint32Array): BufferAttribute {
  const { itemSize } = attribute;
  const out = new Float32Array(itemSize * vertices.length);
  vertices.forEach((v, i) => {
    for (let k = 0; k < itemSize; k++) out[itemSize * i + k] = attribute.getComponent(v, k);
  });
  return new BufferAttribute(out, itemSize);
}
