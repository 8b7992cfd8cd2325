// The model: a mesh for each instance of its document, and the ghost behind it.

import { BufferAttribute, Group, type InterleavedBufferAttribute, Mesh, MeshStandardMaterial } from "three";
import type { DrawnModel, Shape } from "../stage/port";
import type { Body } from "./body";
import { Ghost } from "./ghost";
import type { Look } from "./look";
import type { Theme } from "./theme";

const CLAY = "#e4d2bf";

export class ModelFigure {
  readonly group = new Group();
  /** By instance of the model: its render vertices begin at the instance's `first`. Not seen before they have a look. */
  readonly meshes: readonly Mesh[];
  /** What is drawn now. */
  shape: Shape;
  readonly bodies = new Group();
  private readonly place = new Float32Array(3);
  private ghost: Ghost | null = null;
  private look: Look | null = null;

  constructor(
    readonly model: DrawnModel,
    readonly body: Body,
  ) {
    this.shape = this.body.rest;
    this.meshes = this.body.geometries.map((geometry) => {
      const mesh = new Mesh(geometry);
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      return mesh;
    });
    this.bodies.visible = false;
    this.bodies.add(...this.meshes);
    this.group.add(this.bodies);
  }

  /** Wide enough for what is drawn to turn a little. */
  get width(): number {
    const places = this.body.outline(this.shape);
    const extent = (axis: number): number => {
      let low = Infinity;
      let high = -Infinity;
      for (let i = axis; i < places.length; i += 3) {
        low = Math.min(low, places[i]!);
        high = Math.max(high, places[i]!);
      }
      return Math.max(0, high - low);
    };
    return Math.max(0.6, extent(0), 0.8 * extent(2));
  }

  /** How the model looks, as its file says; clay where nobody could tell. */
  dress(look: Look | null): void {
    this.look = look;
    const clay = look ? null : new MeshStandardMaterial({ color: CLAY, roughness: 0.8, metalness: 0, side: 2 });
    this.meshes.forEach((mesh, i) => {
      mesh.material = look?.materials[i] ?? clay ?? mesh.material;
      this.lay(mesh, i);
      this.body.dress(mesh);
    });
  }

  show(): void {
    this.bodies.visible = true;
  }

  setShape(shape: Shape): void {
    this.shape = shape;
    this.body.write(shape);
  }

  /** Where a vertex is in a shape, by default that which is drawn; three numbers, kept until the next call. */
  vertex(vertex: number, shape = this.shape): Float32Array {
    this.body.places(shape, [vertex], this.place);
    return this.place;
  }

  setGhost(shape: Shape | null, theme: Theme): void {
    if (shape && !this.ghost) {
      this.ghost = new Ghost(this.body.ghost());
      this.ghost.setTheme(theme);
      this.group.add(this.ghost.group);
    }
    if (this.ghost) {
      this.ghost.group.visible = shape !== null;
      if (shape) this.ghost.write(shape);
    }
  }

  setTheme(theme: Theme): void {
    this.ghost?.setTheme(theme);
  }

  setViewSize(width: number, height: number): void {
    this.ghost?.setViewSize(width, height);
  }

  /** The same once more, for thumbnails: it looks and stands as this one does. */
  copy(): Mesh[] {
    return this.meshes.map(({ geometry, material }) => {
      const mesh = new Mesh(geometry, material);
      mesh.frustumCulled = false;
      return mesh;
    });
  }

  dispose(): void {
    this.body.dispose();
    this.ghost?.dispose();
    this.look?.dispose();
  }

  /** Lays colours and pictures' places on a mesh's vertices. */
  private lay(mesh: Mesh, instance: number): void {
    const { vertices } = this.model.instances[instance]!;
    for (const [name, attribute] of Object.entries(this.look?.attributes[instance] ?? {})) {
      mesh.geometry.setAttribute(name, vertices ? picked(attribute, vertices) : attribute);
    }
  }
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

/** Nobody could tell how the model looks: better seen as clay than not at all. */
export function clay(error: unknown): null {
  console.warn(error);
  return null;
}
